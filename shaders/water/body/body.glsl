// One view of a body, as its shaders are given it.
#ifndef BODY_GLSL
#define BODY_GLSL

#include "body_constants.glsl"
#include "water_bindings.h"
#include "body_block.h"

layout(set = 0, binding = bodyBinding, std140) uniform Body {
    BodyBlock water;
};

// Of a pixel of the host's.
vec2 regionPixel(vec2 hostPixel) {
    return hostPixel - vec2(water.region.xy);
}

ivec2 regionSize() {
    return water.region.zw;
}

bool inRegion(vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, vec2(regionSize())));
}

// The nearest whose neighbours all are in the region, for linear taps.
vec2 heldInRegion(vec2 pixel) {
    return clamp(pixel, vec2(0.5), vec2(regionSize()) - 0.5);
}

// Of the scene's images, of a pixel of the region.
ivec2 sceneTexel(ivec2 pixel) {
    return water.region.xy + pixel;
}

bool nearerIsGreater() {
    return water.depthSign > 0.0;
}

// Positive of a depth that is nearer than another.
float depthBefore(float depth, float other) {
    return water.depthSign * (depth - other);
}

// Whether a depth of the scene is that of nothing.
bool isFarPlane(float depth) {
    return depthBefore(depth, water.farDepth) <= 0.0;
}

// What the scene's depth shows at a pixel of the region; homogeneous, and where that is.
vec4 homogeneousPoint(vec2 pixel, float depth) {
    return water.relativeFromPixel * vec4(pixel, depth, 1.0);
}

vec3 pointAt(vec2 pixel, float depth) {
    vec4 q = homogeneousPoint(pixel, depth);
    return q.xyz / q.w;
}

// Where the last frame showed a point: a motion draw looks at no scene, and has this in the place of what that takes.
vec4 homogeneousLastPixel(vec3 position) {
    return water.relativeFromPixel * vec4(position, 1.0);
}

vec4 clipOf(vec3 position) {
    return water.clipFromRelative * vec4(position, 1.0);
}

vec3 calmNormal() {
    return water.plane.xyz;
}

// Where the calm plane is, of which y rises [m].
float calmLevel() {
    return -water.plane.w;
}

// Of a point of the calm plane, by its (u, v).
vec3 onCalmPlane(vec2 calm) {
    return vec3(calm.x, calmLevel(), calm.y);
}

// Of a point over the calm plane [m].
float heightOverCalm(vec3 at) {
    return at.y + water.plane.w;
}

// 1, or 0 where lines of sight are parallel.
float seenFromAnEye() {
    return water.sight.w;
}

bool sightIsParallel() {
    return seenFromAnEye() == 0.0;
}

// How far off levels of detail take a place of the calm plane to be: by parallel lines of sight all alike [m].
float distanceForDetail(vec2 calm) {
    return water.sight.w * length(vec3(calm, water.plane.w)) + water.parallelDistance;
}

// Towards the sun, as the eye has it; sunDirection() is that of other places of a globe.
vec3 sunAtEye() {
    return water.toSun.xyz;
}

// Towards the sun, as calm water bends its light; and where the ray to a point in the water came in.
vec3 sunInWater() {
    return water.sunInWater.xyz;
}

vec3 sunRayEnters(vec3 at) {
    return at - sunInWater() * (heightOverCalm(at) / sunInWater().y);
}

// Irradiance by shares of the sun's and the sky's.
vec3 sunLight(float sun) {
    return water.sunIrradiance.rgb * sun;
}

bool sunShines() {
    return dot(sunLight(1.0), vec3(1.0)) > 0.0;
}

vec3 skyLight() {
    return water.skyIrradiance.rgb;
}

vec3 lightBy(float sun, float sky) {
    return sunLight(sun) + skyLight() * sky;
}

// To a point along the line of sight on which it lies, of any length.
vec3 sightTo(vec3 at) {
    return at * water.sight.w + water.sight.xyz;
}

// Where the line of sight to a point may be taken to begin: at the eye, and of parallel lines at the point.
vec3 sightStart(vec3 at) {
    return (1.0 - water.sight.w) * at;
}

// Along parallel lines of sight, from the eye's own place on them; else 0.
float alongParallels(vec3 at) {
    return dot(at, water.sight.xyz);
}

// How far away a point lies; of parallel lines, beyond the eye's own place on them.
float distanceTo(vec3 at) {
    return length(at * water.sight.w) + alongParallels(at);
}

// Greater where a point lies farther away.
float farnessOf(vec3 at) {
    return water.sight.w * dot(at, at) + alongParallels(at);
}

// Of a point, (x, y, depth) in the region's pixels times w; and what each metre along a direction adds to that.
vec4 homogeneousPixel(vec4 position) {
    return water.pixelFromRelative * position;
}

vec4 homogeneousPixel(vec3 position) {
    return homogeneousPixel(vec4(position, 1.0));
}

vec4 homogeneousPerMetre(vec3 direction) {
    return water.pixelFromRelative * vec4(direction, 0.0);
}

// (x, y, depth) of a point in the region's pixels; w <= 0 behind the camera.
vec4 pixelOf(vec3 position) {
    vec4 p = homogeneousPixel(position);
    return vec4(p.xyz / p.w, p.w);
}

vec4 homogeneousPerMetreUp() {
    return water.pixelFromRelative[1];
}

// Of what turns a point into its homogeneous pixel.
mat4 pixelRows() {
    return transpose(water.pixelFromRelative);
}

// Across the line of sight, of a square as large as a pixel that shows the point [m].
float pixelWidth(vec3 at) {
    mat4 rows = pixelRows();
    vec4 p = pixelOf(at);
    vec3 right = rows[0].xyz - p.x * rows[3].xyz;
    vec3 down = rows[1].xyz - p.y * rows[3].xyz;
    return p.w * inversesqrt(length(cross(right, down)));
}

// Covariance of slopes that are too short for the waves' maps: uu, vv, uv.
vec3 unresolvedSlopes() {
    return water.roughness.xyz;
}

// Standard deviation of all heights [m].
float heightDeviation() {
    return water.heightDeviation;
}

// Standard deviation of all slopes, those too short for the waves' maps as well, in the mean of both directions.
float slopeDeviation() {
    return water.roughness.w;
}

#endif
