// What the surface's shaders are given: water/surface.h. Positions are metres relative to the eye, +Y up; (u, v) are
// the calm plane's axes, world x and z.

layout(set = 0, binding = 0, std140) uniform Surface {
    mat4 clipFromRelative;
    mat4 pixelFromRelative;
    mat4 relativeFromPixel;
    vec4 cascade[4];   // eye's (u, v) in the tile, in tiles; 1 / patch; 1 / texel
    vec4 plane;        // up, and the eye's height
    vec4 toSun;
    vec4 sunIrradiance;
    vec4 skyIrradiance;
    vec4 absorption;
    vec4 backscatter;
    ivec4 region;      // origin in the scene images, size
    vec4 foam;         // share of the way between the history's steps, albedo, the eye's (u, v) in the pattern's tile
    vec4 roughness;    // slope covariance that no cascade holds, uu, vv, uv; deviation of all slopes
    float refractionDistortion;
    float reflectionDistortion;
    float farDepth;
    float depthSign;
    float skyMips;
    int cascades;
    float maxMip;
    float reflectionScale;   // pixels of the region to one of the reflection
    int foamCascades;
    vec3 reflectionLook;     // clear distance, scatter, distance of the sky: reflection_blur.glsl
};

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

// (x, y, depth) of a point in the region's pixels; w <= 0 behind the camera.
vec4 pixelOf(vec3 position) {
    vec4 p = pixelFromRelative * vec4(position, 1.0);
    return vec4(p.xyz / p.w, p.w);
}
