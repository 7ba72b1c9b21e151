// Pictures by the host, for tests that hold them beside the reference's.
#pragma once

#include "host/host.h"

namespace tests {

/// Of a scene's first camera, by 3 x 3 samples a pixel, as the reference averages what a pixel sees.
demos::Picture rendered(demos::Host& host, const demos::Scene& scene, uint32_t width, uint32_t height);

} // namespace tests
