#include "view/ui/panel.h"

#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>

#include <imgui.h>

#include "host/water/quality.h"
#include "scene/fields.h"

namespace demos {

namespace {

/// True once a change is complete: a slider is let go.
bool slider(const char* label, double& value, double least, double most, const char* format,
            ImGuiSliderFlags flags = 0) {
    ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &least, &most, format,
                        flags | ImGuiSliderFlags_AlwaysClamp);
    return ImGui::IsItemDeactivatedAfterEdit();
}

bool slider(const char* label, uint32_t& value, uint32_t least, uint32_t most) {
    ImGui::SliderScalar(label, ImGuiDataType_U32, &value, &least, &most, "%u", ImGuiSliderFlags_AlwaysClamp);
    return ImGui::IsItemDeactivatedAfterEdit();
}

/// Side by side. True when another was chosen.
bool chooseNumber(const char* label, uint32_t& value, std::initializer_list<uint32_t> choices) {
    const uint32_t before = value;
    ImGui::TextUnformatted(label);
    ImGui::PushID(label);
    for (const uint32_t choice : choices) {
        ImGui::SameLine();
        if (ImGui::RadioButton(std::to_string(choice).c_str(), value == choice)) value = choice;
    }
    ImGui::PopID();
    return value != before;
}

/// True when another was chosen.
bool choose(const char* label, std::string& value, std::span<const std::string_view> choices) {
    bool changed = false;
    if (!ImGui::BeginCombo(label, value.c_str())) return false;
    for (const std::string_view choice : choices) {
        const std::string text(choice);
        if (!ImGui::Selectable(text.c_str(), text == value)) continue;
        changed = text != value;
        value = text;
    }
    ImGui::EndCombo();
    return changed;
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

bool layOutSea(WavesDesc& waves) {
    bool changed = chooseForce(waves.beaufort);
    ImGui::BeginDisabled(waves.beaufort != WavesDesc::noForce);
    changed |= slider("wind", waves.windMps, 0, 40, "%.1f m/s");
    changed |= slider("fetch", waves.fetchM, 10, 1e6, "%.0f m", ImGuiSliderFlags_Logarithmic);
    ImGui::EndDisabled();
    changed |= slider("towards", waves.windTowardsDeg, -360, 360, "%.0f deg");
    changed |= slider("amplitude", waves.amplitude, 0, 1, "%.2f");
    changed |= slider("choppiness", waves.choppiness, 0, 2, "%.2f");
    return changed;
}

bool layOutRays(ReflectionDesc& reflection) {
    bool changed = ImGui::Checkbox("over cells, pixel by pixel", &reflection.marchCells);
    changed |= slider("steps", reflection.marchSteps, 8, 512);
    changed |=
        slider("thickness", reflection.marchThicknessM, 0.001, 10, "%.3f m", ImGuiSliderFlags_Logarithmic);
    return changed;
}

bool layOutReflection(ReflectionDesc& reflection) {
    bool changed = choose("technique", reflection.technique, choicesOf("water.reflection.technique"));
    changed |= chooseNumber("size: 1 /", reflection.downscale, {1, 2, 4, 8});
    if (reflection.technique == "sspr")
        changed |= ImGui::Checkbox("one key for 2 x 2 pixels", &reflection.coarseKeys);
    if (reflection.technique == "sspr" || reflection.technique == "hybrid")
        changed |= slider("looks for roofs", reflection.roofLooks, 0, 8);
    if (reflection.technique == "ssr" || reflection.technique == "hybrid") changed |= layOutRays(reflection);
    changed |= slider("temporal", reflection.temporal, 0, 0.95, "%.2f");
    changed |= slider("distortion", reflection.distortion, 0, 1, "%.2f");
    changed |= slider("edge fade", reflection.edgeFade, 0, 0.5, "%.2f");
    changed |= slider("underside light", reflection.undersideLight, 0, 1, "%.2f");
    changed |= slider("edge reach", reflection.edgeReach, 0, 1, "%.2f");
    changed |= slider("edge stretch", reflection.edgeStretchPerM, 0, 10, "%.2f / m");
    changed |= slider("blur levels", reflection.blurLevels, 0, 6);
    return changed;
}

bool layOutMirror(std::optional<ReflectionDesc>& reflection) {
    bool mirrors = reflection.has_value();
    const bool switched = ImGui::Checkbox("mirrors the scene", &mirrors);
    if (switched) reflection = mirrors ? std::optional(ReflectionDesc{}) : std::nullopt;
    return (reflection && layOutReflection(*reflection)) || switched;
}

/// The dial, then what it turned, which can be turned on.
bool layOutQuality(WaterDesc& water) {
    bool changed = false;
    for (const std::string_view& quality : qualities()) {
        if (&quality != qualities().data()) ImGui::SameLine();
        if (!ImGui::Button(std::string(quality).c_str())) continue;
        setQuality(quality, water);
        changed = true;
    }
    changed |= slider("bent light", water.refractionLooks, 1, 16);
    if (water.bed) changed |= slider("pixels to one of the bed", water.bed->downscale, 1, 8);
    changed |= chooseNumber("mirror looks:", water.mirrorLooks, {1, 2, 4});
    changed |= chooseNumber("slope looks:", water.slopeLooks, {1, 2, 4});
    bool shadows = water.waveShadowSteps > 0;
    if (ImGui::Checkbox("waves hide low sun and sky", &shadows)) {
        water.waveShadowSteps = shadows ? 8 : 0;
        changed = true;
    }
    changed |= ImGui::Checkbox("relief of short waves", &water.relief);
    changed |= choose("fresnel", water.fresnel, choicesOf("water.fresnel"));
    return changed;
}

std::optional<ReflectionDesc>* reflectionOf(Scene& scene) {
    if (scene.water) return &scene.water->reflection;
    return scene.floor ? &scene.floor->reflection : nullptr;
}

bool layOutSun(Scene& scene) {
    SunDesc& sun = scene.sun;
    bool changed = ImGui::Checkbox("where the sky is brightest", &sun.fromSky);
    ImGui::BeginDisabled(sun.fromSky);
    changed |= slider("azimuth", sun.azimuthDeg, -360, 360, "%.0f deg");
    changed |= slider("elevation", sun.elevationDeg, -10, 90, "%.1f deg");
    ImGui::EndDisabled();
    return changed;
}

bool layOutSplit(std::optional<Split>& split, const std::optional<ReflectionDesc>& own) {
    bool on = split.has_value();
    bool changed = ImGui::Checkbox("split the picture", &on);
    if (changed) split = on ? std::optional(Split{own.value_or(ReflectionDesc{})}) : std::nullopt;
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
    const Vec3& at = state.camera.positionM;
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
    ImGui::SetNextWindowSize({310, static_cast<float>(info.height) - 16}, ImGuiCond_FirstUseEver);
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
    if (std::optional<ReflectionDesc>* const reflection = reflectionOf(state.scene);
        reflection && open("Reflection"))
        wishes.surface |= layOutMirror(*reflection);
    if (std::optional<ReflectionDesc>* const reflection = reflectionOf(state.scene);
        reflection && open("Right half", state.split.has_value()))
        wishes.split = layOutSplit(state.split, *reflection);
    if (state.split) drawSplit(*state.split, info.width, info.height);
    if (open("Sun", false)) wishes.light |= layOutSun(state.scene);
    ImGui::PopItemWidth();
    ImGui::End();
    return wishes;
}

} // namespace demos
