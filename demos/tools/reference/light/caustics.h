// The sunlight that waves gather on what lies below them, by photons.
//
// They come from points of the sun's disc, stand evenly over the level, and go through the traced surface,
// whose slopes are the maps' own, tilted at random by what no map resolves. Each is followed to the opaque
// thing that stops it, so that shadows are theirs too. As many of them cross what a pixel sees as it has
// samples; they are followed only where the picture sees a bed that they light.
#pragma once

#include "reference/light/photon_map.h"
#include "reference/ray.h"

namespace demos::reference {

struct Frame;

class Caustics {
  public:
    /// Of a frame that is otherwise ready. Empty where the water is flat, for still water bends light evenly.
    void create(const Frame& frame);

    /// What a beam of the calm water's sun, which comes from `from`, is multiplied with at a point relative
    /// to the eye on a surface that faces `normal`, shadows included. Nothing where no photons were followed.
    std::optional<float> gainAt(const Frame& frame, const glm::vec3& position, const glm::vec3& normal,
                                const glm::vec3& from) const;

  private:
    PhotonMap photons_;
    float blur_ = 0; ///< how far around photons count, for each metre down the beam
};

} // namespace demos::reference
