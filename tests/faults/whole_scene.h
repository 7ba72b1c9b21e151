// A host that uses all that the library has, on a device that may fail: water with every part, mirrors of
// every technique, and what they are drawn into.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "seaglass/water.h"
#include "tests/body_parts.h"
#include "tests/faults/failing_device.h"

namespace tests {

/// A call of the library.
struct Step {
    const char* name;
    std::function<seaglass::Status()> call;
    bool creates = false; ///< and leaves nothing behind when it fails
    size_t again = 0;     ///< from which step on hosts go on when it failed: itself, or the frame's first
};

class WholeScene {
  public:
    /// Over a scene of so many samples a pixel.
    WholeScene(FailingDevice& device, seaglass::ReflectionTechnique technique, VkSampleCountFlagBits samples,
               const VkAllocationCallbacks* allocator = nullptr);
    ~WholeScene();
    WholeScene(const WholeScene&) = delete;
    WholeScene& operator=(const WholeScene&) = delete;

    /// Of a host's life, in their order: frames of two slots, of which the last two are larger.
    std::vector<Step> steps();
    /// Of those calls.
    const seaglass::BodyDesc& bodyDesc() const { return water_.desc; }
    const seaglass::LightingDesc& lighting() const { return lighting_; }
    const seaglass::ViewDesc& view(VkExtent2D extent);
    const std::string& message() const { return message_; }

  private:
    void describeWater(seaglass::ReflectionTechnique technique);
    void describeView(VkSampleCountFlagBits samples);
    void addFrame(std::vector<Step>& steps, uint32_t slot, double time, VkExtent2D extent);
    seaglass::Image image(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples);
    void setExtent(VkExtent2D extent);

    FailingDevice& device_;
    const VkAllocationCallbacks* allocator_;
    std::string message_;
    BodyParts water_;
    seaglass::SunShadow shadow_;
    seaglass::FogDesc fog_;
    seaglass::LightingDesc lighting_;
    seaglass::ViewDesc view_;
    seaglass::OverlayDesc overlay_;

    seaglass::Context* context_ = nullptr;
    seaglass::Target* target_ = nullptr;
    seaglass::Body* body_ = nullptr;
    seaglass::Reflector* reflector_ = nullptr;
};

} // namespace tests
