// What the surface's shaders are given.

#include "surface_uniforms.glsl"

struct MeshPatch {
    vec2 corner;
    float cell;
    float range;
};

layout(set = 0, binding = 1, std430) readonly buffer Patches {
    MeshPatch patches[];
};

layout(set = 0, binding = 2) uniform samplerCube skyCube;

// Bindings follow on each other without gaps, so that a surface without a feature has none for it.
#ifdef WAVES
layout(set = 0, binding = 3) uniform sampler2DArray waveDisplacement;
layout(set = 0, binding = 4) uniform sampler2DArray waveDerivatives;
layout(set = 0, binding = 5) uniform sampler2DArray waveMoments;
#define AFTER_WAVES 6
#else
#define AFTER_WAVES 3
#endif

#ifdef FOAM
layout(set = 0, binding = AFTER_WAVES) uniform sampler2D foamPattern;
layout(set = 0, binding = AFTER_WAVES + 1) uniform sampler2DArray foamHistory;
#define AFTER_FOAM (AFTER_WAVES + 2)
#else
#define AFTER_FOAM AFTER_WAVES
#endif

#ifdef REFLECTION
layout(set = 0, binding = AFTER_FOAM) uniform sampler2D reflectionColor;
layout(set = 0, binding = AFTER_FOAM + 1) uniform sampler2D reflectionInfo;
#define AFTER_REFLECTION (AFTER_FOAM + 2)
#else
#define AFTER_REFLECTION AFTER_FOAM
#endif

#ifdef REFRACTION
layout(set = 0, binding = AFTER_REFLECTION) uniform sampler2D sceneColor;
layout(set = 0, binding = AFTER_REFLECTION + 1) uniform sampler2D sceneDepth;
#endif
