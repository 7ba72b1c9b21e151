#include "view/ui/water_controls.h"

#include <string>
#include <string_view>

#include <imgui.h>

#include "host/water/quality.h"
#include "view/field_widgets.h"
#include "view/ui/controls.h"

namespace demos {

namespace {

struct Force {
    uint32_t number;
    const char* name;
};
constexpr Force forces[] = {{WavesDesc::noForce, "by wind and fetch"},
                            {0, "0 calm"},
                            {1, "1 light air"},
                            {2, "2 light breeze"},
                            {3, "3 gentle breeze"},
                            {4, "4 moderate breeze"},
                            {5, "5 fresh breeze"},
                            {6, "6 strong breeze"},
                            {7, "7 near gale"},
                            {8, "8 gale"},
                            {9, "9 strong gale"},
                            {10, "10 storm"},
                            {11, "11 violent storm"},
                            {12, "12 hurricane"}};

bool chooseForce(uint32_t& force) {
    const Force* now = forces;
    for (const Force& candidate : forces)
        if (candidate.number == force) now = &candidate;
    bool changed = false;
    if (!ImGui::BeginCombo("Beaufort", now->name)) return false;
    for (const Force& candidate : forces) {
        if (!ImGui::Selectable(candidate.name, candidate.number == force)) continue;
        changed = candidate.number != force;
        force = candidate.number;
    }
    ImGui::EndCombo();
    return changed;
}

bool layOutWaves(WavesDesc& waves) {
    WavesDesc asNew;
    bool changed = chooseForce(waves.beaufort);
    ImGui::BeginDisabled(waves.beaufort != WavesDesc::noForce);
    changed |= layOutKeys("water.waves", {"wind_m_s", "fetch_m"}, &waves, &asNew);
    ImGui::EndDisabled();
    changed |= layOutKeys(
        "water.waves", {"wind_towards_deg", "spreading", "swell", "amplitude", "choppiness"}, &waves, &asNew);
    return changed;
}

bool layOutSwells(WavesDesc& waves) {
    bool changed = false;
    for (size_t i = 0; i < waves.swells.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        SwellDesc asNew;
        changed |= layOutAll("water.waves.swells", &waves.swells[i], &asNew);
        const bool removed = ImGui::Button("remove");
        ImGui::PopID();
        if (!removed) continue;
        waves.swells.erase(waves.swells.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
    }
    const size_t most = waves.beaufort == WavesDesc::noForce ? seaglass::maxSwells : seaglass::maxSwells - 1;
    if (waves.swells.size() >= most || !ImGui::Button("another swell")) return changed;
    waves.swells.emplace_back();
    return true;
}

/// A water has one colour: that of a type takes the place of any other.
bool layOutColour(RefractionDesc& refraction) {
    RefractionDesc asNew;
    const bool typed = layOutKeys("water.refraction", {"type"}, &refraction, &asNew);
    if (typed) {
        refraction.tint = asNew.tint;
        refraction.visibilityM = asNew.visibilityM;
        refraction.absorptionPerM = asNew.absorptionPerM;
        refraction.backscatterPerM = asNew.backscatterPerM;
    }
    return layOutKeys("water.refraction", {"distortion", "scattering_per_m"}, &refraction, &asNew) || typed;
}

/// Of a part whose settings lie in the water's.
template<class Part>
bool layOutBeside(const char* label, std::string_view section, WaterDesc& water, std::optional<Part>& part) {
    bool on = part.has_value();
    const bool switched = layOutSwitch(label, on);
    if (switched) part = on ? std::optional(Part{}) : std::nullopt;
    WaterDesc asNew;
    asNew.bed.emplace();
    asNew.caustics.emplace();
    asNew.spray.emplace();
    return (part && layOutAll(section, &water, &asNew)) || switched;
}

bool layOutBelow(WaterDesc& water) {
    bool refracts = water.refraction.has_value();
    bool changed = layOutSwitch("clear", refracts);
    if (changed) water.refraction = refracts ? std::optional(RefractionDesc{}) : std::nullopt;
    if (water.refraction) changed |= layOutColour(*water.refraction);
    return changed;
}

} // namespace

bool layOutReflection(seaglass::ReflectionDesc& reflection) {
    seaglass::ReflectionDesc asNew;
    return layOutAll("water.reflection", &reflection, &asNew);
}

bool layOutMirror(std::optional<seaglass::ReflectionDesc>& reflection) {
    return layOutPart("mirrors the scene", "water.reflection", reflection);
}

bool layOutWater(WaterDesc& water) {
    bool changed = false;
    if (water.waves && beginControls("Waves", true)) changed |= endControls(layOutWaves(*water.waves));
    if (water.waves && beginControls("Swell")) changed |= endControls(layOutSwells(*water.waves));
    if (water.waves && beginControls("Foam"))
        changed |= endControls(layOutPart("foam on breaking waves", "water.foam", water.foam));
    if (water.waves && beginControls("Spray"))
        changed |= endControls(layOutBeside("spray off breaking waves", "water.spray", water, water.spray));
    if (beginControls("Water", true)) changed |= endControls(layOutBelow(water));
    if (beginControls("Bed"))
        changed |= endControls(layOutBeside("drawn for refraction", "water.bed", water, water.bed));
    if (beginControls("Caustics"))
        changed |= endControls(layOutBeside("sunlight gathers", "water.caustics", water, water.caustics));
    if (beginControls("Under water"))
        changed |= endControls(layOutPart("seen from within", "water.underwater", water.underwater));
    return changed;
}

bool layOutQuality(WaterDesc& water) {
    bool changed = false;
    for (const std::string_view& quality : qualities()) {
        if (&quality != qualities().data()) ImGui::SameLine();
        if (!ImGui::SmallButton(std::string(quality).c_str())) continue;
        setQuality(quality, water);
        changed = true;
    }
    WaterDesc asNew;
    return layOutFields(sectionOf("water"), &water, &asNew) || changed;
}

} // namespace demos
