// What is behind seaglass::Target: attachment formats, and the pipelines made for them so far.
#pragma once

#include "gpu/context.h"
#include "seaglass/water.h"
#include "water/surface.h"
#include "water/underwater.h"

namespace seaglass {

struct Target : Held {
    TargetDesc desc;
    SurfacePipelines pipelines;
    UnderwaterPipelines underwater;
};

/// Colours of more than 1.
bool holdsFloats(VkFormat format);

} // namespace seaglass
