#include "host/seaglass_view.h"

#include <algorithm>
#include <string_view>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace demos {
namespace {

seaglass::Image sampled(const Image& image) {
    return {image.view.get(), image.format, image.extent, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

} // namespace

seaglass::ViewDesc viewOf(const Camera& camera, const FrameTargets& targets) {
    seaglass::ViewDesc view;
    std::copy_n(glm::value_ptr(camera.view), 16, view.view);
    std::copy_n(glm::value_ptr(camera.toldProjection), 16, view.projection);
    std::copy_n(glm::value_ptr(camera.jitterPx), 2, view.jitter);
    view.cut = !camera.follows;
    view.viewport = {
        0, 0, static_cast<float>(targets.extent.width), static_cast<float>(targets.extent.height), 0, 1};
    view.sceneColor = sampled(targets.sceneColor);
    view.sceneDepth = sampled(targets.sceneDepth);
    return view;
}

seaglass::ViewDesc viewOf(const seaglass::PlanarView& drawn) {
    seaglass::ViewDesc view;
    std::ranges::copy(drawn.view, view.view);
    std::ranges::copy(drawn.projection, view.projection);
    view.viewport = drawn.viewport;
    view.sceneColor = {drawn.color, drawn.colorFormat, drawn.extent,
                       VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    view.sceneDepth = {drawn.depth, drawn.depthFormat, drawn.extent,
                       VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};
    return view;
}

seaglass::LightingDesc lightingOf(const Sky& sky) {
    seaglass::LightingDesc lighting;
    for (int i = 0; i < 3; ++i) {
        lighting.toSun[i] = sky.sun.direction[i];
        lighting.sunIrradiance[i] = static_cast<float>(sky.sun.irradiance[i]);
        lighting.skyIrradiance[i] = sky.irradianceUp[i];
    }
    lighting.skyCube = sky.cube.view.get();
    lighting.skyCubeMipLevels = sky.cube.mips;
    return lighting;
}

bool sunShadowOf(const ShadowPass& pass, const ShadowFits& fits, const glm::dvec3& eye,
                 seaglass::SunShadow& out) {
    out = {};
    out.map = {pass.mapAsArray(), pass.format(), pass.extent(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    out.cascadeCount = 0;
    for (uint32_t i = 0; i < shadowCascades; ++i) {
        if (!fits[i].enabled) continue;
        const glm::dvec2 corner = 0.5 * glm::dvec2(i & 1, i >> 1);
        const glm::dmat4 tile = glm::translate(glm::dmat4(1), glm::dvec3(corner + 0.25, 0)) *
                                glm::scale(glm::dmat4(1), glm::dvec3(0.25, 0.25, 1));
        const glm::dmat4 eyeFromWorld = glm::translate(glm::dmat4(1), -eye);
        const glm::dmat4 textureFromWorld = tile * glm::dmat4(fits[i].clipFromEye) * eyeFromWorld;
        const uint32_t at = out.cascadeCount++;
        std::copy_n(glm::value_ptr(textureFromWorld), 16, out.textureFromWorld[at]);
        const glm::vec4 bounds(corner, corner + 0.5);
        std::copy_n(glm::value_ptr(bounds), 4, out.bounds[at]);
        out.layers[at] = 0;
    }
    return out.cascadeCount > 0;
}

glm::dmat4 mistaken(const glm::dmat4& projection, Mistake mistake) {
    glm::dmat4 told = projection;
    if (mistake == Mistake::flippedY) told[1][1] = -told[1][1];
    if (mistake == Mistake::forwardDepth) {
        told[2][2] = -1;
        told[3][2] = -told[3][2];
    }
    return told;
}

seaglass::OverlayDesc overlayOf(Aov aov, const FrameTargets& targets) {
    seaglass::OverlayDesc desc;
    desc.kind = static_cast<seaglass::OverlayKind>(static_cast<uint32_t>(aov) -
                                                   static_cast<uint32_t>(Aov::overlayDepth));
    desc.target = {targets.overlay.view.get(), targets.overlay.format, targets.extent,
                   VK_IMAGE_LAYOUT_GENERAL};
    return desc;
}

} // namespace demos
