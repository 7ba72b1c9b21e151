// Keys that scenes once had. Files of then are read under the names of now, and without those that went.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace demos {

struct FormerKey {
    std::string_view section, before, now;
};

inline constexpr FormerKey formerKeys[] = {
    {"water", "dry_rooms", "exclusion_volumes"},
    {"water", "slope_looks", "slope_samples"},
    {"water", "mirror_looks", "reflection_samples"},
    {"water", "refraction_looks", "refraction_samples"},
    {"water", "relief", "parallax"},
    {"reflection", "roof_looks", "overhang_samples"},
};

/// Nothing takes their place.
struct GoneKey {
    std::string_view section, key, why;
};

inline constexpr GoneKey goneKeys[] = {
    {"water", "deferred", "every surface is found first and shaded once"},
};

/// Null where a section's key has not gone.
inline const GoneKey* goneKey(std::string_view section, std::string_view key) {
    const auto* const found = std::ranges::find_if(
        goneKeys, [&](const GoneKey& g) { return g.section == section && g.key == key; });
    return found == std::end(goneKeys) ? nullptr : found;
}

/// What a section's key is called now; itself if it never had another name.
inline std::string_view presentKey(std::string_view section, std::string_view key) {
    const auto* const found = std::ranges::find_if(
        formerKeys, [&](const FormerKey& f) { return f.section == section && f.before == key; });
    return found == std::end(formerKeys) ? key : found->now;
}

} // namespace demos
