// The opaque meshes once more, seen from behind the mirror, for a planar reflection. No sky: the surface
// mirrors that by itself.
#pragma once

#include "host/camera.h"
#include "host/layouts.h"
#include "host/opaque.h"
#include "seaglass/reflection.h"

namespace demos {

/// The camera behind the mirror, as the host draws: relative to the eye.
struct MirroredEye {
    glm::dvec3 position{0};
    glm::dmat4 clipFromEye{1};
};

MirroredEye mirroredEye(const seaglass::PlanarView& view);

/// A frame's uniforms for the mirrored eye; its shadows are those of the frame.
FrameUniforms mirroredUniforms(const FrameUniforms& frame, const Camera& camera, const MirroredEye& eye);

/// Needs set 0 bound, with those uniforms. Leaves the view's images as Seaglass takes them over.
void recordMirroredScene(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                         const OpaquePass& opaque, const MirroredEye& eye, const seaglass::PlanarView& view);

} // namespace demos
