// What hides the sun from a body: the host's shadow map.
#include <glm/ext/matrix_transform.hpp>

#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/body/part.h"

namespace seaglass {

namespace {

struct SunShadowPart {
    static bool wanted(const BodyDesc&, const Sea*) { return true; }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        const LightingDesc& lighting = *view.lighting;
        const float(&sun)[3] = lighting.sunIrradiance;
        const bool shines =
            static_cast<float>(body.toSun(lighting).y) > 0 && (sun[0] != 0 || sun[1] != 0 || sun[2] != 0);
        if (!lighting.shadow || !shines) return;
        const SunShadow& shadow = *lighting.shadow;
        const glm::dmat4 worldFromRelative =
            glm::dmat4(body.frame.worldFromBody) * glm::translate(glm::dmat4(1), view.geometry.eye);
        for (uint32_t i = 0; i < shadow.cascadeCount; ++i) {
            const int at = static_cast<int>(i);
            const float(&b)[4] = shadow.bounds[i];
            block.shadowFromRelative[at] =
                glm::mat4(toMatrix(shadow.textureFromWorld[i]) * worldFromRelative);
            block.shadowBounds[at] = {b[0], b[1], b[2], b[3]};
            block.shadowLayers[at] = static_cast<float>(shadow.layers[i]);
        }
        block.shadow = {shadow.cascadeCount, shadow.reversedDepth ? -1 : 1, 0, 0};
    }

    void vary(const Body&, const SurfaceDraw& draw, SurfaceVariant& variant) const {
        variant.hasSunShadow = draw.lighting->shadow != nullptr;
    }

    Status bind(Body& body, const BodyView& view, Resources& out) {
        if (const SunShadow* shadow = view.lighting->shadow)
            out.push_back({sunShadowMapBinding, sampledTexels(*body.context, shadow->map)});
        return Status::ok;
    }
};

} // namespace

Part sunShadowPart() {
    return partFrom<SunShadowPart>();
}

} // namespace seaglass
