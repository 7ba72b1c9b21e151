// How the sea's wave vectors are dealt out to tiles of different sizes.
//
// Tiles and their bands do not depend on the number of samples, but where that is too small to carry a whole
// band, or a peak; so a sea of fewer samples is the same sea, truncated.
#pragma once

#include "water/interface/sea_contents.h"
#include "water/spectrum/wave_systems.h"

namespace seaglass {

/// Fills patch, samples, kMin and kMax of the first desc.cascades elements; bands touch and do not overlap.
/// The systems are not flat.
void layCascades(const SeaDesc& desc, const WaveSystems& systems, Cascade* cascades);

} // namespace seaglass
