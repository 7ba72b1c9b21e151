// The sRGB curve (IEC 61966-2-1, which goes on above 1), for hosts whose images hold colour as displays take it.
#ifndef ENCODING_GLSL
#define ENCODING_GLSL

const float mostOfHalf = 65504.0;
const float mostHeld = 60000.0;   // near what halves hold, with room for what is added

// What is not finite is none, so that nothing is made of it. Told by its bits, as drivers compare NaN as they like.
vec3 finiteOf(vec3 held) {
    const uvec3 exponent = uvec3(0x7f800000u);
    bool finite = all(notEqual(floatBitsToUint(held) & exponent, exponent));
    return finite ? clamp(held, -mostHeld, mostHeld) : vec3(0.0);
}

vec3 linearOf(vec3 held, bool isEncoded) {
    held = finiteOf(held);
    if (!isEncoded) return held;
    vec3 c = max(held, 0.0);
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

vec3 heldOf(vec3 radiance, bool isEncoded) {
    if (!isEncoded) return radiance;
    vec3 c = max(radiance, 0.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// By how much what is held grows where light does so many times, amid the curve.
vec3 heldGrowth(vec3 times) {
    return pow(max(times, 0.0), vec3(1.0 / 2.2));
}

// Drawn over encoded colour caustics tell in its alpha how much light they gathered: unsigned bytes hold it, and 1 where none
// were drawn.
const float mostGathered = 5.0;
const float leastUntold = 0.996;   // short of 1 by a step of eight bits

#endif
