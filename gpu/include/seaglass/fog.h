// The host's fog: for the water's shading, and as numbers for the host's shaders, which include medium.glsl.
#pragma once

#include "seaglass/fields.h"

namespace seaglass {

/// What share of light `way` metres of fog let through.
enum class FogShape : uint32_t {
    linear = 1,         ///< (end - way) / (end - start), 0..1
    exponential,        ///< exp(-density way)
    exponentialSquared, ///< exp(-(density way)^2)
    height, ///< exp(-integral of density exp(-falloff (y - baseHeight)) along the way), y of the world
};
/// Its names, from 1 on.
inline constexpr const char* fogShapes[] = {"linear", "exponential", "exponential-squared", "height"};

/// Of one frame, in the air alone: LightingDesc::fog.
struct FogDesc {
    FogShape shape = FogShape::exponential; ///< says which of the next five are read
    float density = 1e-3f;                  ///< [1/m], 0..1000; of `height` at baseHeight
    float start = 0;                        ///< of `linear` [m], 0 or more and less than `end`
    float end = 1000;                       ///< likewise, up to 1e9
    float falloff = 0.01f;                  ///< of `height` [1/m], 0..10; 0: as `exponential`
    double baseHeight = 0;                  ///< of `height` [m], -1e6..1e6
    float color[3] = {0, 0, 0};             ///< radiance of endless fog; each finite, 0 or more
    float fromSky = 0;   ///< share of that which is the sky's own, where the line of sight ends, 0..1
    float most = 1;      ///< share of light that it takes at most, 0..1
    bool overSky = true; ///< the mirrored sky gets it too, as what is endlessly far; false: skyCube holds it
};

/// SeaglassFog of medium.glsl, in std140 and std430.
struct FogBlock {
    float color[4]; ///< FogDesc's; fromSky
    float form[4];  ///< density [1/m], falloff [1/m], falloff times the eye's height above baseHeight, most
    float reach[4]; ///< end [m]; 1 / (end - start) [1/m]; the FogShape; 1 where it lies over the sky
};

FogBlock fogBlock(const FogDesc& desc, double eyeHeight); ///< for an eye at that y of the world; any thread

/// Share of light that passes along `way` metres (1e9: endless) from y = `from`, which rise by `rise` metres.
/// As medium.glsl computes it, in double: 0..1. Fields that draw() would refuse count as the nearest end of
/// their range, what is no number as the lowest, and as 0 of the other arguments; so in fogBlock(). Any
/// thread.
double fogTransmittance(const FogDesc& desc, double from, double rise, double way);

} // namespace seaglass
