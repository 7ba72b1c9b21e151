// What shaders/water/waves/waves_columns.comp and waves_rows.comp are told.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct WaveBand {
    float dk;         // [rad/m]
    float packing;    // [m]
    uint firstColumn; // of all bands' columns, m = 0 first; beyond all where there is no such band
    uint columns;
};

struct WavesBlock {
    WaveBand bands[4];
    uint now; // water/sea/phase.h: loopPhase
    uint allColumns;
    float choppiness;
    uint pad0;
};

#ifdef __cplusplus
}
#endif
