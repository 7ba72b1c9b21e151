// The opaque meshes once more, as Seaglass asks for them: from behind the mirror for a planar reflection, or
// under the water for refraction. No sky, which the surface knows by itself.
#pragma once

#include "host/camera.h"
#include "host/passes/opaque.h"
#include "host/vulkan/layouts.h"
#include "seaglass/reflection.h"

namespace demos {

/// Its camera, as the host draws: relative to the eye.
struct OtherEye {
    glm::dvec3 position{0};
    glm::dmat4 clipFromEye{1};
};

OtherEye otherEye(const seaglass::PlanarView& view);

/// A frame's uniforms for that eye; its shadows are those of the frame.
FrameUniforms otherUniforms(const FrameUniforms& frame, const Camera& camera, const OtherEye& eye);

/// Needs set 0 bound, with those uniforms. Leaves the view's images as Seaglass takes them over.
void recordSceneAgain(seaglass::Context* context, VkCommandBuffer commands, const Layouts& layouts,
                      const MeshSet& meshes, const OpaquePass& opaque, const OtherEye& eye,
                      const seaglass::PlanarView& view);

/// Shaders read the depth of a bed's picture from here on; then a pass over it. Between recordSceneAgain()
/// and what Seaglass does next.
void readBedDepth(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view);
void beginOverBed(VkCommandBuffer commands, const seaglass::PlanarView& view);
void endOverBed(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view);

} // namespace demos
