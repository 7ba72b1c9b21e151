// What is behind seaglass::Target: attachment formats, and the pipelines made for them so far.
#pragma once

#include "gpu/context.h"
#include "seaglass/water.h"
#include "water/surface.h"

namespace seaglass {

struct Target {
    Context* context = nullptr;
    SurfacePipelines pipelines;
};

} // namespace seaglass
