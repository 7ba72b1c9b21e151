// What of sun and sky reaches a point, and what a glossy surface mirrors of the sun. Needs frame.glsl.
#include "bent_sun.glsl"

layout(set = 0, binding = 3) uniform sampler2DShadow shadowMap;

const float pi = 3.14159265;

// Percentage-closer filtering under a 3x3 tent from four bilinear taps (Castano 2013, "Shadow Mapping Summary").
// `at` is uv over one cascade, of which four are quarters of the map, and depth; `slope` is how that grows over uv on the
// receiver's plane: taps beside the point compare with what the plane is there.
float filteredShadow(int cascade, vec3 at, vec2 slope) {
    const float texel = frame.shadow.x;
    const vec2 inTexels = at.xy / texel + 0.5;
    const vec2 base = floor(inTexels), st = inTexels - base;
    const vec2 corner = vec2(cascade & 1, cascade >> 1) * 0.5;
    const vec2 w0 = 3.0 - 2.0 * st, w1 = 1.0 + 2.0 * st;
    const vec2 p0 = (2.0 - st) / w0 - 1.0, p1 = st / w1 + 1.0;
    const vec2 wu = vec2(w0.x, w1.x), wv = vec2(w0.y, w1.y);
    const vec2 pu = vec2(p0.x, p1.x), pv = vec2(p0.y, p1.y);
    float sum = 0.0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const vec2 tap = (base - 0.5 + vec2(pu[i], pv[j])) * texel;
            const float depth = at.z + dot(slope, tap - at.xy);
            sum += wu[i] * wv[j] * texture(shadowMap, vec3(corner + 0.5 * tap, depth));
        }
    return sum / 16.0;
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

// By a point's place in the cascade's clip space, with depth's slope over uv on a plane of that unit normal.
vec2 slopeOfPlane(mat4 clipFromEye, vec3 normal, float cosine) {
    const mat4 rows = transpose(clipFromEye);
    const vec2 across = vec2(dot(normal, rows[0].xyz) / dot(rows[0].xyz, rows[0].xyz),
                             dot(normal, rows[1].xyz) / dot(rows[1].xyz, rows[1].xyz));
    return 2.0 * across * length(rows[2].xyz) / max(cosine, 0.05);
}

// Of a point of a facet whose shading has the normal `smoothed`; both are unit. A facet near the terminator would lie in its
// own shadow where the round thing that it stands for is lit: there the shading's plane is taken, lifted over the facets.
float sunVisibility(vec3 fromEye, vec3 facet, vec3 smoothed) {
    const float facetCosine = dot(facet, frame.toSun.xyz);
    const vec3 normal = facetCosine < 0.15 ? smoothed : facet;
    const float liftTexels = mix(1.5, 0.25, smoothstep(0.0, 0.3, facetCosine));
    const bool bent = isSunBent(fromEye);
    const vec3 facing = bent ? shearedNormal(normal) : normal;
    const float stretch = length(facing), cosine = dot(facing, frame.toSun.xyz) / stretch;
    int chosen = -1;
    vec3 at = vec3(0.0);
    // From far to near: the nearest that holds the point wins. Chosen first and filtered once, since a device that
    // masks branches would pay for each.
    for (int cascade = 3; cascade >= 0; --cascade) {
        const float texelM = frame.shadowTexelM[cascade];
        const vec3 lifted = fromEye + normal * (texelM * stretch * liftTexels);
        const vec3 receiver = bent ? sheared(lifted) : lifted;
        const vec3 clip = (frame.shadowFromEye[cascade] * vec4(receiver, 1.0)).xyz;
        // The filter must not reach into the neighbouring cascade.
        const bool inside = max(abs(clip.x), abs(clip.y)) < 1.0 - 8.0 * frame.shadow.x;
        if (texelM > 0.0 && inside) {
            chosen = cascade;
            at = clip;
        }
    }
    if (chosen < 0) return 1.0;
    const vec2 slope = slopeOfPlane(frame.shadowFromEye[chosen], facing / stretch, cosine);
    return filteredShadow(chosen, vec3(at.xy * 0.5 + 0.5, at.z), slope);
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
