// What the host tells Seaglass of a frame and of a reflection, for whatever surface mirrors it.
#pragma once

#include "host/camera.h"
#include "host/passes/shadow.h"
#include "host/passes/sky.h"
#include "host/vulkan/frame_targets.h"
#include "seaglass/reflection.h"

namespace demos {

seaglass::ViewDesc viewOf(const Camera& camera, const FrameTargets& targets);
/// Of a picture that the host drew for Seaglass, while its depth is only read.
seaglass::ViewDesc viewOf(const seaglass::PlanarView& drawn);

/// Without shadows.
seaglass::LightingDesc lightingOf(const Sky& sky);

/// False where nothing throws any. What `out` holds is for this eye.
bool sunShadowOf(const ShadowPass& pass, const ShadowFits& fits, const glm::dvec3& eye,
                 seaglass::SunShadow& out);

/// The projection with something wrong about it.
glm::dmat4 mistaken(const glm::dmat4& projection, Mistake mistake);

/// Whether an output is drawn by the library, over no scene at all.
constexpr bool isOverlay(Aov aov) {
    return aov >= Aov::overlayDepth;
}

/// Into targets.overlay.
seaglass::OverlayDesc overlayOf(Aov aov, const FrameTargets& targets);

} // namespace demos
