// A sea that falls away as on a ball, which touches the calm plane at the foot of the eye.
#pragma once

#include <algorithm>
#include <cmath>

namespace demos::reference {

struct Globe {
    double curvature = 0; ///< 1 / radius [1/m]; 0: flat

    bool flat() const { return curvature == 0; }

    /// How far below the plane it lies, by the squared distance from the eye's foot along the plane: the
    /// sagitta r - sqrt(r^2 - d^2), without a difference of large numbers.
    double dropAt(double squaredDistance) const {
        const double share = squaredDistance * curvature;
        return share / (1 + std::sqrt(std::max(1 - share * curvature, 0.0)));
    }

    /// How far along the plane it is seen from a height above it; not where it is flat.
    double horizonFrom(double height) const {
        if (height <= 0) return 0;
        const double radius = 1 / curvature;
        return std::sqrt(height * (2 * radius + height)) * radius / (radius + height);
    }
};

} // namespace demos::reference
