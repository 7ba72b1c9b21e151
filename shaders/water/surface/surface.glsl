// What the surface's shaders are given.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL

#include "body.glsl"
#include "surface_constants.h"
#include "wave_maps.glsl"
#include "wave_warp.glsl"

const bool isOutlined = shape == 1u;   // pixels within an outline are kept
const bool isHostMesh = shape == 2u;

// seaglass/water.h: SurfaceOutput
const uint outputShaded = 0;
const uint outputReflection = 1;
const uint outputClass = 2;
const uint outputHeight = 3;
const uint outputNormal = 4;
const uint outputFoam = 5;
const uint outputReflectionSource = 6;
const uint outputSlopes = 7;
// water/shading/shaded_surface.h: ShadingStep
const uint stepBed = 1;
const uint stepMirror = 2;
const uint stepRest = 3;
const bool writesLight = surfaceOutput <= outputReflection;   // and else figures, which no target encodes

struct MeshPatch {
    ivec2 corner;   // from meshOrigin [meshCell]
    float cell;
    float range;
};

struct OutlinedPatch {
    MeshPatch patch_;
    uvec2 edgeRange;   // the first of its edges, their number
};

// Of a mesh of the host's own.
struct HostVertex {
    vec2 calm;       // from its origin
    float cell;      // mean edge of the triangles around
    float fromEdge;  // distance from the mesh's border
};

// By shape, of which a surface has one.
layout(set = 0, binding = meshBinding, std430) readonly buffer Patches {
    MeshPatch patches[];
};
layout(set = 0, binding = meshBinding, std430) readonly buffer OutlinedPatches {
    OutlinedPatch outlinedPatches[];
};
layout(set = 0, binding = meshBinding, std430) readonly buffer HostVertices {
    HostVertex hostVertices[];
};

layout(set = 0, binding = lastDisplacementBinding) uniform sampler2DArray lastDisplacement;
layout(set = 0, binding = foamPatternBinding) uniform sampler2D foamPattern;
layout(set = 0, binding = foamHistoryBinding) uniform sampler2DArray foamHistory;
layout(set = 0, binding = reflectionColorBinding) uniform sampler2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding) uniform sampler2D reflectionInfo;
layout(set = 0, binding = sceneColorBinding) uniform sampler2D sceneColor;
layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;
layout(set = 0, binding = bedColorBinding) uniform sampler2D bedColor;
layout(set = 0, binding = bedDepthBinding) uniform sampler2D bedDepth;

#include "shore.glsl"
#include "extent.glsl"
#include "sun_shadow.glsl"

#endif
