// Of shaders/reflection/debug/overlay.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct OverlayBlock {
    vec4 forwardRow; // distance ahead of the eye [m] is forwardRow.p / weightRow.p for p = (x, y, depth, 1)
    float contourSpacing; // [m]
    int kind;             // OverlayKind
    uint pad0, pad1;
};

#ifdef __cplusplus
}
#endif
