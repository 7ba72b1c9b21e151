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

  private:
    UniquePipeline opaque_, masked_;
    SkyPass sky_;
};

} // namespace demos
