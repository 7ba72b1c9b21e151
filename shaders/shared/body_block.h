// One view of a body, for GLSL and C++ alike. Positions are metres relative to the eye in the body's axes
// (water/body/body_frame.h), +Y up; (u, v) are the calm plane's, x and z.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
#include "shaders/shared/below/marine_snow_lattice.h"
namespace seaglass {
#else
#include "marine_snow_lattice.h"
#endif

const int maxExclusionVolumes = 8;
const int exclusionVolumePlanes = 8;
const int maxShadowCascades = 4;
const int bodyWarpScales = 3;

struct BodyBlock {
    mat4 clipFromRelative;
    mat4 pixelFromRelative;
    mat4 relativeFromPixel; // of the scene's pixels; for motion, the last frame's pixels of points relative
                            // to this frame's eye
    vec4 cascade[4];        // eye's (u, v) in the tile, in tiles; 1 / patch; 1 / texel [1/m]
    vec4 warpAlong[bodyWarpScales]; // water/interface/warp.h: wave vectors along u, along v [turns/m]
    vec4 warpFrom[bodyWarpScales];  // of both, turns at the eye; eight amplitudes [m]
    ivec4 foamCell; // water/interface/foam_gate.h: the first cell of the tile that the eye is on; turns; now
    vec4 plane;     // up, and the eye's height [m]
    vec4 mirror;    // the eye's height over the mirrored plane [m], share of the reflection
    vec4 sight; // where lines of sight are parallel their direction, and 0; else 0, and 1: they come from the
                // eye
    vec4 toSun;
    vec4 sunIrradiance; // and what share of it enters calm water at the eye
    vec4 skyIrradiance;
    vec4 absorption; // and scattering by particles [1/m]
    vec4 backscatter;
    ivec4 region;   // origin in the scene images, size [pixel]
    float foamStep; // share of the way between the history's steps
    float foamAlbedo;
    vec2 foamPlace;      // of the eye in the pattern [m]
    vec4 foamDrift[4];   // (u, v) of a cascade's foam [tiles]; share of the way between the history's plumes
    vec4 foamGate;       // where place 0 lies past foamCell [cells]; cells a metre
    vec4 breaking;       // water/interface/whitecaps.h: now, nowWidth^2, hidden, narrower
    vec4 compression;    // likewise: along, foamBreaksApart
    vec4 breakingCounts; // likewise: counts
    vec4 windrows;       // as foamStreak, of the pattern's longest tile; the eye's place in it [m]
    vec4 roughness; // slope covariance that no cascade holds: uu, vv, uv; deviation of all slopes, mean of
                    // both directions
    float refractionDistortion;
    float reflectionDistortion;
    float farDepth;
    float depthSign; // +1 when nearer is greater
    float skyMips;
    float maxMip;          // of the waves' maps
    float reflectionScale; // pixels of the region to one of the reflection, each way
    int seaCascades;
    vec2 foamStreak;     // wind's direction, times sqrt(1 - 1/stretch) of the pattern
    vec2 sceneShift;     // to the scene's pixel that shows a point, whose sample may lie off its middle
    vec4 reflectionBlur; // clear distance [m], scatter, distance at which the sky has taken over [m]:
                         // reflection_blur.glsl
    ivec4 glitter;      // the eye's (u, v) as they wrap [1/1024 m]; turns of a cell of a metre in a loop; now
    vec4 glitterShare;  // ShadingDesc's glitter
    vec4 gusts;         // ShadingDesc's; slope variance along an axis that shelter takes; cells a metre
    ivec4 gustCell[2];  // of two generations the cell that the eye is on, as it wraps; their bits
    vec4 gustPlace[2];  // where on it [cells]; share of what shows
    float finestCell;   // edge [m]
    float halfMeniscus; // [m]
    float heightDeviation;  // of the waves [m]
    float parallelDistance; // of parallel_view.h [m]
    vec2 meshOrigin;        // (u, v) of a mesh of the host's own, or of the patches' lattice
    float perEdgeWidth;     // 1 / distance over which edges hold the waves [1/m]
    float globeCurvature;   // 1 / its radius [1/m]
    float meshCell;         // edge of that lattice's cells [m]
    float causticStrength;
    float pad0, pad1;
    vec4 shafts;                // strength; by how much of a depth waves blur them; SunInWater::turnedAcross
    vec4 snow;                  // share of its cells that hold something, turns of the waves that carry it
    ivec4 snowCells[snowSizes]; // of marine_snow_lattice.h: the first along each axis, as they wrap
    vec4 snowPlaces[snowSizes]; // that one's corner, a cell's edge [m]
    vec4 covered;               // (u, v) of the box around the body, low and high
    vec4 shorePlace;            // of the eye on the shore's map, and of a metre
    vec4 shoreSignal;           // rows a second, the first one's, their number; the map's spacing [m]
    vec4 shoreForm; // 1 / period; how far foam is carried for each metre of swash; the first row in the last
                    // frame; e-folds of breakers' foam in a period
    mat3x4 worldFromBody; // a column each
    mat4 bedFromRelative; // to pixels of the bed's picture
    mat4 relativeFromBed;
    ivec4 bedSize;  // of that picture [pixel]
    vec4 skyZenith; // radiance of a sky without a cube
    vec4 skyHorizon;
    vec4 skyGround;
    vec4 fogColor; // SeaglassFog of medium.glsl
    vec4 fogForm;
    vec4 fogReach;
    mat4 relativeFromFound; // of the pixels and depth of shaders/water/shading/found_surface.glsl
    vec4 found;             // how far waves move a point aside at the most [m]; 1 / that
    vec4 sunInWater;        // water/below/caustics.h: SunInWater::from
    vec4 sunTurned;         // likewise: turnedAlong, turnedAcross
    vec4 lostSlopes[2];     // likewise: LostSlopes
    ivec4 causticGrid;      // likewise, CausticGrid: step, margin, rowLength, firstRow
    vec4 shadowLayers;
    vec4 shadow; // cascades; 1, or -1 where what is nearer to the sun is greater
    mat4 shadowFromRelative[maxShadowCascades]; // to u, v and depth of each cascade
    vec4 shadowBounds[maxShadowCascades];       // lowest u and v, highest
    vec4 exclusionPlanes[maxExclusionVolumes *
                         exclusionVolumePlanes]; // of each volume: outside is positive [m]
};

#ifdef __cplusplus
}
#endif
