// Edge stretch: reflection/after/stretch.h. A row (a column, of a camera that rolled) is taken from its border inwards by one
// invocation, so that what is read has not been written: nothing is copied beforehand, and the order is always the same.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "stretch_block.h"
#include "reflection_info.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = settingsBinding, std140) uniform Stretch {
    StretchBlock settings;
};
layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform image2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding, r16f) uniform image2D reflectionInfo;

struct Line {
    ivec2 border;   // its texel there
    ivec2 inward;
    int texels;
};

Line lineOf(const MirrorBlock mirror, uvec2 id) {
    ivec2 size = reflectionSize(mirror);
    ivec2 across = settings.along == 0 ? ivec2(0, 1) : ivec2(1, 0);
    ivec2 inward = ivec2(1) - across;
    Line line = Line(across * int(id.x), inward, settings.along == 0 ? size.x : size.y);
    if (id.y == 1u) {
        line.border += inward * (line.texels - 1);
        line.inward = -inward;
    }
    return line;
}

float infoAt(Line line, int index) {
    return imageLoad(reflectionInfo, line.border + line.inward * index).r;
}

// Whether the picture would have to go on beyond this border to show what is mirrored `distance` metres from the mirror.
bool beyondBorder(const MirrorBlock mirror, vec2 q, SightLine sight, float distance, bool atEnd) {
    vec3 direction = sight.direction;
    float reach = dot(direction, sight.onPlane) + distance;
    vec4 near = homogeneousPoint(mirror, vec4(q, 0.0, 1.0));
    vec4 perDepth = homogeneousPerDepth(mirror);
    float depth = (reach * near.w - dot(direction, near.xyz)) / (dot(direction, perDepth.xyz) - reach * perDepth.w);
    vec4 source = sourcePoint(mirror, q, depth);
    float at = source[settings.along] / source.w;
    return source.w > 0.0 && (atEnd ? at >= float(regionSize(mirror)[settings.along]) : at < 0.0);
}

// Where a stretched line has what is `height` metres above the plane and now at `index`.
int unstretched(Line line, int index, float height) {
    float nearness = 1.0 - (float(index) + 0.5) / float(settings.band);
    float middle = 0.5 * float(line.texels);
    // More, and the line would turn back and show things twice.
    float most = float(settings.band) / max(middle - float(settings.band), 1e-3);
    float off = (middle - float(index) - 0.5) / (1.0 + min(height * settings.perMetre, most) * nearness);
    return int(middle - off);
}

void main() {
    MirrorBlock mirror = storedMirror;
    ivec2 size = reflectionSize(mirror);
    if (int(gl_GlobalInvocationID.x) >= (settings.along == 0 ? size.y : size.x)) return;
    Line line = lineOf(mirror, gl_GlobalInvocationID.xy);
    int known = 0;   // the first from here inwards of which something is known
    for (int index = 0; index < settings.band; ++index) {
        known = max(known, index);
        while (known < settings.band && infoAt(line, known) == infoUnknown) ++known;
        float nearest = infoAt(line, known);
        ivec2 texel = line.border + line.inward * index;
        vec2 q = middleOf(mirror, texel);
        SightLine sight = sightThrough(mirror, q);
        float rise = sight.towardsPlane;
        if (!infoIsHit(nearest) || !(rise > 0.0)) continue;
        // What is open for another reason stays so.
        if (known > index && !beyondBorder(mirror, q, sight, nearest, gl_GlobalInvocationID.y == 1u)) continue;
        int from = max(unstretched(line, index, nearest * rise), known);
        float info = infoAt(line, from);
        if (infoIsHit(info)) {
            from = max(unstretched(line, index, info * rise), known);
            info = infoAt(line, from);
        }
        if (from == index) continue;
        // Things end before the sky: what is known of them stays.
        if (!infoIsHit(info)) from = known;
        imageStore(reflectionColor, texel, imageLoad(reflectionColor, line.border + line.inward * from));
        imageStore(reflectionInfo, texel, imageLoad(reflectionInfo, line.border + line.inward * from));
    }
}
