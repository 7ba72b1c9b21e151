// What is behind seaglass::Context.
#pragma once

#include <array>
#include <memory>
#include <unordered_map>

#include "gpu/device.h"
#include "gpu/frame.h"
#include "gpu/sampler.h"

namespace seaglass {

struct Context {
    gpu::Device device;
    gpu::Samplers samplers;
    std::array<gpu::Frame, 4> frames;
    uint32_t frameCount = 0;
    uint32_t slot = 0;
    uint32_t inUse = 0; ///< bodies, reflectors and targets that the host holds

    gpu::Frame& frame() { return frames[slot]; }

    /// One T for all who ask for it while any of them lives: pipelines that several bodies use. T has
    /// `Status create(Context&)`.
    template<typename T>
    Status share(std::shared_ptr<T>& out) {
        std::weak_ptr<void>& known = shared_[&tag<T>];
        out = std::static_pointer_cast<T>(known.lock());
        if (out) return Status::ok;
        const auto made = std::make_shared<T>();
        if (const Status s = made->create(*this); s != Status::ok) return s;
        known = made;
        out = made;
        return Status::ok;
    }

  private:
    template<typename T>
    static constexpr char tag = 0;
    std::unordered_map<const void*, std::weak_ptr<void>> shared_;
};

} // namespace seaglass
