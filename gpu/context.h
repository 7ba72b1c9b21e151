// What is behind seaglass::Context.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "gpu/device.h"
#include "gpu/fields.h"
#include "gpu/frame.h"
#include "gpu/memory/sampler.h"
#include "gpu/type_erased.h"

namespace seaglass {

struct Context;

FieldError badField(const DeviceDesc& desc);

/// What a host holds of a context: a body, a reflector or a target.
struct Held {
    Context* context = nullptr;
    bool destroyed = false;                ///< by the host; it is kept until its frame slot begins again
    Held* destroyedBefore = nullptr;       ///< in the same slot
    void (*release)(Held& held) = nullptr; ///< of what was destroyed
};

struct Context {
    gpu::Device device;
    gpu::Samplers samplers;
    std::array<gpu::Frame, 4> frames;
    uint32_t frameCount = 0;
    uint32_t slot = 0;
    std::array<Held*, 4> destroyed{}; ///< in each slot, the last first: no memory need be had to destroy
    uint64_t frameNumber = 0;         ///< of the frame that was begun last, from 1; 0: none was
    uint32_t inUse = 0;               ///< bodies, reflectors and targets that the host holds
    bool toldOfEncoding = false;      ///< that a format without a word about it is taken for linear

    gpu::Frame& frame() { return frames[slot]; }
    /// Lets go of what the host destroyed in that slot.
    void releaseDestroyed(uint32_t ofSlot);

    /// One T for all who ask for it, which the context keeps: pipelines, which a body made anew would else
    /// compile again. T has `Status create(Context&)`, which may share others. Any thread: who asks meanwhile
    /// waits.
    template<typename T>
    Status share(std::shared_ptr<T>& out) {
        return shareAs<T>(Shared::kept, out);
    }
    /// The same while any of them lives: what holds the host's memory.
    template<typename T>
    Status shareWhileUsed(std::shared_ptr<T>& out) {
        return shareAs<T>(Shared::whileUsed, out);
    }

  private:
    enum class Shared { kept, whileUsed };
    template<typename T>
    Status shareAs(Shared how, std::shared_ptr<T>& out) {
        std::shared_ptr<void> shared;
        const Status status = shareMade(how, &tag<T>, makeFor<T>, shared);
        out = std::static_pointer_cast<T>(shared);
        return status;
    }
    template<typename T>
    static constexpr char tag = 0;
    template<typename T>
    static Status makeFor(Context& context, std::shared_ptr<void>& out) {
        return gpu::makeShared<T>(out).create(context);
    }
    Status shareMade(Shared how, const void* what,
                     Status (*make)(Context& context, std::shared_ptr<void>& out),
                     std::shared_ptr<void>& out);

    std::recursive_mutex sharing_;
    std::unordered_map<const void*, std::weak_ptr<void>> shared_;
    std::vector<std::shared_ptr<void>> kept_;
};

} // namespace seaglass
