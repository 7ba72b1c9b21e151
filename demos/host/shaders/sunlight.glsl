// What of sun and sky reaches a point, and what a glossy surface mirrors of the sun.
#include "frame.glsl"
#include "bent_sun.glsl"

layout(set = 0, binding = 3) uniform sampler2DShadow shadowMap;
layout(set = 0, binding = 4) uniform sampler2D shadowDepth;   // the same map; fetched alone

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
            sum += wu[i] * wv[j] * textureLod(shadowMap, vec3(corner + 0.5 * tap, depth), 0.0);
        }
    return sum / 16.0;
}

// Cosine of the sun's ray to a side with that unit normal. Under water it is the bent ray's over its own to the surface,
// times the straight one's: what comes in is the water's to say.
float facingSun(vec3 fromEye, vec3 normal) {
    return dot(mix(normal, shearedNormal(normal), shareInWater(fromEye)), frame.toSun.xyz);
}

// Irradiance from the sky on a side with that unit normal. Under water all of it comes from within 49 degrees of straight
// above: an even sky's within 0.02 of the share that it has there, and a sixth of what the side has more of in air than one
// that leans the other way. What comes in is the water's to say.
vec3 facingSky(vec3 fromEye, vec3 normal) {
    const vec3 inAir = skyIrradiance(normal);
    const float inWater = shareInWater(fromEye);
    if (inWater == 0.0) return inAir;
    const vec3 up = frame.waterPlane.xyz;
    const float upwards = dot(up, normal);
    const vec3 more = inAir - skyIrradiance(2.0 * upwards * up - normal);
    return mix(inAir, skyIrradiance(up) * pow(max(upwards + 0.66, 0.0) / 1.66, 1.75) + max(more, 0.0) / 6.0, inWater);
}

// By a point's place in the cascade's clip space, with depth's slope over uv on a plane of that unit normal.
vec2 slopeOfPlane(mat4 clipFromEye, vec3 normal, float cosine) {
    const mat4 rows = transpose(clipFromEye);
    const vec2 across = vec2(dot(normal, rows[0].xyz) / dot(rows[0].xyz, rows[0].xyz),
                             dot(normal, rows[1].xyz) / dot(rows[1].xyz, rows[1].xyz));
    return 2.0 * across * length(rows[2].xyz) / max(cosine, 0.05);
}

// In a spiral from the middle, so that no two are near each other (Vogel 1979).
vec2 spiral(int tap, float radius) {
    const float turns = 0.381966 * float(tap);
    const float turn = 6.2831853 * (turns - round(turns));   // sin and cos have bounds for half a turn either way
    return radius * vec2(cos(turn), sin(turn));
}

// Waves send the sun's rays astray, the farther the deeper: what stands high over a bed has a soft shadow there
// (percentage-closer soft shadows, Fernando 2005). How high that is on the mean is sought where rays that stray so far may have
// passed; then as many rays are counted that stray by a Gaussian. `at` as above; `depth` is the receiver's [m]. Else `hard`.
float scatteredShadow(int cascade, vec3 at, float depth, float hard) {
    const int taps = 16;
    const mat4 map = frame.shadowFromEye[cascade];
    const vec3 toUv = vec3(0.5, 0.5, 1.0);
    const vec3 along = toUv * (mat3(map) * frame.sunStrays[0].xyz), aside = toUv * (mat3(map) * frame.sunStrays[1].xyz);
    const float heightPerDepth = dot(frame.waterPlane.xyz, frame.toSun.xyz) / length(transpose(map)[2].xyz);
    const vec2 corner = vec2(cascade & 1, cascade >> 1) * 0.5;
    const float farthest = 2.0;   // deviations
    vec2 sum = vec2(0.0);
    for (int i = 0; i < taps; ++i) {
        const float astray = farthest * (float(i) + 0.5) / float(taps);
        const vec2 off = spiral(i, astray);
        const vec3 tap = at + depth * (off.x * along + off.y * aside);
        const float seen = texelFetch(shadowDepth, ivec2((2.0 * corner + clamp(tap.xy, 0.0, 1.0 - 0.5 * frame.shadow.x)) / frame.shadow.x), 0).r;
        const float height = min((tap.z - seen) * heightPerDepth, depth);
        if (farthest * height > astray * depth) sum += vec2(height, 1.0);
    }
    const float height = sum.x / max(sum.y, 1.0);
    const float least = 0.04;   // of that height, which is none of the receiver's own
    float lit = 0.0;
    for (int i = 0; i < taps; ++i) {
        const vec2 off = spiral(i, sqrt(-2.0 * log(1.0 - (float(i) + 0.5) / float(taps))));
        const vec3 tap = at + height * (off.x * along + off.y * aside) - vec3(0.0, 0.0, least * height / heightPerDepth);
        lit += textureLod(shadowMap, vec3(corner + 0.5 * clamp(tap.xy, 0.0, 1.0), tap.z), 0.0);
    }
    const float blurred = height * frame.sunStrays[0].w / frame.shadowTexelM[cascade];   // texels
    return mix(hard, lit / float(taps), smoothstep(0.5, 1.5, blurred));
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
    at.xy = at.xy * 0.5 + 0.5;
    const float hard = filteredShadow(chosen, at, slope);
    if (!bent || frame.sunStrays[0].w <= 0.0) return hard;
    return scatteredShadow(chosen, at, depthInWater(fromEye), hard);
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
