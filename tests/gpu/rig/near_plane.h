// Which pixels of a view that stands half in the water have water before them, as the heights say.
#pragma once

#include "tests/gpu/rig/water_rig.h"

namespace tests {

struct NearPlaneCount {
    size_t wet = 0, dry = 0;
    size_t wrong = 0; ///< of both, where the picture says otherwise
};

/// Of each third row and seventh column: where the near plane lies at least `clear` metres off the surface.
NearPlaneCount countNearPlane(const WaterPicture& picture, const Camera& camera, const seaglass::Sea& sea,
                              double time, double clear);

} // namespace tests
