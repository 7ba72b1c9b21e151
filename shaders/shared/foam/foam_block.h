// Of shaders/water/foam/foam.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct FoamBand {
    vec4 foam;  // compression above which the cascade breaks; whiteness, for as much above; fade; floor
    vec4 plume; // fade; floor; (u, v) that its crests run ahead from one tap of plumes to the next [tiles]
    vec4 drift; // (u, v) of its foam [tiles]
};

struct FoamBlock {
    FoamBand bands[4];
    vec4 along;     // water/interface/whitecaps.h: Breaking::along
    uint foamAnew;  // nothing was there before
    uint plumeAnew; // likewise
    uint plumes;    // taps ahead for them; 0: they stay as they are
    uint pad0;
};

#ifdef __cplusplus
}
#endif
