// What is said in one way of two: the colour of water, and how much a camera shows.
#pragma once

namespace demos::reading {

inline constexpr const char* colorByTint[] = {"tint", "visibility_m"};
inline constexpr const char* colorByWater[] = {"type", "absorption_per_m", "backscatter_per_m"};
inline constexpr const char* shownByAngle[] = {"vertical_fov_deg"};
inline constexpr const char* shownByHeight[] = {"orthographic_height_m"};

} // namespace demos::reading
