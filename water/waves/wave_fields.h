// The sea's eight real fields as few complex ones. With d = choppiness / |k| they are made of h(k) as
//     Dx = i ku d h,  Dz = i kv d h,  dh/du = i ku h,  dh/dv = i kv h,
//     dDx/du = -ku^2 d h,  dDx/dv = -ku kv d h,  dDz/dv = -kv^2 d h.
// Two make one complex field; a slope is scaled by s = packing where it shares one with a length:
//     Dx + i s dDx/du = i ku (1 - s ku) d h,    h  + i s dh/du  = (1 - s ku) h,
//     Dz + i s dDx/dv = i (1 - s ku) kv d h,    dh/dv + i dDz/dv = i kv (1 - kv d) h.
// In a column of wave vectors ku is constant: five fields of it do, and h being real, those of the column -ku
// follow from them. So the transform along the columns is made of
//     0: h    1: d h    2: kv d h    3: kv (1 - kv d) h    4: kv (1 + kv d) h
// for ku >= 0 alone. At -ku the transforms of 0 and 1 are the conjugates, that of 2 the conjugate's negative,
// and that of 3 the negative conjugate of 4's.
#pragma once

#include "shaders/shared/wave_columns.h"
#include "water/sea/modes.h"

namespace seaglass {

constexpr uint32_t wavePairs = 4;

/// s [m], a power of two: what brings slopes to the size of heights, since the greater of a pair sets the
/// rounding of both.
float wavePacking(const Modes& modes);

} // namespace seaglass
