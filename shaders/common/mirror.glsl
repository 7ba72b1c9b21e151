// The screen mirror of reflection/mirror.h. A "screen point" is (x, y, depth, 1) in pixels of the view's region.

#include "texel_at.glsl"

// Loaded once, by loadMirror(): CPU devices load uniforms anew at each use and in each turn of a loop.
mat4 screenMirror;   // to where the plane shows a screen point of the scene, w <= 0 behind the camera
mat4 sceneFromPixel; // its inverse
mat4 relativeFromPixel;  // of a reflection's pixel and depth
mat3x4 skyFromPixel;     // to where the far end of the mirrored ray shows, w <= 0 nowhere
vec4 heightRow;
vec4 weightRow;
vec4 depthRow;   // of sceneFromPixel: w times depth less infinityDepth, made before the digits they share are rounded
vec4 plane;   // relative to the eye, facing it
ivec4 region; // origin in the scene images, size
ivec4 shown;  // pixels of the region that may show the mirror: low, and one past high
float farDepth;
float depthSign;
float edgeFadePixels;
float infinityDepth;
bool bent;        // looked up away from where the plane is seen
// Powers of two, since integers divide slowly.
int pixelShift;   // pixels of the region to one of the reflection, each way
int keyShift;     // and to one key
float contactPerMetre;   // see onOrBelowPlane()
float depthStep;         // scene depths closer than this may be held as one
float undersideLight;    // share of the top's colour that stands for what lies under it
uint roofLooks;          // for what hangs over the mirror
float edgeFadeApart;     // see edgeConfidence()
bool followed;           // rays are followed afterwards where nothing is proven

layout(set = 0, binding = 0, std140) uniform Mirror {
    mat4 screenMirror;
    mat4 sceneFromPixel;
    mat4 relativeFromPixel;
    mat3x4 skyFromPixel;
    vec4 heightRow;
    vec4 weightRow;
    vec4 depthRow;
    vec4 plane;
    ivec4 region;
    ivec4 shown;
    float farDepth;
    float depthSign;
    float edgeFadePixels;
    float infinityDepth;
    bool bent;
    int pixelShift;
    int keyShift;
    float contactPerMetre;
    float depthStep;
    bool followed;
    float undersideLight;
    uint roofLooks;
    float edgeFadeApart;
} stored;

// Before anything else.
void loadMirror() {
    screenMirror = stored.screenMirror;
    sceneFromPixel = stored.sceneFromPixel;
    relativeFromPixel = stored.relativeFromPixel;
    skyFromPixel = stored.skyFromPixel;
    heightRow = stored.heightRow;
    weightRow = stored.weightRow;
    depthRow = stored.depthRow;
    plane = stored.plane;
    region = stored.region;
    shown = stored.shown;
    farDepth = stored.farDepth;
    depthSign = stored.depthSign;
    edgeFadePixels = stored.edgeFadePixels;
    infinityDepth = stored.infinityDepth;
    bent = stored.bent;
    pixelShift = stored.pixelShift;
    keyShift = stored.keyShift;
    contactPerMetre = stored.contactPerMetre;
    depthStep = stored.depthStep;
    followed = stored.followed;
    undersideLight = stored.undersideLight;
    roofLooks = stored.roofLooks;
    edgeFadeApart = stored.edgeFadeApart;
}

// The reflection's pixels, and its keys'.
ivec2 imageSize() {
    return (region.zw + (1 << pixelShift) - 1) >> pixelShift;
}

ivec2 keyGrid() {
    return (region.zw + (1 << keyShift) - 1) >> keyShift;
}

// The middle of a pixel of the reflection, in the region's pixels.
vec2 middleOf(ivec2 imagePixel) {
    return (vec2(imagePixel) + 0.5) * float(1 << pixelShift);
}

const uint noKey = 0u;

// Relative to the eye.
vec3 unprojected(vec3 screenPoint) {
    vec4 p = relativeFromPixel * vec4(screenPoint, 1.0);
    return p.xyz / p.w;
}

// Heights under which a point counts as lying on the plane: what a depth buffer can no longer tell apart, 1 mm and what
// contactPerMetre says for each metre of distance, 20 micrometres or a step of the depth's format. Both sides of height <
// contact are linear in a screen point once they are multiplied by its weight, and so tell of points at infinity too:
// below the plane's horizon or above it.
vec4 aboveRow() {
    return heightRow - 1e-3 * weightRow - vec4(0.0, 0.0, 0.0, contactPerMetre);
}

bool onOrBelowPlane(vec3 screenPoint) {
    return dot(aboveRow(), vec4(screenPoint, 1.0)) <= 0.0;
}

// Deeper under the plane than it is told apart.
bool wellBelowPlane(vec3 screenPoint) {
    vec4 p = vec4(screenPoint, 1.0);
    return dot(heightRow, p) < -(1e-3 * dot(weightRow, p) + contactPerMetre);
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
