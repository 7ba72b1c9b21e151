// A scene's fog as the host's own shaders have it: demos/host/shaders/air.glsl.
#pragma once

#include "host/camera.h"
#include "host/vulkan/layouts.h"
#include "host/water/bent_sun.h"

namespace demos {

/// For the eye of the frame. `water`: below whose plane there is no fog; null: none is there.
void setFogUniforms(const seaglass::FogDesc& fog, const Camera& camera, const BentSun* water,
                    FrameUniforms& uniforms);

/// For positions relative to another eye, `step` from the frame's: what it draws is seen by that of the
/// frame.
void moveFogUniforms(const glm::dvec3& step, FrameUniforms& uniforms);

} // namespace demos
