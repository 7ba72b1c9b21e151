// What of sun and sky reaches a point, and what a glossy surface mirrors of the sun. Needs frame.glsl.
#include "bent_sun.glsl"

layout(set = 0, binding = 3) uniform sampler2DShadow shadowMap;

const float pi = 3.14159265;

// Percentage-closer filtering under a 5x5 tent from nine bilinear taps (Castano 2013, "Shadow Mapping Summary").
// `uv` runs over one cascade; the four are quarters of the map.
float filteredShadow(int cascade, vec2 uv, float depth) {
    const float texel = frame.shadow.x;
    const vec2 at = uv / texel + 0.5;
    const vec2 base = floor(at), st = at - base;
    const vec2 corner = vec2(cascade & 1, cascade >> 1) * 0.5;
    const vec2 w0 = 4.0 - 3.0 * st, w2 = 1.0 + 3.0 * st;
    const vec2 p0 = (3.0 - 2.0 * st) / w0 - 2.0, p1 = (3.0 + st) / 7.0, p2 = st / w2 + 2.0;
    const vec3 wu = vec3(w0.x, 7.0, w2.x), wv = vec3(w0.y, 7.0, w2.y);
    const vec3 pu = vec3(p0.x, p1.x, p2.x), pv = vec3(p0.y, p1.y, p2.y);
    float sum = 0.0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const vec2 tap = (base - 0.5 + vec2(pu[i], pv[j])) * texel;
            sum += wu[i] * wv[j] * texture(shadowMap, vec3(corner + 0.5 * tap, depth));
        }
    return sum / 144.0;
}

// Cosine of the sun's ray to a side with that unit normal. Under water it is the bent ray's over its own to the surface,
// times the straight one's: what comes in is the water's to say.
float facingSun(vec3 fromEye, vec3 normal) {
    return dot(isSunBent(fromEye) ? shearedNormal(normal) : normal, frame.toSun.xyz);
}

// Irradiance from the sky on a side with that unit normal. Under water all of it comes from within 49 degrees of straight
// above, so that sides which lean have about half as much more or less of it; what comes in is the water's to say.
vec3 facingSky(vec3 fromEye, vec3 normal) {
    const vec3 inAir = skyIrradiance(normal);
    if (!isSunBent(fromEye)) return inAir;
    const vec3 up = frame.waterPlane.xyz;
    return mix(max(dot(up, normal), 0.0) * skyIrradiance(up), inAir, 0.5);
}

// `nDotL` is facingSun().
float sunVisibility(vec3 fromEye, vec3 normal, float nDotL) {
    const bool bent = isSunBent(fromEye);
    const float stretch = bent ? length(shearedNormal(normal)) : 1.0;
    const float cosine = nDotL / stretch;
    const float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    int chosen = -1;
    vec3 at = vec3(0.0);
    // From far to near: the nearest that holds the point wins. Chosen first and filtered once, since a device that
    // masks branches would pay for each.
    for (int cascade = 3; cascade >= 0; --cascade) {
        const float texelM = frame.shadowTexelM[cascade];
        // Under a filter of radius r a plane seen at an angle rises by r * sin: lifting the receiver along its normal
        // by that much ends acne without a bias in depth.
        const vec3 lifted = fromEye + normal * (texelM * stretch * (2.5 * sine + 0.1));
        const vec3 receiver = bent ? sheared(lifted) : lifted;
        const vec3 clip = (frame.shadowFromEye[cascade] * vec4(receiver, 1.0)).xyz;
        // The filter must not reach into the neighbouring cascade.
        const bool inside = max(abs(clip.x), abs(clip.y)) < 1.0 - 8.0 * frame.shadow.x;
        if (texelM > 0.0 && inside) {
            chosen = cascade;
            at = clip;
        }
    }
    return chosen < 0 ? 1.0 : filteredShadow(chosen, at.xy * 0.5 + 0.5, at.z);
}

// GGX with the height-correlated Smith term (Heitz 2014), Fresnel by Schlick.
vec3 sunSpecular(vec3 n, vec3 v, vec3 l, float nDotL, float nDotV, vec3 f0, float roughness) {
    const vec3 h = normalize(v + l);
    const float nDotH = clamp(dot(n, h), 0.0, 1.0), vDotH = clamp(dot(v, h), 0.0, 1.0);
    const float alpha = roughness * roughness, a2 = alpha * alpha;
    const float d = nDotH * nDotH * (a2 - 1.0) + 1.0;
    const float smith = nDotL * sqrt(nDotV * nDotV * (1.0 - a2) + a2) + nDotV * sqrt(nDotL * nDotL * (1.0 - a2) + a2);
    const vec3 f = f0 + (1.0 - f0) * pow(1.0 - vDotH, 5.0);
    return f * (a2 / (pi * d * d)) * (0.5 / max(smith, 1e-5));
}
