// Kernels that are made when they are first asked for.
#pragma once

#include "gpu/context.h"
#include "gpu/made_once.h"
#include "gpu/pipeline/kernel.h"

namespace seaglass::gpu {

/// For Context::share(): one or more kernels for each key, as `build` makes them.
template<typename Key, typename Kernels, Status (*build)(const Device&, const Key&, Kernels&)>
class KernelCache {
  public:
    Status create(Context& context) {
        device_ = &context.device;
        return Status::ok;
    }
    /// Any thread.
    Status get(const Key& key, const Kernels*& out) {
        return kernels_.get(
            key, [&](Kernels& kernels) { return build(*device_, key, kernels); }, out);
    }

  private:
    const Device* device_ = nullptr;
    MadeOnce<Key, Kernels> kernels_;
};

} // namespace seaglass::gpu
