// Of shaders/gpu/single_sample.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct SingleSampleBlock {
    ivec4 region;        // of the view: origin in the scene images, size
    float infinityDepth; // depth value of points at infinity
    float pad0, pad1, pad2;
};

const int singleSampleBinding = 0; // the block
const int samplesBinding = 1;      // of a multisampled image
const int resolvedBinding = 2;
const int chosenBinding = 3;

#ifdef __cplusplus
}
#endif
