// The water's surface from within: Snell's window and total internal reflection, through the water before it.
#pragma once

#include "reference/shade/shade_water.h"

namespace demos::reference {

WaterRadiance shadeWaterBelow(const Frame& frame, const Ray& ray, const Hit& hit, int bounces,
                              Random* random);

} // namespace demos::reference
