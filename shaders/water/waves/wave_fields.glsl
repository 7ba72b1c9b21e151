// What waves_columns.comp and waves_rows.comp share. The fields, their pairs and what columns hold of them: water/waves/wave_fields.h.
#ifndef WAVE_FIELDS_GLSL
#define WAVE_FIELDS_GLSL

#include "fft.glsl"
#include "wave_columns.h"
#include "waves_bindings.h"
#include "waves_block.h"

layout(set = 0, binding = wavesBinding, std140) uniform Waves {
    WavesBlock waves;
};

uint columnPoint(uint column, uint field, uint place) {
    return (column * uint(waveColumnFields) + field) * samples + place;
}

#endif
