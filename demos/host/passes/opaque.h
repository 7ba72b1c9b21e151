// The lit opaque meshes and the sky behind them.
#pragma once

#include "host/mesh.h"
#include "host/passes/sky.h"
#include "host/vulkan/frame_targets.h"

namespace demos {

class OpaquePass {
  public:
    bool create(const Device& device, const Layouts& layouts, Error& error);
    /// Makes what the materials of a scene want besides.
    bool prepare(const Device& device, const Layouts& layouts, const MeshSet& meshes, Error& error);
    /// Clears and draws targets.color and targets.depth, and leaves them as attachments. Needs set 0 bound.
    void record(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes, const Camera& camera,
                const FrameTargets& targets) const;
    /// What draws the meshes alone, into attachments of the same formats.
    MeshPipelines meshPipelines(const glm::dmat4& clipFromEye) const {
        return {&pipelines_, true, 0, clipFromEye};
    }

  private:
    FeaturePipelines pipelines_{~0u, {}};
    SkyPass sky_;
};

} // namespace demos
