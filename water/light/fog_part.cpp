// The fog before a body.
#include <glm/gtc/type_ptr.hpp>

#include "water/body/body.h"
#include "water/body/part.h"
#include "water/light/lighting.h"

namespace seaglass {

namespace {

struct FogPart {
    static bool wanted(const BodyDesc&, const Sea*) { return true; }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        if (!view.lighting->fog) return;
        const FogBlock fog = fogBlock(*view.lighting->fog, (body.frame.worldFromBody * view.geometry.eye).y);
        block.fogColor = glm::make_vec4(fog.color);
        block.fogForm = glm::make_vec4(fog.form);
        block.fogReach = glm::make_vec4(fog.reach);
    }

    void vary(const Body&, const SurfaceDraw& draw, SurfaceVariant& variant) const {
        variant.fogKind = fogKind(draw.lighting->fog);
    }
};

} // namespace

Part fogPart() {
    return partFrom<FogPart>();
}

} // namespace seaglass
