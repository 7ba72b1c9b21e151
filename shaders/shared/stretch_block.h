// Of shaders/reflection/after/stretch.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct StretchBlock {
    float perMetre; // intensity times how steeply the camera looks down
    int band;       // texels from the border
    int along;      // the stretch: 0 x, 1 y
    int pad0;
};

#ifdef __cplusplus
}
#endif
