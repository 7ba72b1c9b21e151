#include <array>
#include <cstdint>

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

/// Ripples hide nothing, and looking takes a CPU device time.
bool wavesHideEachOther(const WavesDesc& waves) {
    constexpr double breeze = 5; // [m/s]: from Beaufort 4 on
    const bool blows = waves.beaufort == WavesDesc::noForce ? waves.windMps >= breeze : waves.beaufort >= 4;
    return blows && waves.amplitude >= 1;
}

constexpr std::array<PhotographicDefault, 2> defaults = {{
    {"glitter", &WaterDesc::saysGlitter, [](WaterDesc& water) { water.shading.glitter = -1; }},
    {"wave_shadow_steps", &WaterDesc::saysWaveShadows,
     [](WaterDesc& water) { water.shading.waveShadowSteps = UINT32_MAX; }},
}};

} // namespace

std::span<const PhotographicDefault> photographicDefaults() {
    return defaults;
}

void addPhotographicDefaults(Scene& scene) {
    if (!scene.water) return;
    WaterDesc& water = *scene.water;
    constexpr float likePhotographs = 0.8f; // by eye
    constexpr uint32_t asAtHigh = 8;
    if (!scene.fog) scene.fog = clearAir(water);
    if (!water.saysGlitter) water.shading.glitter = likePhotographs;
    water.saysGlitter = true;
    if (water.saysWaveShadows || !water.waves || !wavesHideEachOther(*water.waves)) return;
    water.shading.waveShadowSteps = asAtHigh;
    water.saysWaveShadows = true;
}

} // namespace demos
