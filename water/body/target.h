// What is behind seaglass::Target: attachment formats, and the pipelines made for them so far.
#pragma once

#include "gpu/context.h"
#include "seaglass/water.h"
#include "water/below/view_pass.h"
#include "water/shading/placed_samples.h"
#include "water/spray/spray.h"
#include "water/surface/surface.h"

namespace seaglass {

struct Target : Held {
    TargetDesc desc;
    ViewPassPipelines viewPasses;
    PlacedSamplesPipelines placedSamples;
    SprayPipelines spray;
};

FieldError badField(const TargetDesc& desc);

/// Colours of more than 1.
bool holdsFloats(VkFormat format);

} // namespace seaglass
