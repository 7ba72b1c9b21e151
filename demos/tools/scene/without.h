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

} // namespace demos
