// What the surface's shaders are given.

#include "surface_uniforms.glsl"

// As the uniforms have them, but constant, so that loops over them are none.
layout(constant_id = 2) const int cascades = 0;
layout(constant_id = 3) const int foamCascades = 0;

struct MeshPatch {
    vec2 corner;
    float cell;
    float range;
#ifdef OUTLINE
    uvec2 edgeRange;   // the first of its edges, their number
#endif
};

// Of a mesh of the host's own.
struct HostVertex {
    vec2 calm;       // from its origin
    float cell;      // mean edge of the triangles around
    float fromEdge;  // distance from the mesh's border
};

layout(set = 0, binding = 1, std430) readonly buffer Patches {
#ifdef HOST_MESH
    HostVertex hostVertices[];
#else
    MeshPatch patches[];
#endif
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

#ifdef SHORE
#define SHORE_BINDING AFTER_WAVES
#define AFTER_SHORE (AFTER_WAVES + 2)
#include "shore.glsl"
#else
#define AFTER_SHORE AFTER_WAVES
#endif

#ifdef OUTLINE
#define EXTENT_BINDING AFTER_SHORE
#define AFTER_EXTENT (AFTER_SHORE + 1)
#include "extent.glsl"
#else
#define AFTER_EXTENT AFTER_SHORE
#endif

#ifdef MOTION
// A motion draw looks at no scene; in its place is where the last frame showed a point.
#define lastPixelFromRelative relativeFromPixel
#ifdef WAVES
layout(set = 0, binding = AFTER_EXTENT) uniform sampler2DArray lastDisplacement;
#endif
#endif

#ifdef FOAM
layout(set = 0, binding = AFTER_EXTENT) uniform sampler2D foamPattern;
layout(set = 0, binding = AFTER_EXTENT + 1) uniform sampler2DArray foamHistory;
#define AFTER_FOAM (AFTER_EXTENT + 2)
#else
#define AFTER_FOAM AFTER_EXTENT
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
layout(set = 0, binding = AFTER_REFLECTION + 2) uniform sampler2D bedColor;
layout(set = 0, binding = AFTER_REFLECTION + 3) uniform sampler2D bedDepth;
#define AFTER_REFRACTION (AFTER_REFLECTION + 4)
#else
#define AFTER_REFRACTION AFTER_REFLECTION
#endif

#ifdef SUN_SHADOW
#define SUN_SHADOW_BINDING AFTER_REFRACTION
#include "sun_shadow.glsl"
#endif
