// The host's hold on Seaglass: one context, what it last said, and its frame slots in turn.
#pragma once

#include "host/vulkan/device.h"
#include "seaglass/reflection.h"

namespace demos {

class SeaglassContext {
  public:
    SeaglassContext() = default;
    SeaglassContext(const SeaglassContext&) = delete;
    SeaglassContext& operator=(const SeaglassContext&) = delete;
    ~SeaglassContext();

    /// `surface` is whose context it is, for errors: "water".
    bool create(Device& device, uint32_t framesInFlight, const char* surface, Error& error);
    bool exists() const { return context_ != nullptr; }
    seaglass::Context* get() const { return context_; }

    /// Before anything else is recorded for a frame.
    bool beginFrame(Error& error);
    /// What a reflection holds for one view of this size.
    bool estimate(const seaglass::ReflectionDesc& reflection, VkExtent2D extent, uint64_t& bytes,
                  Error& error);
    /// False with what Seaglass said where something failed.
    bool ok(seaglass::Status status, Error& error);

  private:
    seaglass::Context* context_ = nullptr;
    const char* surface_ = "";
    uint32_t framesInFlight_ = 1, slot_ = 0;
    std::string message_; ///< what Seaglass last said
};

} // namespace demos
