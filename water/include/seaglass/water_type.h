// What water absorbs and scatters back, of real waters by name and of others by tint. No Vulkan.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// The waters that waterCoefficients() knows.
enum class WaterType : uint32_t {
    pool = 0,   ///< pure fresh water
    clearOcean, ///< far from land; 0.1 mg of chlorophyll in a cubic metre
    coastal,    ///< Jerlov's coastal type 1
    turbid,     ///< Jerlov's coastal type 5: harbours, estuaries
};

/// Per metre, at 650, 550 and 450 nm: red, green, blue.
struct WaterCoefficients {
    float absorption[3];  ///< RefractionDesc::absorption
    float backscatter[3]; ///< RefractionDesc::backscatter
};

/// Pure water absorbs by Pope and Fry (1997), and sends back half of what it scatters by Morel (1974, in
/// Mobley 1994), fresh water 1/1.3 of salt. Chlorophyll absorbs by Morel (1991), and sends back by Morel and
/// Maritorena (2001): 2 and 10 mg near the coast, where 1/1.25 (Gordon 1989) of Jerlov's attenuation of
/// daylight (1976, table XXVII) is absorption and backscatter. An unknown type is clearOcean.
constexpr WaterCoefficients waterCoefficients(WaterType type) {
    if (type == WaterType::pool) return {{0.340f, 0.0565f, 0.0092f}, {0.0004f, 0.0007f, 0.0017f}};
    if (type == WaterType::coastal) return {{0.355f, 0.0906f, 0.193f}, {0.0049f, 0.0054f, 0.0067f}};
    if (type == WaterType::turbid) return {{0.421f, 0.228f, 0.435f}, {0.0114f, 0.0119f, 0.0132f}};
    return {{0.345f, 0.0622f, 0.0253f}, {0.0011f, 0.0016f, 0.0030f}};
}

/// Of water that sends back `tint` of the light that enters where it is endlessly deep: linear, above 0, up
/// to 0.33 (named waters: 0.0004 to 0.05). Through `visibility` metres, 0.05..1000, 5 % of its clearest
/// channel pass (WMO's meteorological optical range). Channels scatter alike, unless one would have to absorb
/// over 100. False: a value is out of range, which `error` names; `out` is as before.
bool tintedWater(const float tint[3], float visibility, WaterCoefficients* out, SeaError* error);

} // namespace seaglass
