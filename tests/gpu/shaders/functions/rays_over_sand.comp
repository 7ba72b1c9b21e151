// What reflection_lookup.glsl finds on a beach: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

// In place of a body's, of its maps, and of the scene: a wall that stands across, twelve metres ahead.
#include "pinhole.glsl"
#define SCENE_BEHIND_GLSL
#define SURFACE_GLSL
#define SURFACE_POINT_GLSL
const bool hasWaves = true, hasShore = true, hasReflection = false;
const int sharpDownscale = 0;
struct Water {
    vec4 mirror, reflectionBlur;
    float reflectionScale, reflectionDistortion;
};
const Water water = Water(vec4(eyeHeight, 1.0, 0.0, 0.0), vec4(0.0), 1.0, 1.0);
struct ShoreSeen {
    float depth, thick;
    vec2 bedSlope;
};
struct SurfacePoint {
    vec2 pixel;
    vec3 position;
    ShoreSeen shore;
};
layout(set = 0, binding = 2) uniform sampler2D reflectionColor, reflectionInfo;   // not looked at
struct Behind {
    vec2 pixel;
    vec3 seen;
    bool nothing;
};
const float wallAt = 12.0, wallTop = -1.5;
Behind behindAt(vec2 pixel) {
    vec3 at = pointAt(floor(pixel) + 0.5, wallAt);
    return Behind(pixel, at, at.y > wallTop || !inRegion(pixel));
}
vec3 radianceOf(Behind b) {
    return b.seen;
}
float untilBorder(vec4 a, vec4 b, vec2 size) {
    vec4 gap = vec4(a.xy, size * a.w - a.xy);
    vec4 loss = vec4(-b.xy, b.xy - size * b.w);
    vec4 t = mix(vec4(1e6), gap / loss, greaterThan(loss, gap * 1e-6));
    return max(min(min(t.x, t.y), min(t.z, t.w)), 0.0);
}
#include "reflection_lookup.glsl"

layout(local_size_x = 64) in;

struct FromTo {
    vec4 from, along;
};
layout(set = 0, binding = 0, std430) readonly buffer Given {
    FromTo rays[];
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 met[];
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= rays.length()) return;
    SurfacePoint s;
    s.position = rays[i].from.xyz;
    s.shore.depth = 0.0;
    s.shore.bedSlope = vec2(0.0);
    met[i] = mirroredOverSand(s, rays[i].along.xyz);
}
