// Where a body's water is kept out, as a part of it.
#include <algorithm>

#include <glm/geometric.hpp>

#include "water/body/body.h"
#include "water/body/part.h"

namespace seaglass {

namespace {

/// Its state is Body::exclusionVolumes, which the host sets whenever it likes.
struct ExclusionVolumesPart {
    static bool wanted(const BodyDesc&, const Sea*) { return true; }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        std::fill_n(block.exclusionPlanes,
                    volumesPacked(body.exclusionVolumes) * size_t{exclusionVolumePlanes},
                    glm::vec4(0, 0, 0, 1)); // holding nothing
        vec4* out = block.exclusionPlanes;
        for (const ExclusionPlanes& volume : body.exclusionVolumes)
            for (const glm::dvec4& plane : volume)
                *out++ =
                    glm::vec4(glm::vec3(plane), plane.w + glm::dot(glm::dvec3(plane), view.geometry.eye));
    }

    void vary(const Body& body, const SurfaceDraw&, SurfaceVariant& variant) const {
        variant.exclusionVolumes = volumesPacked(body.exclusionVolumes);
    }
};

} // namespace

Part exclusionVolumesPart() {
    return partFrom<ExclusionVolumesPart>();
}

} // namespace seaglass
