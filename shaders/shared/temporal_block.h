// Of shaders/reflection/after/temporal.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct TemporalBlock {
    mat4 lastFromRelative; // to the last frame's pixels, from where this frame's eye is
    mat4 relativeFromLast; // and back
    vec2 jitter;           // this frame's [pixel]
    float share;           // of the last frame, 0 where there is none
    float kept;            // of the confidence, where only the last frame knows
};

#ifdef __cplusplus
}
#endif
