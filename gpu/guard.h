// No exception crosses the API: running out of memory inside becomes a status.
#pragma once

#include <new>

#include "seaglass/host.h"

namespace seaglass::gpu {

template<typename Call>
Status guarded(Call&& call) noexcept {
    try {
        return call();
    } catch (const std::bad_alloc&) {
        return Status::outOfHostMemory;
    }
}

} // namespace seaglass::gpu
