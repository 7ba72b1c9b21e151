#include "view/field_widgets.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include <imgui.h>

namespace demos {

namespace {

bool slideNumber(const char* label, const Field& field, const SliderRange& range, double& value) {
    std::string format = "%.4g";
    if (!field.unit.empty()) format.append(" ").append(field.unit);
    const ImGuiSliderFlags scale = range.logarithmic ? ImGuiSliderFlags_Logarithmic : 0;
    ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &range.least, &range.most, format.c_str(),
                        ImGuiSliderFlags_AlwaysClamp | scale);
    value = snapped(field, value);
    return ImGui::IsItemDeactivatedAfterEdit();
}

bool slideWhole(const char* label, const Field& field, const SliderRange& range, uint32_t& value) {
    const auto least = static_cast<uint32_t>(range.least), most = static_cast<uint32_t>(range.most);
    ImGui::SliderScalar(label, ImGuiDataType_U32, &value, &least, &most, "%u", ImGuiSliderFlags_AlwaysClamp);
    value = static_cast<uint32_t>(snapped(field, value));
    return ImGui::IsItemDeactivatedAfterEdit();
}

/// True when another was chosen.
bool choosePower(const char* label, const SliderRange& range, uint32_t& value) {
    const uint32_t before = value;
    if (!ImGui::BeginCombo(label, std::to_string(value).c_str())) return false;
    for (auto power = static_cast<uint32_t>(range.least); power <= static_cast<uint32_t>(range.most);
         power *= 2)
        if (ImGui::Selectable(std::to_string(power).c_str(), power == value)) value = power;
    ImGui::EndCombo();
    return value != before;
}

/// True when another was chosen.
bool choose(const char* label, const Field& field, std::string_view& value) {
    bool changed = false;
    if (!ImGui::BeginCombo(label, std::string(value).c_str())) return false;
    for (const std::string_view choice : field.choices) {
        if (!ImGui::Selectable(std::string(choice).c_str(), choice == value)) continue;
        changed = choice != value;
        value = choice;
    }
    ImGui::EndCombo();
    return changed;
}

class Widget {
  public:
    Widget(const Field& field, const SliderRange& range)
        : field_(field), range_(range), label_(labelOf(field)) {}

    bool operator()(double* value) const { return slideNumber(label_.c_str(), field_, range_, *value); }
    bool operator()(uint32_t* value) const {
        return field_.rule == Rule::powerOfTwo ? choosePower(label_.c_str(), range_, *value)
                                               : slideWhole(label_.c_str(), field_, range_, *value);
    }
    bool operator()(bool* value) const { return ImGui::Checkbox(label_.c_str(), value); }
    bool operator()(std::string* value) const {
        std::string_view word = *value;
        const bool changed = choose(label_.c_str(), field_, word);
        *value = word;
        return changed;
    }
    bool operator()(const Setting& setting) const {
        switch (setting.field->type) {
        case seaglass::FieldType::boolean:
            return change<bool>(setting);
        case seaglass::FieldType::integer:
            return change<uint32_t>(setting);
        case seaglass::FieldType::choice:
            return chooseOf(setting);
        default:
            return change<double>(setting);
        }
    }
    /// Of a colour, a file and so on there are no widgets.
    bool operator()(const void*) const { return false; }

  private:
    template<class Value>
    bool change(const Setting& setting) const {
        auto value = static_cast<Value>(setting.get());
        const bool complete = (*this)(&value);
        setting.set(static_cast<double>(value));
        return complete;
    }
    bool chooseOf(const Setting& setting) const {
        const double low = setting.field->low;
        std::string_view word = field_.choices[static_cast<size_t>(setting.get() - low)];
        const bool changed = choose(label_.c_str(), field_, word);
        setting.set(low +
                    static_cast<double>(std::ranges::find(field_.choices, word) - field_.choices.begin()));
        return changed;
    }

    const Field& field_;
    const SliderRange range_;
    const std::string label_;
};

double numberIn(const Target& target) {
    if (const auto* number = std::get_if<double*>(&target)) return **number;
    if (const auto* whole = std::get_if<uint32_t*>(&target)) return **whole;
    const auto* setting = std::get_if<Setting>(&target);
    return setting ? setting->get() : 0;
}

} // namespace

std::string labelOf(const Field& field) {
    std::string label(field.key);
    constexpr std::string_view ends[] = {"_per_m", "_m_s", "_deg", "_px", "_m", "_s"};
    for (const std::string_view end : ends)
        if (!field.unit.empty() && label.ends_with(end)) {
            label.resize(label.size() - end.size());
            break;
        }
    std::ranges::replace(label, '_', ' ');
    return label;
}

bool hasWidget(const Target& target) {
    return !std::holds_alternative<Vec2*>(target) && !std::holds_alternative<Vec3*>(target) &&
           !std::holds_alternative<std::vector<Vec2>*>(target) &&
           !std::holds_alternative<uint64_t*>(target) &&
           !std::holds_alternative<std::filesystem::path*>(target);
}

SliderRange sliderRangeOf(const Field& field, void* asNew) {
    const double least = field.rule == Rule::zeroOrRange ? 0 : field.least;
    const bool whole = field.row && field.row->type == seaglass::FieldType::integer;
    const double near = std::max(field.least, numberIn(field.target(asNew)));
    const bool wide = field.most >= 100 * near || (field.least > 0 && field.most >= 1e4 * field.least);
    return {least, field.most, !whole && field.least >= 0 && field.most >= 100 && wide};
}

double snapped(const Field& field, double value) {
    if (field.rule != Rule::zeroOrRange || value >= field.least) return value;
    return value < field.least / 2 ? 0 : field.least;
}

bool isRead(const Field& field, void* owner) {
    if (!field.row || field.row->readBy == 0) return true;
    const Target target = field.target(owner);
    const auto* const setting = std::get_if<Setting>(&target);
    if (!setting) return true;
    const auto kind = static_cast<uint32_t>(field.table->fields[0].get(setting->desc, 0));
    return (field.row->readBy >> kind & 1u) != 0;
}

bool layOutField(const Field& field, void* owner, void* asNew) {
    const Target target = field.target(owner);
    if (!hasWidget(target)) return false;
    const bool complete = std::visit(Widget(field, sliderRangeOf(field, asNew)), target);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s\n%s", std::string(field.about).c_str(), expectation(field, target).c_str());
    return complete;
}

bool layOutFields(const Section& section, void* owner, void* asNew) {
    bool changed = false;
    for (const Field& field : section.fields)
        if (field.row && isRead(field, owner)) changed |= layOutField(field, owner, asNew);
    return changed;
}

} // namespace demos
