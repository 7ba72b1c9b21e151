// A sea that falls away as on a ball. The ball touches the calm plane at the foot of the eye, wherever that
// is: so waves, maps and height queries stay those of the plane, and only what a view shows of them sinks.
#pragma once

#include <algorithm>
#include <cmath>

namespace seaglass {

struct Globe {
    double curvature = 0; ///< 1 / radius [1/m]; 0: flat

    /// Of a radius [m]; 0: flat.
    static Globe of(double radius) { return {radius > 0 ? 1 / radius : 0}; }

    bool flat() const { return curvature == 0; }

    /// How far below the plane it lies, by the squared distance from the eye's foot along the plane; as
    /// shaders/water/mesh/globe.glsl. Exact, and without a difference of large numbers.
    double dropAt(double squaredDistance) const {
        const double drop = squaredDistance * curvature;
        return drop / (1 + std::sqrt(std::max(1 - drop * curvature, 0.0)));
    }

    /// How far it rises over a straight line between two of its points, which lie so far apart.
    double bulgeOver(double apart) const { return apart * apart * curvature / 8; }

    /// How far along the plane it is seen from a height above it; not where it is flat.
    double horizonFrom(double height) const {
        const double up = height * curvature;
        return height > 0 ? std::sqrt(up * (2 + up)) / (curvature * (1 + up)) : 0;
    }
};

} // namespace seaglass
