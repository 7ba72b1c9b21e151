// How glitter.glsl tilts patches of facets: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

// In place of surface_point.glsl's, of which a patch takes no more.
#define SURFACE_POINT_GLSL
#include "footprint.glsl"
struct SurfacePoint {
    vec2 calm, slope;
    Footprint footprint;
    vec3 covariance;
    float bounded;
};
struct Water {
    ivec4 glitter;
    vec4 glitterShare;
};
const Water water = Water(ivec4(0, 0, 0, 1), vec4(1.0));
#include "glitter.glsl"

layout(local_size_x = 64) in;

struct Place {
    vec4 calm;
    vec4 covariance;
};
layout(set = 0, binding = 0, std430) readonly buffer Given {
    Place places[];
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 tilted[];   // its slopes, and what is left of their variance
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= places.length()) return;
    const float pixel = 0.01;   // half of its length [m]
    Footprint footprint = Footprint(vec2(pixel, 0.0), vec2(0.0, pixel), pixel);
    SurfacePoint s = SurfacePoint(places[i].calm.xy, vec2(0.0), footprint, places[i].covariance.xyz, 0.0);
    s = patchOf(s);
    tilted[i] = vec4(s.slope, s.covariance.xy);
}
