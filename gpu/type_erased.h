// Objects whose holders do not know their type: parts of bodies, what techniques keep, kernels that bodies
// share, what retires. Standard pointers would be compiled anew for each type; these are compiled once.
#pragma once

#include <memory>
#include <utility>

namespace seaglass::gpu {

using Erased = std::unique_ptr<void, void (*)(void* object)>;

template<typename T>
void destroyErased(void* object) {
    delete static_cast<T*>(object);
}

template<typename T, typename... Arguments>
Erased makeErased(Arguments&&... arguments) {
    return {new T(std::forward<Arguments>(arguments)...), destroyErased<T>};
}

std::shared_ptr<void> shared(Erased object);

/// Puts a fresh T where its holder has it, to be created in place.
template<typename T>
T& makeShared(std::shared_ptr<void>& out) {
    out = shared(makeErased<T>());
    return *static_cast<T*>(out.get());
}

} // namespace seaglass::gpu
