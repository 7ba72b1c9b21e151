// Of shaders/gpu/mip_chain.comp, which halves IMAGES images at once.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct MipChainBlock {
    uint levels; // of the five
    uint pad0, pad1, pad2;
};

const int mipChainBinding = 0;
const int firstSourceBinding = 1; // of each image
const int firstHalvedBinding = 4; // five of each image

#ifdef __cplusplus
}
#endif
