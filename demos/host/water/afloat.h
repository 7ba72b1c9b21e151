// Things that float: heave, pitch and roll by the sea's heights over what of it they take up, at one moment.
// No mass, no memory: waves shorter than the thing lift it by their mean, and so hardly.
#pragma once

#include <memory>
#include <vector>

#include "host/water/waterplane.h"
#include "seaglass/sea.h"

namespace demos {

/// The heights of level water at one moment.
class WaterAt {
  public:
    /// Null: calm. The sea lives longer.
    WaterAt(const seaglass::Sea* sea, double timeS) : sea_(sea), timeS_(timeS) {}
    /// Over calm water, at each x and z [m].
    std::vector<double> heights(const std::vector<glm::dvec2>& places) const;

  private:
    struct Destroy {
        void operator()(seaglass::HeightGrid* grid) const { seaglass::destroyHeightGrid(grid); }
    };

    const seaglass::Sea* sea_ = nullptr;
    double timeS_ = 0;
    mutable std::unique_ptr<seaglass::HeightGrid, Destroy> grid_; ///< made when first asked
};

/// Lifted and leant, as the water over its waterplane is in the mean, from where it lies in calm water.
glm::dmat4 afloat(const glm::dmat4& worldFromMesh, const Waterplane& waterplane, const WaterAt& water);

} // namespace demos
