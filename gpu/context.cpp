#include "gpu/context.h"

#include <new>

#include "gpu/interface/fields/host.h"

namespace seaglass {

const char* toString(Status status) {
    switch (status) {
    case Status::ok:
        return "ok";
    case Status::invalidArgument:
        return "invalid argument";
    case Status::unsupported:
        return "unsupported";
    case Status::outOfHostMemory:
        return "out of host memory";
    case Status::outOfDeviceMemory:
        return "out of device memory";
    case Status::deviceLost:
        return "device lost";
    case Status::vulkanError:
        return "Vulkan error";
    }
    return "unknown status";
}

uint32_t version() {
    return SEAGLASS_VERSION;
}

namespace {

/// Until 1.0 any minor version may change a struct (SemVer).
bool sameInterface(uint32_t headers) {
    return headers >> 12u == version() >> 12u;
}

static_assert(deviceFieldRows[0].high == std::tuple_size_v<decltype(Context::frames)>);

} // namespace

FieldError badField(const DeviceDesc& desc) {
    if (!desc.instance) return "DeviceDesc.instance is null";
    if (!desc.physicalDevice) return "DeviceDesc.physicalDevice is null";
    if (!desc.device) return "DeviceDesc.device is null";
    if (!desc.getInstanceProcAddr) return "DeviceDesc.getInstanceProcAddr is null";
    if (!desc.memory.allocate != !desc.memory.release)
        return "DeviceDesc.memory has one of allocate and release, expected both or none";
    return badField(deviceFields, &desc);
}

Status Context::shareMade(Shared how, const void* what,
                          Status (*make)(Context& context, std::shared_ptr<void>& out),
                          std::shared_ptr<void>& out) {
    const std::lock_guard sharing(sharing_);
    std::weak_ptr<void>& known = shared_[what];
    out = known.lock();
    if (out) return Status::ok;
    const Status status = make(*this, out);
    if (status != Status::ok) out.reset();
    known = out;
    if (out && how == Shared::kept) kept_.push_back(out);
    return status;
}

void Context::releaseDestroyed(uint32_t ofSlot) {
    for (Held* held = std::exchange(destroyed[ofSlot], nullptr); held;) {
        Held& last = *held;
        held = last.destroyedBefore;
        last.release(last);
    }
}

Status createContext(const DeviceDesc* desc, Context** out) {
    if (out) *out = nullptr;
    if (!desc) return Status::invalidArgument;
    // Nothing behind the version may be read where it is another: the struct itself may differ.
    if (!sameInterface(desc->headerVersion)) return Status::unsupported;
    if (const FieldError bad = out ? badField(*desc) : FieldError("createContext: out is null")) {
        if (desc->message.function) desc->message.function(desc->message.user, bad.text());
        return Status::invalidArgument;
    }
    if (const Status s =
            checkSupport(desc->instance, desc->physicalDevice, desc->getInstanceProcAddr, desc->message);
        s != Status::ok)
        return s;
    std::unique_ptr<Context> context(new (std::nothrow) Context);
    if (!context) return Status::outOfHostMemory;
    if (const Status s = context->device.init(*desc); s != Status::ok) return s;
    if (const Status s = context->samplers.create(context->device); s != Status::ok) return s;
    context->frameCount = desc->framesInFlight;
    for (gpu::Frame& frame : context->frames) frame.init(context->device);
    *out = context.release();
    return Status::ok;
}

void destroyContext(Context* context) {
    if (!context) return;
    if (context->inUse > 0) {
        (void)context->device.misused(
            "destroyContext: bodies, reflectors or targets of the context exist, which are "
            "destroyed before it; nothing was done");
        return;
    }
    // Retired objects may share pipelines, which need the device: let go of them first.
    for (uint32_t slot = 0; slot < context->frames.size(); ++slot) {
        context->frames[slot].releaseRetired();
        context->releaseDestroyed(slot);
    }
    delete context;
}

Status beginFrame(Context* context, uint32_t slot) {
    if (!context) return Status::invalidArgument;
    if (slot >= context->frameCount)
        return context->device.misused("beginFrame: slot is %u, expected 0 to %u", slot,
                                       context->frameCount - 1);
    context->slot = slot;
    ++context->frameNumber;
    const Status s = context->frame().begin();
    if (s == Status::ok) context->releaseDestroyed(slot);
    return s;
}

} // namespace seaglass
