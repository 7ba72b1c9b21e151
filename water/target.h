// What is behind seaglass::Target: attachment formats, and the pipelines made for them so far.
#pragma once

#include "gpu/context.h"
#include "seaglass/water.h"
#include "water/surface.h"
#include "water/underwater.h"

namespace seaglass {

struct Target {
    Context* context = nullptr;
    SurfacePipelines pipelines;
    UnderwaterPipelines underwater;
};

} // namespace seaglass
