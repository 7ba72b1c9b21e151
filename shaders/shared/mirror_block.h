// The screen mirror of reflection/core/mirror.h, for GLSL and C++ alike. A "screen point" is (x, y, depth, 1)
// in pixels of the view's region.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

struct MirrorBlock {
    mat4 screenMirror;      // to where the plane shows a screen point of the scene, w <= 0 behind the camera
    mat4 sceneFromPixel;    // its inverse
    mat4 relativeFromPixel; // of a reflection's pixel and depth
    mat3x4 skyFromPixel;    // to where the far end of the mirrored ray shows, w <= 0 nowhere
    vec4 heightRow;         // of a screen point p: height is heightRow.p / weightRow.p
    vec4 weightRow;
    vec4 depthRow; // of sceneFromPixel: w times depth less infinityDepth, made before the digits they share
                   // are rounded
    vec4 plane;    // relative to the eye, facing it
    ivec4 region;  // origin in the scene images, size
    ivec4 shown;   // pixels of the region that may show the mirror: low, and one past high
    float farDepth;
    float depthSign; // +1 when nearer is greater
    float edgeFadePixels;
    float infinityDepth;
    uint bent;      // looked up away from where the plane is seen
    int pixelShift; // log2 of the pixels of the region to one of the reflection, each way: integers divide
                    // slowly
    int keyShift;   // and to one key
    float contactPerMetre; // see onOrBelowPlane() of shaders/reflection/core/mirror.glsl
    float depthStep;       // scene depths closer than this may be held as one
    uint followed;         // rays are followed afterwards where nothing is proven
    float undersideLight;  // share of the top's colour that stands for what lies under it
    uint overhangSamples;  // for what hangs over the mirror
    float edgeFadeApart;   // by which borders that are not ahead are taken to be farther away [pixel]
    float pad0, pad1, pad2;
};

#ifdef __cplusplus
}
#endif
