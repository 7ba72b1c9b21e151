// Convex hollows that the water stays out of.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "reference/water/level_axes.h"
#include "seaglass/water.h"

namespace demos::reference {

/// What holds nothing is walled by zeros, inside of which all lies.
using ExcludedVolume = std::array<glm::dvec4, std::size(seaglass::ExclusionVolume{}.planes)>;

/// Of a usable one, in the water's axes.
inline ExcludedVolume excludedVolumeOf(const seaglass::ExclusionVolume& volume, const LevelAxes& axes) {
    ExcludedVolume excluded;
    for (size_t i = 0; i < excluded.size(); ++i) {
        const auto& [x, y, z, d] = volume.planes[i];
        excluded[i] = glm::dvec4(axes.fromWorld({x, y, z}), d);
    }
    return excluded;
}

inline bool isExcluded(const std::vector<ExcludedVolume>& volumes, const glm::dvec3& position) {
    return std::ranges::any_of(volumes, [&](const ExcludedVolume& excluded) {
        return std::ranges::all_of(
            excluded, [&](const glm::dvec4& wall) { return glm::dot(wall, glm::dvec4(position, 1)) <= 0; });
    });
}

} // namespace demos::reference
