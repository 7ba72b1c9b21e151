// What is behind seaglass::Target: attachment formats, and the pipelines made for them so far.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "gpu/context.h"
#include "seaglass/water.h"
#include "water/below/view_pass.h"
#include "water/shading/placed_samples.h"
#include "water/spray/spray.h"
#include "water/surface/surface.h"

namespace seaglass {

/// Kernels that bodies share once they want them, made before.
struct PreparedKernels {
    std::mutex adding;
    std::vector<std::shared_ptr<void>> kept;
    template<typename Kernel>
    Status keep(Context& context) {
        std::shared_ptr<Kernel> kernel;
        if (const Status s = context.share(kernel); s != Status::ok) return s;
        add(std::move(kernel));
        return Status::ok;
    }
    void add(std::shared_ptr<void> kernels) {
        const std::lock_guard lock(adding);
        kept.push_back(std::move(kernels));
    }
};

struct Target : Held {
    TargetDesc desc;
    ViewPassPipelines viewPasses;
    PlacedSamplesPipelines placedSamples;
    SprayPipelines spray;
    PreparedKernels prepared;
};

FieldError badField(const TargetDesc& desc);

/// Colours of more than 1.
bool holdsFloats(VkFormat format);

} // namespace seaglass
