// How rays are followed over the picture: shaders/reflection/march/march.glsl.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct MarchBlock {
    mat4 pixelFromRelative;
    vec4 forwardRow; // distance ahead of the eye [m] is forwardRow.p / weightRow.p for p = (x, y, depth, 1)
    float thickness; // [m]
    float longest;   // [m] of a ray
    float jitter;    // share of a stride
    int steps;
    uint hasNormals;
    uint pad0, pad1, pad2;
};

#ifdef __cplusplus
}
#endif
