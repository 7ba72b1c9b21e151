// Where a view has spray: one particle to a cell of square lattices that lie still on the calm plane, each
// twice as coarse as the one before and seen twice as far. Of each only what the view may show is drawn.
#pragma once

#include <array>
#include <cstdint>

#include "gpu/view/view.h"
#include "shaders/shared/spray/spray_block.h"
#include "water/mesh/extent.h"

namespace seaglass {

constexpr double finestSprayCell = 0.35; ///< [m]

struct SprayLevel {
    glm::dvec2 first{0}; ///< cell, of the plane: (u, v), whole numbers
    uint32_t alongU = 0, alongV = 0;
    double cell = 0;  ///< [m]
    double reach = 0; ///< how far from the eye it is seen [m]

    uint32_t count() const { return alongU * alongV; }
};

/// Of a view, at most `particles` in all: far levels are left out where it is wider than most.
struct SprayLattice {
    std::array<SprayLevel, sprayLevels> levels{};
    uint32_t count = 0; ///< of particles

    void fill(const glm::dvec3& eye, SprayBlock& block) const;
};

/// `eyeHeight`: above the calm plane. `displacement`: the most that waves move it by. `drift`: how far wind
/// carries spray from where it came from [m].
struct SprayView {
    const ViewGeometry& geometry;
    double eyeHeight = 0, displacement = 0, drift = 0;
};

SprayLattice sprayLattice(const SprayView& view, uint32_t particles);

} // namespace seaglass
