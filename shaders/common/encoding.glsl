// The sRGB curve (IEC 61966-2-1, which goes on above 1), for hosts whose images hold colour as displays take it. Where the scene's
// colour is read SCENE_ENCODING is the number of its constant, where colour is written TARGET_ENCODING.

#ifdef SCENE_ENCODING
layout(constant_id = SCENE_ENCODING) const bool sceneIsEncoded = false;

vec3 linearOf(vec3 held) {
    if (!sceneIsEncoded) return held;
    vec3 c = max(held, 0.0);
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}
#endif

#ifdef TARGET_ENCODING
layout(constant_id = TARGET_ENCODING) const bool targetIsEncoded = false;

vec3 heldOf(vec3 radiance) {
    if (!targetIsEncoded) return radiance;
    vec3 c = max(radiance, 0.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
#endif

// By how much what is held grows where light does so many times, amid the curve.
vec3 heldGrowth(vec3 times) {
    return pow(max(times, 0.0), vec3(1.0 / 2.2));
}

// Drawn over encoded colour caustics tell in its alpha how much light they gathered: unsigned bytes hold it, and 1 where none
// were drawn.
const float mostGathered = 5.0;
const float leastUntold = 0.996;   // short of 1 by a step of eight bits
