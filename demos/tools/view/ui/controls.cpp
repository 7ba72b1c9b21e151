#include "view/ui/controls.h"

#include <algorithm>

#include <imgui.h>

#include "view/field_widgets.h"

namespace demos {

bool beginControls(const char* heading, bool open) {
    if (!ImGui::CollapsingHeader(heading, open ? ImGuiTreeNodeFlags_DefaultOpen : 0)) return false;
    ImGui::PushID(heading);
    return true;
}

bool endControls(bool changed) {
    ImGui::PopID();
    return changed;
}

bool layOutKeys(std::string_view section, std::initializer_list<std::string_view> keys, void* owner,
                void* asNew) {
    bool changed = false;
    for (const std::string_view key : keys)
        changed |= layOutField(*std::ranges::find(sectionOf(section).fields, key, &Field::key), owner, asNew);
    return changed;
}

bool layOutAll(std::string_view section, void* owner, void* asNew) {
    bool changed = false;
    for (const Field& field : sectionOf(section).fields)
        if (isRead(field, owner)) changed |= layOutField(field, owner, asNew);
    return changed;
}

bool layOutSwitch(const char* label, bool& on) {
    return ImGui::Checkbox(label, &on);
}

} // namespace demos
