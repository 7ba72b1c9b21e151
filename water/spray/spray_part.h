// What wind tears off a body's crests.
#pragma once

#include "shaders/shared/spray/spray_block.h"
#include "water/body/part.h"
#include "water/spray/spray.h"
#include "water/spray/spray_lattice.h"

namespace seaglass {

struct SprayPart {
    SprayDesc desc;
    uint32_t particles = 0; ///< at most
    uint32_t breaking = 0;  ///< cascades
    double crestsRun = 0;   ///< in the mean, by what each cascade does of the breaking [m/s]
    glm::dvec2 blows{0};    ///< the air at the crests [m/s]
    uint32_t most = 0;      ///< the cascade that does most of the breaking
    double fading = 0;      ///< of the odds of its foam, to 1/e [s]
    float floor = 0;        ///< of that
    double torn = 0;        ///< share of what breaks

    static FieldError validate(const BodyDesc& desc);
    /// Only of a wind that tears drops off, and a sea that breaks.
    static bool wanted(const BodyDesc& desc, const Sea* sea);
    Status create(Body& body, const BodyDesc& of);
    /// Records nothing for eyes in the water.
    Status draw(Body& body, const DrawCall& call, DrawMoment moment) const;
    Status prepare(const Body& body, const PrepareCall& call) const;

  private:
    SprayVariant variant(const Body& body, const LightingDesc& lighting, bool straddles) const;
    SprayLattice lattice(const Body& body, const BodyView& view) const;
    /// Of the eye, downwind and across [m].
    glm::dvec2 placeInAir(const glm::dvec3& eye, double time) const;
    SprayBlock block(const BodyView& view, const SprayLattice& lattice, double time) const;
};

} // namespace seaglass
