#include "scene/scene.h"

namespace demos {

namespace {

/// Of a visual range of 33 km over the water (Koschmieder 1924), as on a fair day at sea; its haze thins out
/// to 1/e in 2 km of height.
FogDesc clearAir(const WaterDesc& water) {
    FogDesc air;
    air.shape = "height";
    air.densityPerM = 3.912 / 33e3;
    air.falloffPerM = 1 / 2e3;
    air.baseHeightM = water.levelM;
    air.fromSky = 1;
    air.overSky = false;
    return air;
}

} // namespace

std::string_view photographicKey() {
    return "glitter";
}

void unsetPhotographicDefault(WaterDesc& water) {
    water.shading.glitter = -1;
}

void addPhotographicDefaults(Scene& scene) {
    if (!scene.water) return;
    WaterDesc& water = *scene.water;
    constexpr float likePhotographs = 0.8f; // by eye
    if (!scene.fog) scene.fog = clearAir(water);
    if (!water.saysGlitter) water.shading.glitter = likePhotographs;
    water.saysGlitter = true;
}

} // namespace demos
