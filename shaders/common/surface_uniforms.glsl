// One view of a body: water/surface_uniforms.h. Positions are metres relative to the eye in the body's axes (water/body_frame.h),
// +Y up; (u, v) are the calm plane's, x and z.

// Loaded once, by loadSurface(): CPU devices load uniforms anew at each use.
mat4 clipFromRelative;
mat4 pixelFromRelative;
mat4 relativeFromPixel;   // of the scene's pixels
vec4 cascade[4];   // eye's (u, v) in the tile, in tiles; 1 / patch; 1 / texel
vec4 plane;   // up, and the eye's height
vec4 sight;   // where lines of sight are parallel their direction, and 0; else 0, and 1: they come from the eye
vec4 toSun;
vec4 sunIrradiance;
vec4 skyIrradiance;
vec4 absorption;   // and scattering by particles
vec4 backscatter;
ivec4 region;   // origin in the scene images, size
vec4 foam;   // share of the way between the history's steps, albedo, the eye's place in the pattern's tile
vec4 roughness;   // slope covariance that no cascade holds, uu, vv, uv; deviation of all slopes
float refractionDistortion;
float reflectionDistortion;
float farDepth;
float depthSign;
float skyMips;
float maxMip;
float reflectionScale;   // pixels of the region to one of the reflection
float foamStreakU;   // wind's direction, times sqrt(1 - 1/stretch) of the pattern
float foamStreakV;
vec3 reflectionLook;   // clear distance, scatter, distance of the sky: reflection_blur.glsl
vec4 within;   // metres: edge of the finest cells, half the meniscus, deviation of the waves' height; water/parallel_view.h: distance
vec2 sceneShift;   // to the scene's pixel that shows a point, whose sample may lie off its middle
vec4 extent;   // (u, v) of the origin of a mesh of the host's own; 1 / distance over which edges hold the waves; 1 / the globe's radius
vec4 caustics;   // strength
vec4 covered;   // (u, v) of the box around the body, low and high
vec4 shorePlace;    // of the eye on the shore's map, and of a metre
vec4 shoreSignal;   // rows a second, the first one's, their number; the map's spacing
vec4 shoreForm;     // 1 / period; how far foam is carried for each metre of swash; the first row in the last frame
mat3 worldFromBody;   // of directions
mat4 bedFromRelative;   // to pixels of the bed's picture
mat4 relativeFromBed;
ivec2 bedSize;   // of that picture
vec3 skyZenith;   // radiance of a sky without a cube
vec3 skyHorizon;
vec3 skyGround;

float sunSeen = 1.0;   // share of the sun's light that reaches the surface here

const uint dryRoomPlanes = 8;

layout(set = 0, binding = bodyBinding, std140) uniform Surface {
    mat4 clipFromRelative;
    mat4 pixelFromRelative;
    mat4 relativeFromPixel;
    vec4 cascade[4];
    vec4 plane;
    vec4 sight;
    vec4 toSun;
    vec4 sunIrradiance;
    vec4 skyIrradiance;
    vec4 absorption;
    vec4 backscatter;
    ivec4 region;
    vec4 foam;
    vec4 roughness;
    float refractionDistortion;
    float reflectionDistortion;
    float farDepth;
    float depthSign;
    float skyMips;
    int cascades;   // of the sea
    float maxMip;
    float reflectionScale;
    int foamCascades;   // of those, the first that break
    float foamStreakU;
    float foamStreakV;
    vec3 reflectionLook;
    vec4 within;
    vec2 sceneShift;
    vec4 extent;
    vec4 sunInWater;      // water/caustics.h: SunInWater::from
    vec4 sunTurned;       // likewise: turnedAlong, turnedAcross
    vec4 lostSlopes[2];   // water/caustics.h: LostSlopes
    ivec4 causticGrid;    // likewise: CausticGrid
    vec4 caustics;
    vec4 covered;
    vec4 shorePlace;
    vec4 shoreSignal;
    vec4 shoreForm;
    mat3 worldFromBody;
    vec4 dryPlanes[8 * dryRoomPlanes];
    mat4 shadowFromRelative[4];   // to u, v and depth of each cascade
    vec4 shadowBounds[4];         // lowest u and v, highest
    vec4 shadowLayers;
    vec4 shadow;                  // cascades; 1, or -1 where what is nearer to the sun is greater
    mat4 bedFromRelative;
    mat4 relativeFromBed;
    ivec2 bedSize;
    vec3 skyZenith;
    vec3 skyHorizon;
    vec3 skyGround;
    vec4 fogColor;   // SeaglassFog of medium.glsl
    vec4 fogForm;
    vec4 fogReach;
} stored;

// Before anything else.
void loadSurface() {
    clipFromRelative = stored.clipFromRelative;
    pixelFromRelative = stored.pixelFromRelative;
    relativeFromPixel = stored.relativeFromPixel;
    cascade = stored.cascade;
    plane = stored.plane;
    sight = stored.sight;
    toSun = stored.toSun;
    sunIrradiance = stored.sunIrradiance;
    skyIrradiance = stored.skyIrradiance;
    absorption = stored.absorption;
    backscatter = stored.backscatter;
    region = stored.region;
    foam = stored.foam;
    roughness = stored.roughness;
    refractionDistortion = stored.refractionDistortion;
    reflectionDistortion = stored.reflectionDistortion;
    farDepth = stored.farDepth;
    depthSign = stored.depthSign;
    skyMips = stored.skyMips;
    maxMip = stored.maxMip;
    reflectionScale = stored.reflectionScale;
    foamStreakU = stored.foamStreakU;
    foamStreakV = stored.foamStreakV;
    reflectionLook = stored.reflectionLook;
    within = stored.within;
    sceneShift = stored.sceneShift;
    extent = stored.extent;
    caustics = stored.caustics;
    covered = stored.covered;
    shorePlace = stored.shorePlace;
    shoreSignal = stored.shoreSignal;
    shoreForm = stored.shoreForm;
    worldFromBody = stored.worldFromBody;
    bedFromRelative = stored.bedFromRelative;
    relativeFromBed = stored.relativeFromBed;
    bedSize = stored.bedSize;
    skyZenith = stored.skyZenith;
    skyHorizon = stored.skyHorizon;
    skyGround = stored.skyGround;
}

// To a point along the line of sight on which it lies, of any length.
vec3 sightTo(vec3 at) {
    return at * sight.w + sight.xyz;
}

// How far away a point lies; of parallel lines, beyond the eye's own place on them.
float distanceTo(vec3 at) {
    return length(at * sight.w) + dot(at, sight.xyz);
}

// (x, y, depth) of a point in the region's pixels; w <= 0 behind the camera.
vec4 pixelOf(vec3 position) {
    vec4 p = pixelFromRelative * vec4(position, 1.0);
    return vec4(p.xyz / p.w, p.w);
}

// Across the line of sight, of a square as large as a pixel that shows the point [m].
float pixelWidth(vec3 at) {
    mat4 rows = transpose(pixelFromRelative);
    vec4 p = pixelOf(at);
    vec3 right = rows[0].xyz - p.x * rows[3].xyz;
    vec3 down = rows[1].xyz - p.y * rows[3].xyz;
    return p.w * inversesqrt(length(cross(right, down)));
}
