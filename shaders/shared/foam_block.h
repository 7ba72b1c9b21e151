// Of shaders/water/foam/foam.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct FoamBand {
    float threshold;   // Jacobian below which the cascade breaks
    float perJacobian; // whiteness, for as much below
    float pad0, pad1;
};

struct FoamBlock {
    FoamBand bands[4];
    float fade;
    float floor;
    uint anew; // nothing was there before
    uint pad0;
};

#ifdef __cplusplus
}
#endif
