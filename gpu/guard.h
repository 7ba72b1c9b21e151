// What every call of the API does first, what it lets out, and how hosts come to hold things and let go.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <new>
#include <utility>

#include "gpu/context.h"

namespace seaglass::gpu {

/// No exception crosses the API: running out of memory inside becomes a status.
template<typename Call>
Status guarded(Call&& call) noexcept {
    try {
        return call();
    } catch (const std::bad_alloc&) {
        return Status::outOfHostMemory;
    }
}

struct Argument {
    const char* name;
    bool isNull;
};

/// Names the first argument that is null to whoever listens; where the context is null too, nobody does.
inline Status refuseNull(const Context* context, const char* call,
                         std::initializer_list<Argument> arguments) {
    for (const Argument& argument : arguments) {
        if (!argument.isNull) continue;
        return context ? context->device.fail(Status::invalidArgument, "%s: %s is null", call, argument.name)
                       : Status::invalidArgument;
    }
    return Status::ok;
}

/// Of the first object in an array that is not null.
template<typename Object>
const Context* contextOf(Object* const* objects, uint32_t count) {
    for (uint32_t i = 0; objects && i < count; ++i)
        if (objects[i]) return objects[i]->context;
    return nullptr;
}

/// Names an object that the host has destroyed, for as long as it is kept.
inline Status refuseDestroyed(const char* call, const char* name, const Held& held) {
    return held.destroyed ? held.context->device.misused("%s: %s was destroyed before", call, name)
                          : Status::ok;
}

/// The same of an array's objects, nulls too, and those that are there twice: recorded twice, they would draw
/// over themselves.
template<typename Object>
Status refuseUnusable(const char* call, const char* name, Object* const* objects, uint32_t count) {
    const Context* context = contextOf(objects, count);
    for (uint32_t i = 0; i < count; ++i) {
        if (!objects[i])
            return context
                       ? context->device.fail(Status::invalidArgument, "%s: %s[%u] is null", call, name, i)
                       : Status::invalidArgument;
        if (objects[i]->destroyed)
            return context->device.misused("%s: %s[%u] was destroyed before", call, name, i);
        if (const auto first = std::find(objects, objects + i, objects[i]); first != objects + i)
            return context->device.fail(Status::invalidArgument, "%s: %s[%u] is %s[%td] once more", call,
                                        name, i, name, first - objects);
    }
    return Status::ok;
}

/// Of calls that record: memory and descriptors come from a frame's slot.
inline Status refuseOutsideFrame(const Context* context, const char* call) {
    return context && context->frameNumber == 0
               ? context->device.misused("%s: beginFrame() was never called", call)
               : Status::ok;
}

/// What estimate() is asked about.
inline Status refuseExtent(const Context& context, VkExtent2D extent) {
    const uint32_t most = context.device.limits().maxImageDimension2D;
    if (extent.width == 0 || extent.height == 0)
        return context.device.fail(Status::invalidArgument, "estimate: the extent is empty");
    if (extent.width <= most && extent.height <= most) return Status::ok;
    return context.device.fail(Status::invalidArgument,
                               "estimate: the extent is %u x %u, the device's images have up to %u each way",
                               extent.width, extent.height, most);
}

/// What createBody() and its like do: `make` fills a new T, which is the host's if nothing fails.
template<typename T, typename Desc, typename Make>
Status createHeld(const char* call, Context* context, const Desc* desc, T** out, Make&& make) {
    if (out) *out = nullptr;
    if (const Status s = refuseNull(context, call, {{"context", !context}, {"desc", !desc}, {"out", !out}});
        s != Status::ok)
        return s;
    return guarded([&] {
        auto held = std::make_unique<T>();
        if (const Status s = make(*held); s != Status::ok) return s;
        *out = held.release();
        ++context->inUse;
        return Status::ok;
    });
}

/// What destroyBody() and its like do.
template<typename T>
void destroyHeld(const char* call, T* held) {
    if (!held) return;
    Context& context = *held->context;
    if (held->destroyed) {
        (void)context.device.misused("%s: it was destroyed before", call);
        return;
    }
    held->destroyed = true;
    --context.inUse;
    held->destroyedBefore = std::exchange(context.destroyed[context.slot], held);
    held->release = [](Held& destroyed) { delete static_cast<T*>(&destroyed); };
}

} // namespace seaglass::gpu
