// Which of the things that a ray passes march_ray.glsl says that it meets: shader_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#include "mirror_block.h"
#include "reflection_info.glsl"

// In place of the march's own: of a ray that comes upon two things, each as it is given.
#define MARCH_GLSL
#define MARCH_STRIDES_GLSL
const int refused = 0, behind = 2, closely = 3, underside = 4, met = 5;   // as march.glsl has them
const int falseAlarms = 12;
struct Settings {
    mat4 pixelFromRelative;
};
const Settings settings = Settings(mat4(1.0));
struct Track {
    vec2 range;
    bool leavesPicture;
};
struct Progress {
    float reached;
    bool hidden;
    int taps;
};
struct Crossing {
    bool found;
    float share;
    vec3 shown;
    bool thin;
};
struct March {
    float info;
    vec3 source;
    int worth;
};
ivec4 things;   // what each is worth, whether each is thin
Track trackOf(const MirrorBlock mirror, vec4 start, vec4 perMetre, float metres) {
    return Track(vec2(0.0, metres), false);
}
float trackMetres(Track track, float share) {
    return share * track.range.y;
}
Progress atStart(Track track, float noise) {
    return Progress(0.0, false, 9);
}
Crossing nextCrossing(const MirrorBlock mirror, Track track, inout Progress at) {
    at.reached += 0.25;
    return Crossing(at.reached < 0.6, at.reached, vec3(0.0), at.reached < 0.3 ? things.z != 0 : things.w != 0);
}
int settled(const MirrorBlock mirror, Track track, inout Crossing crossing) {
    return crossing.share < 0.3 ? things.x : things.y;
}
bool reachesSky(const MirrorBlock mirror, Track track, vec4 perMetre) {
    return true;
}
float signedDepth(const MirrorBlock mirror, float depth) {
    return depth;
}
float fromInfinity(const MirrorBlock mirror, float depth) {
    return depth;
}
#include "march_ray.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    ivec4 ways[];
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 ends[];   // how far away what is met lies, and what it is worth
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= ways.length()) return;
    things = ways[i];
    MirrorBlock mirror;
    March march = marched(mirror, vec3(0.0), vec3(0.0, 1.0, 0.0), 100.0, 0.0);
    ends[i] = vec4(march.info, march.worth, 0.0, 0.0);
}
