#include "water/light/lighting.h"

#include <cmath>

#include "gpu/interface/fields/fog.h"
#include "gpu/interface/fields/host.h"
#include "gpu/view/scene_formats.h"
#include "gpu/view/view.h"
#include "shaders/shared/body_block.h"

namespace seaglass {

namespace {

const char* badCascade(const SunShadow& shadow, uint32_t i) {
    if (!allFinite(toMatrix(shadow.textureFromWorld[i]))) return "SunShadow.textureFromWorld is not finite";
    const float(&b)[4] = shadow.bounds[i];
    if (!(b[0] >= 0 && b[1] >= 0 && b[2] > b[0] && b[3] > b[1] && b[2] <= 1 && b[3] <= 1))
        return "SunShadow.bounds is no part of a texture, expected 0 <= low < high <= 1";
    return nullptr;
}

static_assert(sunShadowFieldRows[0].high == maxShadowCascades);

FieldError badField(const SunShadow& shadow) {
    if (!shadow.map.view) return "SunShadow.map.view is null";
    if (!holdsDepth(shadow.map.format)) return FieldError("SunShadow.map.format").add(holdsNoDepth);
    if (!sampledIn(shadow.map.layout, true))
        return "SunShadow.map.layout is none to sample from, expected GENERAL or one that is read-only";
    if (shadow.map.samples != VK_SAMPLE_COUNT_1_BIT) return "SunShadow.map.samples is not 1";
    if (const FieldError bad = badField(sunShadowFields, &shadow)) return bad;
    for (uint32_t i = 0; i < shadow.cascadeCount; ++i)
        if (const char* bad = badCascade(shadow, i)) return bad;
    return nullptr;
}

/// Of a sky from a cube, or of one from colours: what is not read may hold anything.
bool reads(const LightingDesc& lighting, const Field& field) {
    if (isOf<&LightingDesc::skyCubeMipLevels>(field)) return lighting.skyCube;
    const bool ofColors = isOf<&LightingDesc::skyZenith>(field) || isOf<&LightingDesc::skyHorizon>(field) ||
                          isOf<&LightingDesc::skyGround>(field);
    return !ofColors || !lighting.skyCube;
}

/// Fields that its shape does not read may hold anything: they become those of a new one.
FogDesc whatIsRead(FogDesc fog) {
    const FogDesc asNew;
    const auto shape = static_cast<uint32_t>(fog.shape);
    for (const Field& field : fogFields)
        if (field.readBy != 0 && (shape > 31 || (field.readBy >> shape & 1u) == 0))
            field.set(&fog, 0, field.get(&asNew, 0));
    return fog;
}

FieldError badFog(const FogDesc& desc) {
    const FogDesc fog = whatIsRead(desc);
    if (const FieldError bad = badField(fogFields, &fog)) return bad;
    if (fog.start < fog.end) return {};
    return "FogDesc.start and end are no range, expected 0 <= start < end <= 1e9";
}

} // namespace

FieldError badField(const LightingDesc& lighting) {
    const auto readsField = [&](const Field& field) { return reads(lighting, field); };
    if (const FieldError bad = badField(lightingFields, &lighting, lightingFields.desc, readsField))
        return bad;
    if (lighting.skyCube && !sampledIn(lighting.skyCubeLayout, false))
        return "LightingDesc.skyCubeLayout is none to sample from, expected GENERAL or one that is read-only";
    double squared = 0;
    for (const double value : lighting.toSun) squared += value * value;
    if (!(std::abs(squared - 1) < 1e-3)) return "LightingDesc.toSun is not a unit vector";
    if (lighting.fog)
        if (const FieldError bad = badFog(*lighting.fog)) return bad;
    return lighting.shadow ? badField(*lighting.shadow) : nullptr;
}

uint32_t fogKind(const FogDesc* fog) {
    if (!fog) return 0;
    return static_cast<uint32_t>(fog->shape) | (fog->overSky ? 8u : 0u) | (fog->fromSky > 0 ? 16u : 0u);
}

} // namespace seaglass
