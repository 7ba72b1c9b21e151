#include "reference/shade/wet_sand.h"

#include <algorithm>
#include <cmath>

#include "reference/frame.h"

namespace demos::reference {
namespace {

constexpr double dryingTimeS = 45;

/// A deep layer of grains that scatter more forwards in water, by the similarity parameter of van de Hulst
/// 1980; then what a skin of water turns back of what comes out (Lekner and Dorf 1988).
float soaked(float dry, float under) {
    constexpr float forwards = 1.7f, enters = 0.934f, turnedBack = 0.475f;
    const float similarity = (1 - dry) / (1 + 1.17f * dry), squared = similarity * similarity;
    const float deeper = std::sqrt(forwards * squared / (1 + (forwards - 1) * squared));
    const float within = (1 - deeper) / (1 + 1.17f * deeper);
    const float leaves = enters * (1 - turnedBack) / (1 - turnedBack * within);
    return within * std::lerp(leaves, 1.0f, under);
}

} // namespace

WettedShore wettedShore(const seaglass::Sea* sea, double timeS, const glm::dvec2& eye) {
    WettedShore out;
    const uint32_t rows = sea ? seaglass::shoreRowCount(*sea, dryingTimeS) : 0;
    if (rows == 0) return out;
    out.rows.resize(size_t{4} * rows);
    const double at[2] = {eye.x, eye.y};
    out.block = seaglass::shoreRows(*sea, timeS, dryingTimeS, at, out.rows.data());
    return out;
}

Look wetLookAt(const Frame& frame, const Hit& hit, const Footprint& footprint) {
    Look look = lookAt(hit, footprint);
    if (frame.shore.rows.empty() || look.unlit) return look;
    const seaglass::ShoreWetness wetness = seaglass::shoreWetness(
        *frame.world->sea, frame.shore.block, frame.shore.rows.data(), double{hit.position.x},
        double{hit.position.z}, double{frame.heightOf(hit.position)});
    // What is polished or painted takes no water up.
    const auto wet = static_cast<float>(wetness.wet) * glm::smoothstep(0.5f, 0.8f, look.roughness);
    const auto under = static_cast<float>(wetness.under);
    for (glm::vec3* const color : {&look.base, &look.diffuse})
        for (int i = 0; i < 3; ++i) (*color)[i] = std::lerp((*color)[i], soaked((*color)[i], under), wet);
    look.roughness = std::lerp(look.roughness, std::min(look.roughness, 0.35f), wet * wet * (1 - under));
    look.mirrored *= 1 - 0.5f * wet; // of index 1.33, not 1.5
    return look;
}

} // namespace demos::reference
