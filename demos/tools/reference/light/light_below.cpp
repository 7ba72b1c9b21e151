#include "reference/light/light_below.h"

#include <cmath>

#include "reference/shade/optics.h"

namespace demos::reference {
namespace {

constexpr int rings = 4, sectors = 8;

/// Even over the disc, which makes directions count by their cosine: `x` and `y` go from 0 to 1 over one
/// share of it.
glm::vec3 upwards(int ring, int sector, float x, float y) {
    const float squaredSine = (static_cast<float>(ring) + x) / rings, sine = std::sqrt(squaredSine);
    const float turn = (static_cast<float>(sector) + y) * (2 * pi / sectors);
    return {sine * std::cos(turn), std::sqrt(1 - squaredSine), sine * std::sin(turn)};
}

/// Mean radiance of the sky over one share.
glm::vec3 skyOver(const Light& light, int ring, int sector) {
    constexpr int finer = 8;
    glm::vec3 sum(0);
    for (int i = 0; i < finer; ++i)
        for (int j = 0; j < finer; ++j)
            sum += light.sky(upwards(ring, sector, (static_cast<float>(i) + 0.5f) / finer,
                                     (static_cast<float>(j) + 0.5f) / finer));
    return sum / static_cast<float>(finer * finer);
}

} // namespace

Beam enteringBeam(const glm::vec3& from, const glm::vec3& irradiance) {
    Beam beam;
    const float up = std::max(from.y, 0.0f);
    beam.from = {from.x / waterIndex, std::sqrt(1 - (1 - up * up) / (waterIndex * waterIndex)),
                 from.z / waterIndex};
    beam.irradiance = irradiance * ((1 - fresnelWater(up)) / beam.from.y);
    return beam;
}

SkyBeams skyBeams(const Light& light) {
    SkyBeams beams;
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector)
            beams[static_cast<size_t>(ring * sectors + sector)] = enteringBeam(
                upwards(ring, sector, 0.5f, 0.5f), skyOver(light, ring, sector) * (pi / (rings * sectors)));
    return beams;
}

} // namespace demos::reference
