// What shore.glsl makes of rows, and of arrivals that lie outside of them: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

// In place of a body's, of the maps that it binds, and of warped waves.
#define BODY_GLSL
#define WAVE_WARP_GLSL
const int shoreMapBinding = 6, shoreSignalBinding = 0;
struct Water {
    vec4 shoreSignal, shoreForm, shorePlace;
};
// A row a second, of which each train has eight.
const Water water = Water(vec4(1.0, 0.0, 8.0, 1.0), vec4(0.1, 1.0, 0.0, 1.0), vec4(0.0, 0.0, 1.0, 1.0));
struct WaveGradient {
    vec2 height, movedU, movedV;
};
#include "shore.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 heights[];   // of the water's edge, how it changes along u, how fast it rises
};

// The first sixteen of the rows say when what arrives there left; those of the trains follow.
void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= heights.length()) return;
    const float swash = 1.0;
    ShoreWave w = withoutTrains(vec4(1.0), 1.0, vec2(0.0), swash);
    float arrival = shoreRows[i & 15].x;
    vec4 form = vec4(0.0, 0.0, 0.0, swash);   // of no height of their own
    addTrains(w, vec4(1.0, vec3(arrival)), vec4(0.0, vec3(1.0)), vec4(0.0), form, 0.0, 16, 0.0);
    heights[i] = vec4(w.height, w.swashSlope.x, w.rushes, 0.0);
}
