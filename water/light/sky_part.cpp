// The sun and the sky over a body.
#include <algorithm>
#include <cmath>

#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/body/part.h"
#include "water/light/sky_colors.h"

namespace seaglass {

namespace {

glm::vec4 color(const float (&values)[3]) {
    return {values[0], values[1], values[2], 0};
}

/// Of the sun's irradiance what enters calm water: exact dielectric reflectance, as optics.glsl has it.
double sunEnters(double up) {
    constexpr double index = 1.333;
    const double c = std::clamp(up, 0.0, 1.0);
    const double g = std::sqrt(index * index - 1 + c * c);
    const double a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
    return c * (1 - 0.5 * a * a * (1 + b * b));
}

struct SkyPart {
    static bool wanted(const BodyDesc&, const Sea*) { return true; }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        const LightingDesc& lighting = *view.lighting;
        const glm::dvec3 toSun = body.toSun(lighting);
        block.toSun = glm::vec4(glm::vec3(toSun), 0);
        block.sunIrradiance = color(lighting.sunIrradiance);
        block.sunIrradiance.a = static_cast<float>(sunEnters(toSun.y));
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
