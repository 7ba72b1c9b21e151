// The lit opaque meshes and the sky behind them.
#pragma once

#include "host/frame_targets.h"
#include "host/mesh.h"
#include "host/sky.h"

namespace demos {

class OpaquePass {
  public:
    bool create(const Device& device, const Layouts& layouts, Error& error);
    /// Clears and draws targets.color and targets.depth, and leaves them as attachments. Needs set 0 bound.
    void record(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes, const Camera& camera,
                const FrameTargets& targets) const;
    /// What draws the meshes alone, into attachments of the same formats.
    MeshPipelines meshPipelines(const glm::dmat4& clipFromEye) const {
        return {opaque_.get(), masked_.get(), true, 0, clipFromEye};
    }

  private:
    UniquePipeline opaque_, masked_;
    SkyPass sky_;
};

} // namespace demos
