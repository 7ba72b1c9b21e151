// Beaufort's scale: the mean wind of each force, and a fetch by which JONSWAP gives the sea its probable wave
// height (World Meteorological Organization, Manual on Marine Meteorological Services, 2018, for the open
// sea).
#include "seaglass/sea.h"

#include <algorithm>
#include <array>

namespace seaglass {
namespace {

struct Force {
    float wind;      ///< [m/s]
    float fetch;     ///< [m]
    float oldHeight; ///< of waves that the wind alone would not raise [m]
    float oldPeriod; ///< [s]
};

// Up to 5 the sea is fully developed. It is then still lower than the table's, which counts what earlier
// winds left: that is a swell here, of a steepness of 1/90 to 1/60. Gales do not blow for long enough over
// water enough.
constexpr std::array<Force, 13> scale = {{{0, 10e3f, 0, 12},
                                          {0.8f, 10e3f, 0.099f, 2},
                                          {2.4f, 20e3f, 0.157f, 3},
                                          {4.3f, 50e3f, 0.448f, 4},
                                          {6.7f, 60e3f, 0.24f, 3.8f},
                                          {9.3f, 100e3f, 0.71f, 6.4f},
                                          {12.3f, 132e3f, 0, 12},
                                          {15.5f, 153e3f, 0, 12},
                                          {18.9f, 198e3f, 0, 12},
                                          {23, 223e3f, 0, 12},
                                          {27, 272e3f, 0, 12},
                                          {31, 339e3f, 0, 12},
                                          {33, 436e3f, 0, 12}}};

} // namespace

SeaDesc beaufortSea(uint32_t force, float windDirection) {
    const Force& chosen = scale[std::min<size_t>(force, scale.size() - 1)];
    SeaDesc desc;
    desc.windSpeed = chosen.wind;
    desc.windDirection = windDirection;
    desc.fetch = chosen.fetch;
    desc.swells[0] = {.height = chosen.oldHeight,
                      .peakPeriod = chosen.oldPeriod,
                      .direction = windDirection,
                      .bandwidth = 0.15f,
                      .spreading = 15};
    return desc;
}

} // namespace seaglass
