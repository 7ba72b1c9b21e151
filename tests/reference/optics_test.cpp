// What Smith's masking by Gaussian slopes says, against the sum over those slopes.
#include <gtest/gtest.h>

#include "reference/shade/optics.h"

namespace {

using namespace demos::reference;

struct Seen {
    double area = 0;  ///< of the facets that face a direction, over level area
    double level = 0; ///< the same less what those show that face away
};

/// Midpoints over seven deviations to each side. Covariance (uu, vv, uv), as shaders have it.
Seen summed(const glm::vec3& direction, const glm::vec2& mean, const glm::vec3& covariance) {
    constexpr int across = 400;
    const float u = std::sqrt(covariance.x), v = std::sqrt(covariance.y);
    const double step = 14.0 / across;
    Seen seen;
    for (int y = 0; y < across; ++y)
        for (int x = 0; x < across; ++x) {
            const glm::vec2 off(u * static_cast<float>(-7 + step * (x + 0.5)),
                                v * static_cast<float>(-7 + step * (y + 0.5)));
            const double share = static_cast<double>(slopeDensity(off, covariance) * u * v) * step * step;
            const glm::vec2 slope = mean + off;
            const auto area = static_cast<double>(glm::dot(direction, glm::vec3(-slope.x, 1, -slope.y)));
            seen.area += share * std::max(area, 0.0);
            seen.level += share * area;
        }
    return seen;
}

/// Long waves run one way: masking is by the slopes along the line of sight, not by those of all.
TEST(Optics, MaskingIsBySlopesAlongTheLineOfSight) {
    const glm::vec3 covariance(0.04f, 0.01f, 0.008f);
    for (const glm::vec2 mean : {glm::vec2(0), glm::vec2(0.1f, -0.05f), glm::vec2(-0.15f, 0.1f)})
        for (const float elevation : {0.03f, 0.1f, 0.3f, 0.8f, 1.5f})
            for (const float azimuth : {0.0f, 0.7f, 1.6f, 3.0f, 4.5f}) {
                const glm::vec3 direction(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                                          std::cos(elevation) * std::sin(azimuth));
                const Seen seen = summed(direction, mean, covariance);
                const SlopesAlong along = slopesAlong(direction, mean, covariance);
                EXPECT_NEAR(static_cast<double>(visibleArea(along)), seen.area, 2e-4 + 2e-3 * seen.area)
                    << elevation << ' ' << azimuth << ' ' << mean.x;
                EXPECT_NEAR(static_cast<double>(clearShareOf(along)), std::max(seen.level, 0.0) / seen.area,
                            5e-3)
                    << elevation << ' ' << azimuth << ' ' << mean.x;
            }
}

TEST(Optics, StraightDownAllIsSeen) {
    const SlopesAlong along = slopesAlong({0, 1, 0}, {0.1f, 0}, {0.01f, 0.01f, 0});
    EXPECT_FLOAT_EQ(visibleArea(along), 1);
    EXPECT_FLOAT_EQ(clearShareOf(along), 1);
}

} // namespace
