// Where whitecaps are thick: in some of the places that show the largest tile, which are others for each of
// its copies, and others half a minute later. So foam, which stands out from the air as waves do not, shows
// no tile, and comes in groups as it does at sea. It is noise on a lattice in the tile's own plane, whose
// corners come and go by whole numbers of times in a loop: exact at any time. A sea without a warp, whose
// tiles repeat, has none.
#pragma once

#include <cstdint>

#include "seaglass/sea.h"

namespace seaglass {

/// Of all places and times.
constexpr double foamGateMean = 0.515;

class FoamGate {
  public:
    FoamGate() = default;
    FoamGate(const Sea& sea, double time);

    /// Share, 0..1, of the foam that is seen at a place [tiles].
    float at(double tilesU, double tilesV) const;
    float mean() const { return even_ ? 1.0f : static_cast<float>(foamGateMean); }

    /// Of the lattice across a tile: of three of the wind's waves each, or less. Where swell makes tiles far
    /// longer, cells of a share of them would part the sea into floes.
    int cells() const { return cells_; }
    /// The first cell, as it wraps, of the tile on which a place lies [tiles].
    int32_t firstCell(double tiles) const;

    /// How often a corner comes and goes in a loop, at the least; half as often again at most.
    uint32_t turns() const { return turns_; }
    uint32_t now() const { return now_; } ///< water/sea/phase.h: loopPhase

  private:
    float corner(uint32_t cellU, uint32_t cellV) const;

    bool even_ = true;
    int cells_ = 6;
    uint32_t turns_ = 1, now_ = 0;
};

} // namespace seaglass
