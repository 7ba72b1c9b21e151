// Of shaders/reflection/after/edge_reach.comp.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct EdgeReachBlock {
    float reach; // beyond the border, at most [pixel]
    float pad0, pad1, pad2;
};

#ifdef __cplusplus
}
#endif
