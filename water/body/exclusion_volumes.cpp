#include "water/body/exclusion_volumes.h"
#include "water/interface/checks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace seaglass {

namespace {

constexpr glm::dvec4 nothingOutside{0, 0, 0, -1};

const char* readVolume(const ExclusionVolume& volume, ExclusionPlanes& out) {
    bool walled = false;
    for (size_t i = 0; i < exclusionVolumePlanes; ++i) {
        const auto& [x, y, z, d] = volume.planes[i];
        const double length = glm::length(glm::dvec3(x, y, z));
        if (!(length < 1e9) || !(std::abs(d) < 1e15)) return "ExclusionVolume.planes are not finite";
        if (length == 0 && d != 0) return "ExclusionVolume.planes has a plane without a normal";
        walled = walled || length > 0;
        out[i] = length > 0 ? glm::dvec4(x, y, z, d) / length : nothingOutside;
    }
    return walled ? nullptr : "ExclusionVolume.planes are all zeros, expected one plane or more";
}

} // namespace

const char* readExclusionVolumes(const ExclusionVolume* volumes, uint32_t count,
                                 std::vector<ExclusionPlanes>& out) {
    if (count > maxExclusionVolumes) return "setExclusionVolumes: count is out of range, expected 0 to 8";
    if (count > 0 && !volumes) return "setExclusionVolumes: volumes is null";
    std::vector<ExclusionPlanes> read(count);
    for (uint32_t i = 0; i < count; ++i)
        if (const char* bad = readVolume(volumes[i], read[i])) return bad;
    out = std::move(read);
    return nullptr;
}

const char* badVolumes(const ExclusionVolume* volumes, uint32_t count) {
    std::vector<ExclusionPlanes> read;
    return readExclusionVolumes(volumes, count, read);
}

uint32_t volumesPacked(const std::vector<ExclusionPlanes>& volumes) {
    return volumes.empty() ? 0 : std::bit_ceil(static_cast<uint32_t>(volumes.size()));
}

bool mayExcludeIn(const std::vector<ExclusionPlanes>& volumes, const glm::dvec3& low,
                  const glm::dvec3& high) {
    const auto reaches = [&](const glm::dvec4& plane) {
        const glm::dvec3 normal(plane);
        const glm::dvec3 innermost = glm::mix(high, low, glm::greaterThan(normal, glm::dvec3(0)));
        return glm::dot(normal, innermost) + plane.w <= 0;
    };
    return std::ranges::any_of(
        volumes, [&](const ExclusionPlanes& planes) { return std::ranges::all_of(planes, reaches); });
}

bool isExcluded(const std::vector<ExclusionPlanes>& volumes, const glm::dvec3& position) {
    return std::ranges::any_of(volumes, [&](const ExclusionPlanes& planes) {
        return std::ranges::all_of(
            planes, [&](const glm::dvec4& p) { return glm::dot(glm::dvec3(p), position) + p.w <= 0; });
    });
}

} // namespace seaglass
