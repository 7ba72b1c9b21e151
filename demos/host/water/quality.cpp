#include "host/water/quality.h"

#include <algorithm>
#include <array>

#include "host/seaglass_view.h"
#include "seaglass/water.h"

namespace demos {

namespace {

constexpr std::array<std::string_view, 4> names = {"low", "medium", "high", "highest"};

seaglass::Quality numbered(std::string_view quality) {
    return static_cast<seaglass::Quality>(std::ranges::find(names, quality) - names.begin());
}

void setQuality(seaglass::Quality quality, ReflectionDesc& desc) {
    seaglass::ReflectionDesc reflection;
    Error unknown; // the names of techniques were checked as the scene was read
    if (!reflectionOf(desc, "water", reflection, unknown)) return;
    const seaglass::ReflectionTechnique before = reflection.technique;
    seaglass::setQuality(quality, nullptr, &reflection);
    desc.downscale = reflection.downscale;
    desc.marchSteps = reflection.marchSteps;
    desc.roofLooks = reflection.roofLooks;
    desc.marchCells = reflection.marchCells;
    desc.coarseKeys = reflection.coarseKeys;
    if (reflection.technique == before) return;
    desc.technique = reflection.technique == seaglass::ReflectionTechnique::hybrid ? "hybrid" : "sspr";
}

} // namespace

std::span<const std::string_view> qualities() {
    return names;
}

void setQuality(std::string_view quality, WaterDesc& water) {
    seaglass::BodyDesc body;
    const seaglass::BedDesc bed;
    body.bed = &bed;
    seaglass::setQuality(numbered(quality), &body, nullptr);
    water.cellsPerLevel = body.mesh.cellsPerLevel;
    water.mirrorLooks = body.shading.mirrorLooks;
    water.refractionLooks = body.shading.refractionLooks;
    water.slopeLooks = body.shading.slopeLooks;
    water.waveShadowSteps = body.shading.waveShadowSteps;
    water.relief = body.shading.relief;
    if (water.bed) {
        water.bed->drawn = body.bed;
        water.bed->downscale = body.shading.bedDownscale;
    }
    if (water.caustics) water.caustics->stepPx = body.shading.causticStep;
    if (water.reflection) setQuality(numbered(quality), *water.reflection);
}

std::vector<std::string> qualityOverrides(std::string_view quality, const WaterDesc& water) {
    WaterDesc set = water;
    setQuality(quality, set);
    std::vector<std::string> overrides;
    const auto add = [&](const char* field, const std::string& value) {
        overrides.push_back(std::string("water.") + field + "=" + value);
    };
    add("cells_per_level", std::to_string(set.cellsPerLevel));
    add("mirror_looks", std::to_string(set.mirrorLooks));
    add("refraction_looks", std::to_string(set.refractionLooks));
    add("slope_looks", std::to_string(set.slopeLooks));
    add("wave_shadow_steps", std::to_string(set.waveShadowSteps));
    add("relief", set.relief ? "true" : "false");
    if (set.bed) {
        add("bed.drawn", set.bed->drawn ? "true" : "false");
        add("bed.downscale", std::to_string(set.bed->downscale));
    }
    if (set.caustics) add("caustics.step_px", std::to_string(set.caustics->stepPx));
    if (!set.reflection) return overrides; // an override would give it one
    add("reflection.technique", set.reflection->technique);
    add("reflection.downscale", std::to_string(set.reflection->downscale));
    add("reflection.march_steps", std::to_string(set.reflection->marchSteps));
    add("reflection.roof_looks", std::to_string(set.reflection->roofLooks));
    add("reflection.march_cells", set.reflection->marchCells ? "true" : "false");
    add("reflection.coarse_keys", set.reflection->coarseKeys ? "true" : "false");
    return overrides;
}

} // namespace demos
