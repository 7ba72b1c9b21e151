#include "program/render/aov_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scene/nearest.h"

namespace demos {

namespace {

constexpr std::array<std::pair<std::string_view, Aov>, 14> aovs = {{
    {"color", Aov::color},
    {"reflection", Aov::reflection},
    {"class", Aov::reflectionClass},
    {"height", Aov::height},
    {"normal", Aov::normal},
    {"foam", Aov::foam},
    {"depth", Aov::depth},
    {"reflection_source", Aov::reflectionSource},
    {"scene", Aov::scene},
    {"overlay_depth", Aov::overlayDepth},
    {"overlay_plane", Aov::overlayPlane},
    {"overlay_classes", Aov::overlayClasses},
    {"overlay_confidence", Aov::overlayConfidence},
    {"overlay_distance", Aov::overlayDistance},
}};

} // namespace

std::optional<Aov> parseAov(const std::string& option, const std::string& text, Error& error) {
    const auto found = std::ranges::find(aovs, text, &std::pair<std::string_view, Aov>::first);
    if (found != aovs.end()) return found->second;
    error.text = option + " is '" + text +
                 "', expected color, reflection, class, height, normal, foam, depth, reflection_source or "
                 "overlay_depth, _plane, _classes, _confidence, _distance; the nearest is " +
                 std::string(nearest(text, aovNames()));
    return std::nullopt;
}

std::vector<std::string_view> aovNames() {
    std::vector<std::string_view> names;
    for (const auto& [name, aov] : aovs) names.push_back(name);
    return names;
}

} // namespace demos
