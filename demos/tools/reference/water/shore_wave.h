// The waves that a bed guides to a shore, at one time: the sea's own trains, as the surface has them.
#pragma once

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// Not public: what a sea holds of its shore.
#include "water/sea/sea.h"

namespace demos::reference {

/// The surface that the trains make at a place, and what of the sea's own waves is left there.
struct ShoreWave {
    double height = 0;
    glm::dvec2 move{0}, slope{0};
    glm::dvec3 stretch{0};                            ///< dDx/du, dDz/dv, dDx/dv
    double swash = 0;                                 ///< how far the water's edge moves [m]
    double wetTo = -1e9;                              ///< the height up to which sand is wet [m]
    glm::dvec2 advected{0};                           ///< what the swash has carried foam to the side by [m]
    double rushes = 0;                                ///< how fast the water's edge rises [m/s]
    double broken = 0;                                ///< share of the waves
    double turns = 0;                                 ///< of the phase since the roller's toe passed
    double foamFades = 1;                             ///< e-folds a period
    std::array<double, seaglass::maxCascades> kept{}; ///< of each cascade's amplitude
    double depth = 0;                                 ///< of calm water [m]
    glm::dvec2 bedSlope{0};

    /// Where the surface's point comes to lie [m].
    double bed() const { return bedSlope.x * move.x + bedSlope.y * move.y - depth; }
    /// Cover of breakers' rollers and of what they leave; `bend`, -1..1, moves the toe.
    double surfFoam(double bend) const;
    /// Of a surface `lift` over wet sand, and elsewhere at `surface` [m].
    double withFilm(double surface, double lift) const {
        return wetTo > bed() ? std::max(surface, bed() + lift) : surface;
    }
};

class ShoreWaves {
  public:
    ShoreWaves(const seaglass::Shore& shore, double timeS, double foamDecayS)
        : shore_(shore), signal_(shore.signalAt(timeS, foamDecayS)) {}

    /// Without what is shorter than four `width`s [m].
    ShoreWave at(const glm::dvec2& calm, double width) const;

  private:
    struct Train;
    seaglass::ShorePlace placeAt(const glm::dvec2& calm) const;
    Train trainAt(size_t which, double arrival) const;

    const seaglass::Shore& shore_;
    seaglass::ShoreSignal signal_;
};

} // namespace demos::reference
