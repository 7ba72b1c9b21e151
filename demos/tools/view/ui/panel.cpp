#include "view/ui/panel.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include <imgui.h>

#include "host/water/quality.h"
#include "view/field_widgets.h"

namespace demos {

namespace {

/// True once a change is complete: a slider is let go.
bool slider(const char* label, double& value, double least, double most, const char* format,
            ImGuiSliderFlags flags = 0) {
    ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &least, &most, format,
                        flags | ImGuiSliderFlags_AlwaysClamp);
    return ImGui::IsItemDeactivatedAfterEdit();
}

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

/// One of the scene's fields, by its path.
bool layOutNamed(const char* section, std::string_view key, void* owner, void* asNew) {
    return layOutField(*std::ranges::find(sectionOf(section).fields, key, &Field::key), owner, asNew);
}

bool layOutSea(WavesDesc& waves) {
    WavesDesc asNew;
    const auto field = [&](std::string_view key) { return layOutNamed("water.waves", key, &waves, &asNew); };
    bool changed = chooseForce(waves.beaufort);
    ImGui::BeginDisabled(waves.beaufort != WavesDesc::noForce);
    changed |= field("wind_m_s");
    changed |= field("fetch_m");
    ImGui::EndDisabled();
    changed |= field("wind_towards_deg");
    changed |= field("amplitude");
    changed |= field("choppiness");
    return changed;
}

bool layOutReflection(seaglass::ReflectionDesc& reflection) {
    seaglass::ReflectionDesc asNew;
    return layOutFields(sectionOf("water.reflection"), &reflection, &asNew);
}

bool layOutMirror(std::optional<seaglass::ReflectionDesc>& reflection) {
    bool mirrors = reflection.has_value();
    const bool switched = ImGui::Checkbox("mirrors the scene", &mirrors);
    if (switched) reflection = mirrors ? std::optional(seaglass::ReflectionDesc{}) : std::nullopt;
    return (reflection && layOutReflection(*reflection)) || switched;
}

/// Under a heading of its own.
bool layOutSection(const char* heading, const char* path, void* owner, void* asNew) {
    ImGui::Separator();
    ImGui::TextUnformatted(heading);
    ImGui::PushID(heading);
    const bool changed = layOutFields(sectionOf(path), owner, asNew);
    ImGui::PopID();
    return changed;
}

/// The preset, then what it set, each of which may be changed.
bool layOutQuality(WaterDesc& water) {
    bool changed = false;
    for (const std::string_view& quality : qualities()) {
        if (&quality != qualities().data()) ImGui::SameLine();
        if (!ImGui::Button(std::string(quality).c_str())) continue;
        setQuality(quality, water);
        changed = true;
    }
    WaterDesc asNew;
    changed |= layOutFields(sectionOf("water"), &water, &asNew);
    asNew.bed.emplace();
    asNew.caustics.emplace();
    asNew.spray.emplace();
    if (water.bed) changed |= layOutSection("bed", "water.bed", &water, &asNew);
    if (water.caustics) changed |= layOutSection("caustics", "water.caustics", &water, &asNew);
    if (water.spray) changed |= layOutSection("spray", "water.spray", &water, &asNew);
    return changed;
}

std::optional<seaglass::ReflectionDesc>* reflectionOf(Scene& scene) {
    if (scene.water) return &scene.water->reflection;
    return scene.floor ? &scene.floor->reflection : nullptr;
}

bool layOutSun(Scene& scene) {
    SunDesc asNew;
    const auto field = [&](std::string_view key) { return layOutNamed("sun", key, &scene.sun, &asNew); };
    bool changed = field("from_sky");
    ImGui::BeginDisabled(scene.sun.fromSky);
    changed |= field("azimuth_deg");
    changed |= field("elevation_deg");
    ImGui::EndDisabled();
    return changed;
}

bool layOutSplit(std::optional<Split>& split, const std::optional<seaglass::ReflectionDesc>& own) {
    bool on = split.has_value();
    bool changed = ImGui::Checkbox("split the picture", &on);
    if (changed) split = on ? std::optional(Split{own.value_or(seaglass::ReflectionDesc{})}) : std::nullopt;
    if (!split) return changed;
    slider("at", split->at, 0, 1, "%.2f");
    changed |= ImGui::Checkbox("ray-traced reference", &split->reference);
    if (split->reference) return changed;
    ImGui::PushID("right half");
    changed |= layOutReflection(split->reflection);
    ImGui::PopID();
    return changed;
}

/// The line between the halves.
void drawSplit(const Split& split, uint32_t width, uint32_t height) {
    const auto x = static_cast<float>(leftColumns(split, width));
    ImGui::GetBackgroundDrawList()->AddLine({x, 0}, {x, static_cast<float>(height)},
                                            IM_COL32(255, 255, 255, 160));
}

struct NamedOutput {
    Aov aov;
    const char* name;
};
constexpr NamedOutput outputs[] = {{Aov::color, "color"},
                                   {Aov::reflection, "reflection, before Fresnel"},
                                   {Aov::reflectionClass, "class of each pixel"},
                                   {Aov::height, "height"},
                                   {Aov::normal, "normal"},
                                   {Aov::foam, "foam"},
                                   {Aov::scene, "scene without water"},
                                   {Aov::overlayDepth, "overlay: depth"},
                                   {Aov::overlayPlane, "overlay: plane"},
                                   {Aov::overlayClasses, "overlay: classes"},
                                   {Aov::overlayConfidence, "overlay: confidence"},
                                   {Aov::overlayDistance, "overlay: distance"}};

void layOutPicture(ViewState& state) {
    const NamedOutput* now = outputs;
    for (const NamedOutput& candidate : outputs)
        if (candidate.aov == state.aov) now = &candidate;
    if (ImGui::BeginCombo("show", now->name)) {
        for (const NamedOutput& candidate : outputs)
            if (ImGui::Selectable(candidate.name, candidate.aov == state.aov)) state.aov = candidate.aov;
        ImGui::EndCombo();
    }
    if (state.aov == Aov::height)
        slider("white at", state.whiteHeightM, 0.01, 20, "%.2f m", ImGuiSliderFlags_Logarithmic);
    slider("exposure", state.scene.exposureEv, -10, 10, "%.1f stops");
}

void layOutTime(ViewState& state) {
    ImGui::Text("time %.2f s", state.timeS);
    ImGui::SameLine();
    ImGui::Checkbox("paused", &state.paused);
    slider("speed", state.timeScale, 0, 4, "%.2f x");
}

void layOutCamera(ViewState& state) {
    const Vec3 at = cameraAt(state.camera, state.timeS).positionM;
    ImGui::Text("at %.1f, %.1f, %.1f m", at[0], at[1], at[2]);
    if (!ImGui::BeginCombo("camera", state.camera.name.c_str())) return;
    for (const CameraDesc& camera : state.scene.cameras) {
        // Another offset is another place of the whole scene.
        if (camera.offsetM != Vec3{}) continue;
        if (ImGui::Selectable(camera.name.c_str(), camera.name == state.camera.name)) state.camera = camera;
    }
    ImGui::EndCombo();
}

void layOutCosts(const FrameTimes& costs) {
    if (!ImGui::BeginTable("costs", 2, ImGuiTableFlags_RowBg)) return;
    const auto row = [](const char* name, double ms) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(name);
        ImGui::TableNextColumn();
        ImGui::Text("%8.3f ms", ms);
    };
    if (costs.gpuFrameMs) row("frame, on the GPU", *costs.gpuFrameMs);
    row("frame, until its fence", costs.frameMs);
    row("simulate, on the CPU", costs.cpuSimulateMs);
    for (const PassTime& pass : costs.passes) row(pass.name.c_str(), pass.ms);
    ImGui::EndTable();
    ImGui::TextWrapped("by %s", describe(costs.clock));
}

void layOutButtons(const PanelInfo& info, PanelWishes& wishes) {
    wishes.measure = ImGui::Button("measure");
    ImGui::SameLine();
    wishes.savePicture = ImGui::Button("save picture");
    ImGui::SameLine();
    wishes.saveScene = ImGui::Button("save scene");
    if (!info.message.empty()) ImGui::TextWrapped("%s", info.message.c_str());
    if (info.costs) layOutCosts(*info.costs);
}

} // namespace

PanelWishes layOutPanel(ViewState& state, const PanelInfo& info) {
    PanelWishes wishes;
    ImGui::SetNextWindowPos({8, 8}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({356, static_cast<float>(info.height) - 16}, ImGuiCond_FirstUseEver);
    ImGui::Begin("seaglass");
    ImGui::PushItemWidth(170);
    ImGui::TextWrapped("%s", info.device.c_str());
    ImGui::Text("%u x %u", info.width, info.height);
    if (info.frameMs) {
        ImGui::SameLine();
        ImGui::Text("%.1f ms a frame", *info.frameMs);
    }
    if (!info.reference.empty()) ImGui::TextWrapped("%s", info.reference.c_str());
    layOutTime(state);
    layOutCamera(state);
    layOutPicture(state);
    layOutButtons(info, wishes);
    const auto open = [](const char* title, bool atFirst = true) {
        return ImGui::CollapsingHeader(title, atFirst ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    };
    if (state.scene.water && open("Quality")) wishes.surface |= layOutQuality(*state.scene.water);
    if (state.scene.water && state.scene.water->waves && open("Sea"))
        wishes.surface |= layOutSea(*state.scene.water->waves);
    if (std::optional<seaglass::ReflectionDesc>* const reflection = reflectionOf(state.scene);
        reflection && open("Reflection"))
        wishes.surface |= layOutMirror(*reflection);
    if (std::optional<seaglass::ReflectionDesc>* const reflection = reflectionOf(state.scene);
        reflection && open("Right half", state.split.has_value()))
        wishes.split = layOutSplit(state.split, *reflection);
    if (state.split) drawSplit(*state.split, info.width, info.height);
    if (open("Sun", false)) wishes.light |= layOutSun(state.scene);
    ImGui::PopItemWidth();
    ImGui::End();
    return wishes;
}

} // namespace demos
