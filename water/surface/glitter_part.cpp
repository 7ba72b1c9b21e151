// The sun's path as single facets: shaders/water/surface/glitter.glsl.
#include <cmath>
#include <numbers>

#include "water/body/body.h"
#include "water/body/part.h"
#include "water/sea/phase.h"

namespace seaglass {

namespace {

/// Where an axis of the calm plane is, as it wraps [1/1024 m].
int32_t onLattice(double metres) {
    constexpr double repeat = 4194304; // of 2^32
    return static_cast<int32_t>(
        static_cast<int64_t>(std::floor((metres - repeat * std::floor(metres / repeat)) * 1024)));
}

struct GlitterPart {
    static bool wanted(const BodyDesc& desc, const Sea* sea) { return sea && desc.shading.glitter > 0; }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        const double loop = description(*body.sea).loopPeriod;
        // Of waves in deep water, which are as long as two cells.
        const double omega = std::sqrt(9.81 * std::numbers::pi);
        const glm::dvec3& eye = view.geometry.eye;
        block.glitter = {onLattice(eye.x), onLattice(eye.z),
                         static_cast<int32_t>(frequencyIndex(omega, loop)),
                         static_cast<int32_t>(loopPhase(body.simulatedTime, loop))};
        block.glitterShare.x = body.shading.glitter;
    }

    void vary(const Body&, const SurfaceDraw&, SurfaceVariant& variant) const { variant.hasGlitter = true; }
};

} // namespace

Part glitterPart() {
    return partFrom<GlitterPart>();
}

} // namespace seaglass
