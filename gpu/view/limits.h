// Limits that the public headers state.
#pragma once

#include <cstdint>

namespace seaglass {

constexpr uint32_t maxViews = 8;

} // namespace seaglass
