// Places in what repeats.
#pragma once

#include <cmath>

namespace seaglass {

/// Where `position` lies in its tile, in tiles, 0..1: taken in double, since a float far from the origin
/// cannot say.
inline double inTile(double position, double tile) {
    const double tiles = position / tile;
    return tiles - std::floor(tiles);
}

} // namespace seaglass
