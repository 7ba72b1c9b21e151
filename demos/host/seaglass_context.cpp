#include "host/seaglass_context.h"

#include <cstdio>

namespace demos {

SeaglassContext::~SeaglassContext() {
    if (context_) seaglass::destroyContext(context_);
}

bool SeaglassContext::create(Device& device, uint32_t framesInFlight, const char* surface, Error& error) {
    surface_ = surface;
    framesInFlight_ = framesInFlight;
    seaglass::DeviceDesc desc;
    desc.instance = device.instance();
    desc.physicalDevice = device.physical();
    desc.device = device.handle();
    desc.getInstanceProcAddr = vkGetInstanceProcAddr;
    desc.framesInFlight = framesInFlight_;
    desc.message.user = &message_;
    desc.message.function = [](void* user, const char* text) { *static_cast<std::string*>(user) = text; };
    desc.pass.user = &device.passes();
    desc.pass.function = [](void* user, VkCommandBuffer commands, const char* pass, bool begins) {
        static_cast<PassTimer*>(user)->mark(commands, pass, begins);
    };
    return ok(seaglass::createContext(&desc, &context_), error);
}

bool SeaglassContext::beginFrame(Error& error) {
    slot_ = (slot_ + 1) % framesInFlight_;
    return ok(seaglass::beginFrame(context_, slot_), error);
}

bool SeaglassContext::estimate(const seaglass::ReflectionDesc& reflection, VkExtent2D extent, uint64_t& bytes,
                               Error& error) {
    seaglass::Estimate estimate;
    if (!ok(seaglass::estimate(context_, &reflection, extent, &estimate), error)) return false;
    bytes = estimate.bytes + estimate.bytesPerView;
    return true;
}

bool SeaglassContext::ok(seaglass::Status status, Error& error) {
    if (status == seaglass::Status::ok) {
        if (!message_.empty()) std::fprintf(stderr, "warning: %s: %s\n", surface_, message_.c_str());
        message_.clear();
        return true;
    }
    error.text = std::string(surface_) + ": " + (message_.empty() ? seaglass::toString(status) : message_);
    message_.clear();
    return false;
}

} // namespace demos
