#include "view/ui/light_controls.h"

#include <imgui.h>

#include "view/field_widgets.h"
#include "view/ui/controls.h"

namespace demos {

namespace {

bool layOutSun(SunDesc& sun) {
    SunDesc asNew;
    bool changed = layOutKeys("sun", {"from_sky"}, &sun, &asNew);
    ImGui::BeginDisabled(sun.fromSky);
    changed |= layOutKeys("sun", {"azimuth_deg", "elevation_deg"}, &sun, &asNew);
    ImGui::EndDisabled();
    return changed;
}

bool layOutSky(SkyDesc& sky) {
    SkyDesc asNew;
    ImGui::BeginDisabled(sky.file.empty()); // there is no other sky
    bool changed = layOutKeys("sky", {"clear"}, &sky, &asNew);
    ImGui::EndDisabled();
    changed |= layOutKeys("sky", {"haze", "rotation_deg", "intensity", "detail"}, &sky, &asNew);
    return changed;
}

} // namespace

bool layOutLight(Scene& scene) {
    bool changed = false;
    if (beginControls("Sun")) changed |= endControls(layOutSun(scene.sun));
    if (beginControls("Sky")) changed |= endControls(layOutSky(scene.sky));
    if (beginControls("Fog")) changed |= endControls(layOutPart("fog in the air", "fog", scene.fog));
    return changed;
}

} // namespace demos
