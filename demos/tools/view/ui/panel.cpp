#include "view/ui/panel.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include <imgui.h>

#include "view/ui/controls.h"
#include "view/ui/light_controls.h"
#include "view/ui/water_controls.h"

namespace demos {

namespace {

/// True once a change is complete: a slider is let go.
bool slider(const char* label, double& value, double least, double most, const char* format,
            ImGuiSliderFlags flags = 0) {
    ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &least, &most, format,
                        flags | ImGuiSliderFlags_AlwaysClamp);
    return ImGui::IsItemDeactivatedAfterEdit();
}

std::optional<seaglass::ReflectionDesc>* reflectionOf(Scene& scene) {
    if (scene.water) return &scene.water->reflection;
    return scene.floor ? &scene.floor->reflection : nullptr;
}

bool layOutSplit(std::optional<Split>& split, const std::optional<seaglass::ReflectionDesc>& own) {
    bool on = split.has_value();
    bool changed = layOutSwitch("split the picture", on);
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

void layOutPicture(ViewState& state, PanelWishes& wishes) {
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
    ImGui::Checkbox("bloom, antialiasing", &state.lens);
    slider("exposure", state.scene.exposureEv, -10, 10, "%.1f stops");
    wishes.meter = ImGui::Button("meter the exposure");
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
    ImGui::SetNextWindowSize({panelWidth(info.width), static_cast<float>(info.height) - 16},
                             ImGuiCond_FirstUseEver);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6, 6});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4, 2});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {4, 4});
    ImGui::Begin("seaglass");
    ImGui::PushItemWidth(0.4f * ImGui::GetWindowWidth());
    ImGui::TextUnformatted(frameText(info).c_str());
    ImGui::TextWrapped("%u x %u, %s", info.width, info.height, info.device.c_str());
    if (!info.reference.empty()) ImGui::TextWrapped("%s", info.reference.c_str());
    layOutTime(state);
    layOutCamera(state);
    layOutPicture(state, wishes);
    layOutButtons(info, wishes);
    if (state.scene.water) wishes.surface |= layOutWater(*state.scene.water);
    if (std::optional<seaglass::ReflectionDesc>* const reflection = reflectionOf(state.scene)) {
        if (beginControls("Reflection")) wishes.surface |= endControls(layOutMirror(*reflection));
        if (beginControls("Right half", state.split.has_value()))
            wishes.split = endControls(layOutSplit(state.split, *reflection));
    }
    wishes.light |= layOutLight(state.scene);
    if (state.scene.water && beginControls("Quality"))
        wishes.surface |= endControls(layOutQuality(*state.scene.water));
    if (state.split) drawSplit(*state.split, info.width, info.height);
    ImGui::PopItemWidth();
    ImGui::End();
    ImGui::PopStyleVar(3);
    return wishes;
}

float panelWidth(uint32_t width) {
    return std::clamp(0.19f * static_cast<float>(width), 160.0f, 320.0f);
}

std::string frameText(const PanelInfo& info) {
    if (!info.frameMs) return "a frame a step";
    char text[48];
    std::snprintf(text, sizeof text, "%.1f ms a frame, %.0f a second", *info.frameMs, 1000 / *info.frameMs);
    return text;
}

} // namespace demos
