// Groups of the panel's widgets.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

namespace demos {

/// A heading that opens. When it is open, end the group, which hands through whether something has changed.
bool beginControls(const char* heading, bool open = false);
bool endControls(bool changed);

/// Some of the scene's fields, by their section's path.
bool layOutKeys(std::string_view section, std::initializer_list<std::string_view> keys, void* owner,
                void* asNew);
/// All that a section's fields have widgets for.
bool layOutAll(std::string_view section, void* owner, void* asNew);

/// Whether a part of a scene is there, and its fields. It begins as new.
template<class Part>
bool layOutPart(const char* label, std::string_view section, std::optional<Part>& part);

/// A box to tick. True when it was.
bool layOutSwitch(const char* label, bool& on);

template<class Part>
bool layOutPart(const char* label, std::string_view section, std::optional<Part>& part) {
    bool on = part.has_value();
    const bool switched = layOutSwitch(label, on);
    if (switched) part = on ? std::optional(Part{}) : std::nullopt;
    Part asNew;
    return (part && layOutAll(section, &*part, &asNew)) || switched;
}

} // namespace demos
