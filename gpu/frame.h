// What lives for one frame slot: descriptor sets, mapped memory, and objects that the GPU may still be using.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "gpu/memory/buffer.h"
#include "gpu/pipeline/binding.h"
#include "gpu/type_erased.h"

namespace seaglass::gpu {

/// A piece of mapped memory, valid until the slot begins again.
struct Slice {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    VkDeviceSize size = 0;
    void* data = nullptr;
};

inline Resource uniformBuffer(const Slice& slice) {
    return uniformBuffer(slice.buffer, slice.offset, slice.size);
}
inline Resource storageBuffer(const Slice& slice) {
    return storageBuffer(slice.buffer, slice.offset, slice.size);
}

class Frame {
  public:
    Frame() = default;
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    void init(const Device& device) { device_ = &device; }
    /// Takes back everything handed out and lets go of retired objects.
    Status begin();

    /// Takes what Layout::check() takes, in any order; what no shader declares is left out.
    Status allocateSet(const Layout& layout, std::span<const Bound> resources, VkDescriptorSet& out);
    /// Uniform or storage memory, written by the CPU.
    Status allocate(VkDeviceSize size, Slice& out);
    /// A uniform block of shaders/shared.
    template<typename T>
    Status upload(const T& block, Slice& out) {
        static_assert(sizeof block % 16 == 0, "std140 fills up to sixteen bytes: pads are written out");
        if (const Status s = allocate(sizeof block, out); s != Status::ok) return s;
        std::memcpy(out.data, &block, sizeof block);
        return Status::ok;
    }

    /// Arrays that follow on each other, for a storage buffer.
    template<typename... Arrays>
    Status uploadInRow(Resource& out, const Arrays&... arrays) {
        Slice slice;
        const size_t bytes = (std::as_bytes(std::span(arrays)).size() + ...);
        if (const Status s = allocate(bytes, slice); s != Status::ok) return s;
        auto* data = static_cast<std::byte*>(slice.data);
        ((data = std::ranges::copy(std::as_bytes(std::span(arrays)), data).out), ...);
        out = storageBuffer(slice);
        return Status::ok;
    }

    /// Keeps a movable object alive until this slot begins again. Throws before it takes it.
    template<typename T>
    void retire(T&& object) {
        Erased& place = keptNext();
        place = makeErased<std::decay_t<T>>(std::forward<T>(object));
    }
    /// `fresh` takes the place of what the GPU may still be using.
    template<typename T>
    void replace(T& held, T fresh) {
        retire(std::move(held));
        held = std::move(fresh);
    }
    void releaseRetired() { retired_.clear(); }

  private:
    Erased& keptNext();
    Status addPool();

    const Device* device_ = nullptr;
    std::vector<VkDescriptorPool> pools_;
    size_t poolInUse_ = 0;
    std::vector<Buffer> blocks_;
    size_t blockInUse_ = 0;
    VkDeviceSize blockOffset_ = 0;
    std::vector<Erased> retired_;
};

} // namespace seaglass::gpu
