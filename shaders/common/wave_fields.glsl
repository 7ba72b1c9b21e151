// What waves_columns.comp and waves_rows.comp share, as water/waves_gpu.cpp fills it. The fields, their pairs and what columns hold of them: water/wave_fields.h.
const uint columnFields = 5u;

struct Cascade {
    float dk;           // [rad/m]
    float packing;      // [m]
    uint firstColumn;   // of all cascades' columns, m = 0 first
    uint columns;
};

layout(set = 0, binding = 0, std140) uniform Waves {
    Cascade cascades[4];
    uint now;          // water/phase.h: loopPhase
    uint allColumns;
    float choppiness;
};

uint columnPoint(uint column, uint field, uint place) {
    return (column * columnFields + field) * samples + place;
}
