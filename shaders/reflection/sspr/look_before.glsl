// Looks over the mirror from one of its pixels towards the eye, for what hangs between.

// What hangs lower than it is wide leaves keys in at least as many cells as lie between them and what it hides: looks may lie
// as far apart as they have gone.
const int firstLook = 3;   // [cells]
const int mostOverhangSamples = 8;   // that ReflectionDesc::overhangSamples may ask for

float farthest(vec2 apart) {
    return max(abs(apart.x), abs(apart.y));
}

// On the screen, from a pixel of the mirror to what it shows.
vec2 awayFrom(const MirrorBlock mirror, vec2 q) {
    vec4 start = mirror.sceneFromPixel * vec4(q, 0.0, 1.0);
    vec4 along = mirror.sceneFromPixel[2];
    vec2 away = mirror.depthSign * (start.xy * along.w - along.xy * start.w);
    return away / max(farthest(away), 1e-30);
}

// Halfway between two such looks lies another: what stands on what hangs hides half of it.
ivec2 cellBefore(const MirrorBlock mirror, vec2 q, vec2 away, int tap) {
    float cells = 0.5 * float((firstLook * (2 + (tap & 1))) << (tap >> 1));
    return texelAt(q / float(keyEdge(mirror)) - cells * away, lastCell);
}
