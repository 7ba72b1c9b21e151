#include "seaglass/water_type.h"

#include <algorithm>
#include <cstdio>

namespace seaglass {
namespace {

constexpr double brightest =
    0.33; // of deepWater() in shaders/water/body/water_light.glsl, which this inverts
constexpr double mostPerMetre = 100;                 // RefractionDesc::absorption
constexpr double minusLogOfSeen = 2.995732273553991; // -ln 0.05

bool inRange(const float tint[3], float visibility, SeaError& error) {
    for (int c = 0; c < 3; ++c) {
        if (tint[c] > 0 && tint[c] <= static_cast<float>(brightest)) continue;
        std::snprintf(error.text, sizeof error.text,
                      "tintedWater: tint[%d] is %g; expected above 0, up to 0.33", c, double{tint[c]});
        return false;
    }
    if (visibility >= 0.05f && visibility <= 1000) return true;
    std::snprintf(error.text, sizeof error.text, "tintedWater: visibility is %g; expected 0.05 to 1000 m",
                  double{visibility});
    return false;
}

} // namespace

bool tintedWater(const float tint[3], float visibility, WaterCoefficients* out, SeaError* error) {
    SeaError unread;
    SeaError& told = error ? *error : unread;
    told = {};
    if (!tint || !out) {
        std::snprintf(told.text, sizeof told.text, "tintedWater: %s is null; expected %s",
                      tint ? "out" : "tint", tint ? "WaterCoefficients" : "red, green and blue");
        return false;
    }
    if (!inRange(tint, visibility, told)) return false;
    const double clearest = std::max({tint[0], tint[1], tint[2]});
    const double leastExtinction = minusLogOfSeen / double{visibility};
    for (int c = 0; c < 3; ++c) {
        const double extinction = std::min(leastExtinction * clearest / double{tint[c]}, mostPerMetre);
        const double backscatter = extinction * double{tint[c]} / brightest;
        out->absorption[c] = static_cast<float>(std::max(extinction - backscatter, 0.0));
        out->backscatter[c] = static_cast<float>(backscatter);
    }
    return true;
}

} // namespace seaglass
