// What a CPU backend of waves is: it fills the maps of a sea's cascades.
#pragma once

#include "water/interface/sea_contents.h"

namespace seaglass {

/// One cascade's grid at one time: maps of samples*samples texels, four floats each, rows along v. Texel (i,
/// j) is at u = i patch/samples, v = j patch/samples, and at [(j*samples + i)*4]. The tile repeats; `warp`
/// shifts what lies where. h is the height, (Dx, Dz) the horizontal displacement, choppiness included.
struct CascadeMaps {
    float* displacement = nullptr; ///< Dx, h, Dz, dDx/dv (= dDz/du)            [m, m, m, 1]
    float* derivatives = nullptr;  ///< dh/du, dh/dv, dDx/du, dDz/dv            [1]
    float* moments = nullptr;      ///< (dh/du)^2, (dh/dv)^2, dh/du*dh/dv, dDx/dv: what shading needs beside
};

struct WavesBackend {
    const char* name = nullptr; ///< for people
    /// Makes what the backend keeps for a sea, which must outlive it. Null: out of memory. Any thread.
    void* (*create)(const Sea& sea) = nullptr;
    void (*destroy)(void* state) = nullptr; ///< of what create() made
    /// Fills all maps of one cascade. Calls with one state must not overlap. Not finite times count as 0.
    void (*evaluate)(void* state, uint32_t cascade, double time, const CascadeMaps& out) = nullptr;
};

} // namespace seaglass
