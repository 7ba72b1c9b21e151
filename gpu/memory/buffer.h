// A buffer with its own memory.
#pragma once

#include <initializer_list>
#include <utility>

#include "gpu/device.h"

namespace seaglass::gpu {

/// Of the memory that this device wants for a buffer; none for one of no size, which is not made.
VkDeviceSize heldBytes(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage);

class Buffer {
  public:
    Buffer() = default;
    ~Buffer() { release(); }
    Buffer(Buffer&& other) noexcept { *this = std::move(other); }
    Buffer& operator=(Buffer&& other) noexcept;

    /// Device-local memory.
    Status create(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, const char* what);
    /// Host-visible, coherent and mapped for as long as the buffer lives: no flush, so no nonCoherentAtomSize
    /// to heed.
    Status createMapped(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, const char* what);

    VkBuffer handle() const { return buffer_; }
    VkDeviceSize size() const { return size_; }
    void* mapped() const { return memory_.mapped; }

  private:
    Status allocate(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage,
                    VkMemoryPropertyFlags memory, const char* what);
    void release();

    const Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    MemoryPiece memory_;
    VkDeviceSize size_ = 0;
};

struct BufferUse {
    VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
};

/// A barrier on all buffers.
void recordBarrier(const Device& device, VkCommandBuffer commands, const BufferUse& before,
                   const BufferUse& after);

/// Sets the first `bytes` of buffers that earlier work may still read or dispatch from; leaves them to
/// compute shaders.
void recordBuffersFilled(const Device& device, VkCommandBuffer commands,
                         std::initializer_list<VkBuffer> buffers, VkDeviceSize bytes, uint32_t value);
inline void recordBuffersCleared(const Device& device, VkCommandBuffer commands,
                                 std::initializer_list<VkBuffer> buffers,
                                 VkDeviceSize bytes = VK_WHOLE_SIZE) {
    recordBuffersFilled(device, commands, buffers, bytes, 0);
}

} // namespace seaglass::gpu
