// What is pushed for each draw of a multiview pass, for GLSL and C++ alike.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct OneViewBlock {
    uint drawnView;
};

#ifdef __cplusplus
}
#endif
