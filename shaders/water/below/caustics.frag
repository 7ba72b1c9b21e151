// What the waves make of the sunlight on the opaque scene below them, as a factor on its colour.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "body.glsl"
#include "encoding.glsl"
#include "optics.glsl"
#include "caustic_light.glsl"

layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;
layout(set = 0, binding = causticSumsBinding, std430) readonly buffer Light {
    uint blurred[];   // halves
};

layout(location = 0) out vec4 outColor;

#include "exclusion_volumes.glsl"

// All that is scattered, forwards too [1/m]: particles send 0.0183 of it back (Petzold 1972), and molecules, which sea
// water owes this much to (Morel 1974), half.
vec3 scattering() {
    vec3 byMolecules = min(water.backscatter.rgb, vec3(0.00046, 0.00095, 0.00227));
    return 2.0 * byMolecules + (water.backscatter.rgb - byMolecules) / 0.0183;
}

// The buffer is larger than the view, and holds anything beside what was blurred.
ivec2 held(ivec2 texel) {
    return clamp(texel, ivec2(0, max(firstRow(), 0)), lightSize() - 1);
}

vec2 lightOn(ivec2 texel) {
    return unpackHalf2x16(blurred[texel.y * rowLength() + texel.x]);
}

// By how much of what calm water lets through there is more light, and of the sun what nothing hides.
vec2 lightHere() {
    vec2 at = regionPixel(gl_FragCoord.xy) / float(rayStep()) - 0.5;
    vec2 corner = floor(at), past = at - corner;
    ivec2 low = held(ivec2(corner)), high = held(ivec2(corner) + 1);
    vec2 upper = mix(lightOn(low), lightOn(ivec2(high.x, low.y)), past.x);
    return mix(upper, mix(lightOn(ivec2(low.x, high.y)), lightOn(high), past.x), past.y);
}

// Of the sun's light what is not scattered on the way.
vec3 straightOn(float depth) {
    return exp(-scattering() * (depth / sunInWater().y));
}

// Of what lights a point the sun's share, as its side faces the bent ray.
vec3 sunShare(vec3 normal, float seen) {
    vec3 from = sunInWater();
    vec3 sun = sunLight(seen) * (sunAtEye().y * max(dot(normal, from), 0.0) / from.y);
    return sun / max(sun + skyLight(), 1e-6);
}

void main() {
    vec3 at;
    bool shown = bedShownAt(sceneDepth, ivec2(regionPixel(gl_FragCoord.xy)), at);
    at = shown ? at : vec3(0.0);
    vec3 across = cross(dFdx(at), dFdy(at));   // the side it shows, which depth tells between pixels
    float shows = shown ? 1.0 : 0.0;
    vec2 ends = vec2(dFdx(shows), dFdy(shows));
    if (ends != vec2(0.0)) across = vec3(0.0, 1.0, 0.0);   // beside the bed's end none is told
    vec3 normal = across * (dot(across, sightTo(at)) > 0.0 ? -1.0 : 1.0) / max(length(across), 1e-12);
    float depth = -heightOverCalm(at);
    bool beside = any(lessThan(at.xz, water.covered.xy)) || any(greaterThan(at.xz, water.covered.zw));
    if (!shown || beside) demote;
    vec3 factor = vec3(1.0);
    const float leastSeen = 0.004;   // a step of eight bits, where light gathers to twice its mean
    vec3 straight = water.causticStrength * straightOn(depth);
    bool lit = any(greaterThan(straight * sunShare(normal, 1.0), vec3(leastSeen)));
    if (lit && !isExcluded(at)) {
        vec2 light = lightHere();
        factor += straight * sunShare(normal, light.y) * light.x;
    }
    float mean = dot(factor, vec3(1.0 / 3.0));
    outColor = vec4(factor, mean);
    // Blending doubles it, for what unsigned bytes hold ends at 1.
    if (targetIsEncoded) outColor = vec4(0.5 * heldGrowth(factor), min(mean / mostGathered, leastUntold - 0.004));
}
