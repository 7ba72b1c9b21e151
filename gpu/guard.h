// What every call of the API does first, and what it lets out.
#pragma once

#include <initializer_list>
#include <new>

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

/// The same of an array's objects.
template<typename Object>
Status refuseNulls(const char* call, const char* name, Object* const* objects, uint32_t count) {
    const Context* context = contextOf(objects, count);
    for (uint32_t i = 0; i < count; ++i)
        if (!objects[i])
            return context
                       ? context->device.fail(Status::invalidArgument, "%s: %s[%u] is null", call, name, i)
                       : Status::invalidArgument;
    return Status::ok;
}

} // namespace seaglass::gpu
