// Sand as the waves of a shore have wetted it.
#pragma once

#include <vector>

#include "reference/geometry.h"
#include "seaglass/shore.h"

namespace demos::reference {

struct Frame;

/// What shoreRows() says of one time; nothing without a shore.
struct WettedShore {
    seaglass::ShoreBlock block;
    std::vector<float> rows;
};
/// Places are relative to the eye's.
WettedShore wettedShore(const seaglass::Sea* sea, double timeS, const glm::dvec2& eye);

/// lookAt() as dark and smooth as water makes what is porous.
Look wetLookAt(const Frame& frame, const Hit& hit, const Footprint& footprint);

} // namespace demos::reference
