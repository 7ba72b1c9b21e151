// Of shaders/water/foam/foam.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct FoamBand {
    float threshold;      // compression above which the cascade breaks
    float perCompression; // whiteness, for as much above
    float fade;
    float floor;
};

struct FoamBlock {
    FoamBand bands[4];
    vec4 along; // water/interface/whitecaps.h: Breaking::along
    uint anew;  // nothing was there before
    uint pad0, pad1, pad2;
};

#ifdef __cplusplus
}
#endif
