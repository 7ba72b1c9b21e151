#include "host/water/afloat.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace demos {

namespace {

constexpr double spacingM = 0.5; ///< of places asked about, at most, where there are fewer than
constexpr int mostAcross = 24;

int countAcross(double lengthM) {
    return std::clamp(static_cast<int>(std::ceil(lengthM / spacingM)), 2, mostAcross);
}

/// The middle of each of `count` equal parts, from -1 to 1.
double partOf(int i, int count) {
    return (2 * i + 1.0) / count - 1;
}

/// Sum of the squares of all parts.
double squares(int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += partOf(i, count) * partOf(i, count);
    return sum;
}

/// The least turn that takes the world's up to a unit normal.
glm::dmat4 leaning(const glm::dvec3& normal) {
    const glm::dvec3 axis = glm::cross(glm::dvec3(0, 1, 0), normal);
    const double sine = glm::length(axis);
    if (sine < 1e-12) return glm::dmat4(1);
    return glm::rotate(glm::dmat4(1), std::atan2(sine, normal.y), axis / sine);
}

} // namespace

std::vector<double> WaterAt::heights(const std::vector<glm::dvec2>& places) const {
    std::vector<double> heights(places.size());
    if (!sea_) return heights;
    if (!grid_) grid_.reset(seaglass::createHeightGrid(*sea_, timeS_));
    if (!grid_) return heights;
    std::vector<seaglass::HeightSample> samples(places.size());
    seaglass::sampleHeights(*grid_, &places.front().x, places.size(), samples.data());
    std::ranges::transform(samples, heights.begin(),
                           [](const seaglass::HeightSample& s) { return static_cast<double>(s.height); });
    return heights;
}

glm::dmat4 afloat(const glm::dmat4& worldFromMesh, const Waterplane& waterplane, const WaterAt& water) {
    const glm::dvec3 middle(worldFromMesh * glm::dvec4(waterplane.middle, 1));
    // Of half the waterplane, as long as it is in the world.
    const glm::dvec3 ahead = glm::dvec3(worldFromMesh[0]) * waterplane.half.x,
                     aside = glm::dvec3(worldFromMesh[2]) * waterplane.half.y;
    const int n = countAcross(2 * glm::length(ahead)), m = countAcross(2 * glm::length(aside));
    std::vector<glm::dvec2> places;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const glm::dvec3 at = middle + partOf(i, n) * ahead + partOf(j, m) * aside;
            places.emplace_back(at.x, at.z);
        }
    const std::vector<double> heights = water.heights(places);
    // The plane with the least squares: for walls that stand upright in the water, where its weight and
    // moments balance.
    double mean = 0, riseAhead = 0, riseAside = 0;
    for (size_t k = 0; k < heights.size(); ++k) {
        const auto across = static_cast<size_t>(m);
        mean += heights[k] / static_cast<double>(heights.size());
        riseAhead += heights[k] * partOf(static_cast<int>(k / across), n) / (squares(n) * m);
        riseAside += heights[k] * partOf(static_cast<int>(k % across), m) / (squares(m) * n);
    }
    const glm::dvec3 up(0, 1, 0);
    const glm::dvec3 normal = glm::normalize(up - ahead * (riseAhead / glm::dot(ahead, ahead)) -
                                             aside * (riseAside / glm::dot(aside, aside)));
    return glm::translate(glm::dmat4(1), middle + mean * up) * leaning(normal) *
           glm::translate(glm::dmat4(1), -middle) * worldFromMesh;
}

} // namespace demos
