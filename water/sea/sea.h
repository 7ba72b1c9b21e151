// What a sea holds: its description, its cascades and their modes. Never changed once made.
#pragma once

#include "water/interface/sea_contents.h"
#include "water/interface/warp.h"
#include "water/sea/modes.h"
#include "water/shore/shore.h"

#include <array>
#include <optional>
#include <vector>

namespace seaglass {

struct Sea {
    Sea() = default;
    Sea(const Sea&) = delete;
    Sea& operator=(const Sea&) = delete;

    SeaDesc desc; ///< its table is the one below, and it has no shore
    std::vector<SpectrumSample> table;
    WaveSystems systems;
    uint32_t count = 0; ///< of cascades; 0 when flat
    std::array<Cascade, maxCascades> cascades;
    std::array<Modes, maxCascades> modes;
    Warp warp;
    double peak = 0;        ///< [rad/s]
    double variance = 0;    ///< of height [m^2]
    SlopeCovariance slopes; ///< of the modes
    SlopeCovariance roughness;
    std::optional<Shore> shore; ///< of a sea that is not flat
};

} // namespace seaglass
