// Sends rays of the sun through the waves to the opaque scene below them, and counts what arrives. Under calm water the ray
// of each pixel ends in that pixel, so that all are lit alike. Sums of integers do not depend on the order of the invocations.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "body.glsl"
#include "optics.glsl"
#include "slopes.glsl"
#include "body_sight.glsl"
#include "caustic_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;
layout(set = 0, binding = causticSumsBinding, std430) buffer Sums {
    uint sums[];
};
#include "wave_maps.glsl"
#include "wave_warp.glsl"
#include "shore.glsl"
#include "wave_displacement.glsl"

// How far the sun's ray through a surface of this slope strays sideways on each metre down.
vec2 strays(vec2 slope) {
    vec3 ray = refract(-sunAtEye(), normalOf(slope), 1.0 / waterIndex);
    return ray.xz / max(-ray.y, 0.1);
}

struct Ray {
    vec3 from;     // on the surface
    vec2 strays;   // on each metre down
    float light;   // of what calm water lets through: as the surface there faces the sun
};

// Mean slope over `width` metres of the surface over a point of the calm plane.
vec2 slopeAt(vec2 calm, float width) {
    vec4 derivatives = vec4(0.0);
    float shear = 0.0;
    ShoreWave shore = withoutTrains(vec4(1.0), 0.0, vec2(0.0), 0.0);
    if (hasShore) shore = shoreWave(calm, width);
    vec2 place = warped(calm);
    int i = 0, count = waveCascades();
    do {
        float mip = log2(max(width * texelsInAMetre(i), 1.0));
        if (showsWaves(mip)) {
            vec3 at = inTile(place, i);
            derivatives += shore.kept[i] * textureLod(waveDerivatives, at, mip);
            shear += shore.kept[i] * textureLod(waveMoments, at, mip).w;
        }
    } while (++i < count);
    WaveGradient gradient = waveGradient(derivatives, shear, calm);
    if (hasShore) addShore(shore, gradient);
    return slopeOfWaves(gradient);
}

// Through the surface where waves have moved it to (u, v): rays that stand evenly there light still water evenly.
Ray rayThrough(vec2 at, float width) {
    vec3 moved = surfaceDisplacement(waveDisplacement, at, width);
    vec2 slope = slopeAt(at - moved.xz, width);
    Ray ray;
    ray.from = vec3(at.x, calmLevel() + moved.y, at.y);
    ray.strays = strays(slope);
    vec3 toSun = sunAtEye();
    ray.light = max(1.0 - dot(slope, toSun.xz) / toSun.y, 0.0);
    return ray;
}

vec3 whereItIs(Ray ray, float height) {
    vec2 at = ray.from.xz + (ray.from.y - height) * ray.strays;
    return vec3(at.x, height, at.y);
}

// What is under water at a pixel, which may lie beside the view: the bed at its border goes on level.
bool bedAt(ivec2 pixel, out vec3 at) {
    ivec2 inside = clamp(pixel, ivec2(0), regionSize() - 1);
    if (!bedShownAt(sceneDepth, inside, at)) return false;
    if (inside == pixel) return true;
    vec2 middle = vec2(pixel) + 0.5;
    vec3 direction = alongSightOf(middle), from = pointAt(middle, 0.5);
    vec3 beyond = from + direction * ((at.y - from.y) / direction.y);
    vec3 further = beyond - at;
    at = beyond;
    const float farthest = 10.0;   // from the border [m]
    return dot(further, further) < farthest * farthest && dot(sightTo(beyond), direction) > 0.0;
}

void leave(vec2 pixel, float amount) {
    ivec2 size = lightSize();
    vec2 at = pixel / float(rayStep()) - 0.5;
    if (!(all(greaterThan(at, vec2(-1.0))) && all(lessThan(at, vec2(size))))) return;
    ivec2 first = ivec2(floor(at));
    vec2 past = at - vec2(first);
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 texel = first + corner;
        if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) continue;
        vec2 share = mix(1.0 - past, past, vec2(corner));
        atomicAdd(sums[texel.y * rowLength() + texel.x], uint(amount > 0.0 ? min(amount * share.x * share.y, mostOfRay) + 0.5 : 0.0));
    }
}

void main() {
    ivec2 pixel = pixelOfTexel(ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow())) - ivec2(margin(), 0);
    if (any(greaterThanEqual(pixel, regionSize() + margin()))) return;
    vec3 at;
    if (!bedAt(pixel, at)) return;
    Ray ray = rayThrough(sunRayEnters(at).xz, rayWidth(at));
    // To the height of its own pixel, then to what stands there. What is thin, and what the bed behind it shows beside it, keeps
    // its own light: which of its rays go past it, and which others it stops, the depth does not tell.
    vec3 level = whereItIs(ray, at.y);
    vec4 fallen = pixelOf(level);
    bool shown = fallen.w > 0.0 && inRegion(fallen.xy);
    if (shown) {
        vec3 there;
        bool bed = bedShownAt(sceneDepth, ivec2(fallen.xy), there);
        float steepest = 4.0 * (distance(level.xz, at.xz) + float(rayStep()) * pixelWidth(at));
        bool goesOn = bed && abs(there.y - at.y) < steepest;
        fallen = goesOn ? pixelOf(whereItIs(ray, there.y)) : vec4(vec2(pixel) + 0.5, 0.0, 1.0);
    }
    if (fallen.w > 0.0) leave(fallen.xy, ray.light * lightUnit);
}
