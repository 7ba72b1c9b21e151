// Of shaders/reflection/planar/planar.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct PlanarBlock {
    vec4 heightRow; // with the mirrored projection's own depth
    vec4 weightRow;
    uint samples; // of the depth, a pixel
    uint pad0, pad1, pad2;
};

#ifdef __cplusplus
}
#endif
