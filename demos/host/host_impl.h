// What a Host is made of.
#pragma once

#include "host/host.h"
#include "host/vulkan/frame_recorder.h"

namespace demos {

struct Host::Impl {
    /// The first compiles pipelines on some drivers, the second settles memory.
    static constexpr uint32_t warmUps = 2;

    /// Records what becomes of the picture, which attachments wrote.
    using AfterFrame = std::function<void(VkCommandBuffer, const Image& picture)>;

    bool ready(Error& error) const;
    /// Draws one frame and waits for it: from submission to fence, and by timestamps, 0 where there are none.
    bool timeFrame(const FrameDesc& frame, double& fenceMs, double& gpuMs, Error& error);
    /// Draws one frame, then what `then` records, and waits for both.
    bool draw(const FrameDesc& frame, const AfterFrame& then, Error& error);

    HostDesc desc;
    // In this order, so that what is made from another goes before it.
    std::unique_ptr<Device> device;
    std::unique_ptr<FrameRecorder> recorder;
    std::unique_ptr<LoadedScene> scene;
};

} // namespace demos
