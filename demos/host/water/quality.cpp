#include "host/water/quality.h"

#include <algorithm>
#include <array>

#include "scene/save.h"
#include "seaglass/water.h"

namespace demos {

namespace {

constexpr std::array<std::string_view, 4> names = {"low", "medium", "high", "highest"};

seaglass::Quality numbered(std::string_view quality) {
    return static_cast<seaglass::Quality>(std::ranges::find(names, quality) - names.begin());
}

/// What quality sets of a section and all that is in it.
void addGraded(const Section& section, void* owner, const std::string& path,
               std::vector<std::string>& overrides) {
    for (const Field& field : section.fields)
        if (field.row && field.row->graded)
            overrides.push_back(path + std::string(field.key) + "=" + valueText(field, owner));
    for (const Child& child : section.children)
        for (void* const there : child.access.there(owner))
            addGraded(*child.section, there, path + std::string(child.section->key) + ".", overrides);
}

} // namespace

std::span<const std::string_view> qualities() {
    return names;
}

void setQuality(std::string_view quality, WaterDesc& water) {
    seaglass::BodyDesc body;
    body.mesh = water.mesh;
    body.shading = water.shading;
    body.bed = water.bed ? &*water.bed : nullptr;
    seaglass::setQuality(numbered(quality), &body, water.reflection ? &*water.reflection : nullptr);
    water.mesh = body.mesh;
    water.shading = body.shading;
    if (water.bed) water.bedDrawn = body.bed;
}

std::vector<std::string> qualityOverrides(std::string_view quality, const WaterDesc& water) {
    WaterDesc set = water;
    setQuality(quality, set);
    std::vector<std::string> overrides;
    if (set.bed) overrides.push_back(set.bedDrawn ? "water.bed.drawn=true" : "water.bed.drawn=false");
    addGraded(sectionOf("water"), &set, "water.", overrides);
    return overrides;
}

} // namespace demos
