// The sun and the sky over a body.
#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/body/part.h"
#include "water/light/sky_colors.h"

namespace seaglass {

namespace {

glm::vec4 color(const float (&values)[3]) {
    return {values[0], values[1], values[2], 0};
}

struct SkyPart {
    static bool wanted(const BodyDesc&, const Sea*) { return true; }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        const LightingDesc& lighting = *view.lighting;
        block.toSun = glm::vec4(glm::vec3(body.toSun(lighting)), 0);
        block.sunIrradiance = color(lighting.sunIrradiance);
        block.skyIrradiance = glm::vec4(glm::vec3(skyIrradiance(lighting, body.frame.worldFromBody[1])), 0);
        block.skyMips = static_cast<float>(lighting.skyCubeMipLevels);
        if (lighting.skyCube) return;
        block.skyZenith = color(lighting.skyZenith);
        block.skyHorizon = color(lighting.skyHorizon);
        block.skyGround = color(lighting.skyGround);
    }

    void vary(const Body&, const SurfaceDraw& draw, SurfaceVariant& variant) const {
        variant.skyHasColors = draw.lighting->skyCube == VK_NULL_HANDLE;
    }

    Status bind(Body& body, const BodyView& view, Resources& out) {
        const LightingDesc& lighting = *view.lighting;
        out.push_back({skyCubeBinding, gpu::sampledImage(body.context->samplers.trilinearClamp(),
                                                         lighting.skyCube, lighting.skyCubeLayout)});
        return Status::ok;
    }
};

} // namespace

Part skyPart() {
    return partFrom<SkyPart>();
}

} // namespace seaglass
