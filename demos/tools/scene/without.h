// Water without one of its parts, and without what needs that part.
#pragma once

#include "scene/scene.h"

namespace demos {

inline void takeWaves(WaterDesc& water) {
    water.waves.reset();
    water.foam.reset();
    water.spray.reset();
    water.caustics.reset();
}

inline void takeRefraction(WaterDesc& water) {
    water.refraction.reset();
    water.bed.reset();
    water.underwater.reset();
    water.caustics.reset();
}

/// Of which the reference has none.
inline void takeUntraced(WaterDesc& water) {
    water.spray.reset();
    if (water.underwater) water.underwater->shafts = water.underwater->snow = 0;
}

} // namespace demos
