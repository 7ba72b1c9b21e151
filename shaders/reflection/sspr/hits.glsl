// What a mirrored ray meets of the scene, and the keys that lead there.
#ifndef HITS_GLSL
#define HITS_GLSL

#include "hidden_way.glsl"

struct Hit {
    bool valid;
    bool front;    // on the side that is seen
    vec2 source;   // pixel
    float off;     // from the middle of the pixel whose surface was met
    float depth;   // mirrored, at this pixel
};

const Hit noHit = Hit(false, false, vec2(0.0), 0.0, 0.0);

// A key on the line through a pixel and its source.
struct LineKey {
    uint key;
    ivec2 cell;
};

// What left a key in another cell.
ivec2 sourceOf(const MirrorBlock mirror, LineKey from) {
    if (from.key == noKey) return nowhere;
    vec2 q = (vec2(from.cell) + 0.5) * float(keyEdge(mirror));
    vec4 p = sourcePoint(mirror, q, depthFromKey(mirror, from.key));
    return regionPixel(mirror, p.xy / p.w);
}

#endif
