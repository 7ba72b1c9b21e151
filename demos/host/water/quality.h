// The library's quality presets, as it turns the settings of a scene's water.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace demos {

/// From the cheapest on, as the library numbers them.
std::span<const std::string_view> qualities();

/// What seaglass::setQuality() fills in, `quality` being one of qualities().
void setQuality(std::string_view quality, WaterDesc& water);

/// The same as overrides of the scene, which others may follow.
std::vector<std::string> qualityOverrides(std::string_view quality, const WaterDesc& water);

} // namespace demos
