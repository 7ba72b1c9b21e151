// The screen mirror of reflection/mirror.h. A "screen point" is (x, y, depth, 1) in pixels of the view's region.

layout(set = 0, binding = 0, std140) uniform Mirror {
    mat4 screenMirror;
    mat4 relativeFromPixel;
    vec4 heightRow;
    vec4 weightRow;
    vec4 plane;   // relative to the eye, facing it
    ivec4 region; // origin in the scene images, size
    float farDepth;
    float depthSign;
    float edgeFadePixels;
    float infinityDepth;
};

const uint noKey = 0u;

// Where the plane shows a screen point; w <= 0 behind the camera. Its own inverse.
vec4 mirrored(vec3 screenPoint) {
    vec4 q = screenMirror * vec4(screenPoint, 1.0);
    return vec4(q.xyz / q.w, q.w);
}

// Signed height above the plane on the eye's side, in metres.
float heightAbovePlane(vec3 screenPoint) {
    vec4 p = vec4(screenPoint, 1.0);
    return dot(heightRow, p) / dot(weightRow, p);
}

// Relative to the eye.
vec3 unprojected(vec3 screenPoint) {
    vec4 p = relativeFromPixel * vec4(screenPoint, 1.0);
    return p.xyz / p.w;
}

// Heights under which a point counts as lying on the plane: what a depth buffer can no longer tell apart.
float contactHeight(vec3 screenPoint) {
    float distance = 1.0 / max(abs(dot(weightRow, vec4(screenPoint, 1.0))), 1e-20);
    return 1e-3 + 2e-5 * distance;
}

bool insideRegion(vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, vec2(region.zw)));
}

bool isFar(float depth) {
    return depthSign * (depth - farDepth) <= 0.0;
}

// Positive floats order like their bits; the nearest mirrored point must win an atomicMax whichever way depth runs.
uint keyFromDepth(float depth) {
    uint bits = floatBitsToUint(depth);
    return depthSign > 0.0 ? bits : ~bits;
}

float depthFromKey(uint key) {
    return uintBitsToFloat(depthSign > 0.0 ? key : ~key);
}
