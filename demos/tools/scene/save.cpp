#include "scene/save.h"

#include <array>
#include <charconv>
#include <cstdio>

#include "scene/fields.h"
#include "scene/text_file.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

std::string tomlString(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) {
            out += c;
            continue;
        }
        std::array<char, 8> escaped{};
        std::snprintf(escaped.data(), escaped.size(), "\\u%04x", static_cast<unsigned char>(c));
        out += escaped.data();
    }
    return out + "\"";
}

/// The shortest text that reads back as the same bits.
template<class Number>
std::string shortest(Number value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// A field's value as TOML.
struct ValueText {
    const fs::path& folder;

    std::string operator()(const double* value) const { return shortest(*value); }
    template<class T, size_t count>
    std::string operator()(const std::array<T, count>* values) const {
        return list(*values);
    }
    std::string operator()(const std::vector<Vec2>* values) const { return list(*values); }
    std::string operator()(const uint32_t* value) const { return std::to_string(*value); }
    std::string operator()(const uint64_t* value) const { return std::to_string(*value); }
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const std::string* value) const { return tomlString(*value); }
    std::string operator()(const fs::path* value) const {
        return tomlString(value->empty() ? "" : value->lexically_proximate(folder).generic_string());
    }

    std::string operator()(const Setting& setting) const {
        const double value = setting.get();
        switch (setting.field->type) {
        case seaglass::FieldType::boolean:
            return value != 0 ? "true" : "false";
        case seaglass::FieldType::choice:
            return tomlString(setting.field->choices[static_cast<size_t>(value - setting.field->low)]);
        case seaglass::FieldType::integer:
            return std::to_string(static_cast<uint32_t>(value));
        case seaglass::FieldType::float32:
            return shortest(static_cast<float>(value));
        default:
            return shortest(value);
        }
    }

    template<class Values>
    std::string list(const Values& values) const {
        std::string text;
        for (const auto& value : values) text.append(text.empty() ? "" : ", ").append((*this)(&value));
        return "[" + text + "]";
    }
};

class Writer {
  public:
    explicit Writer(const fs::path& folder) : value_{folder} {}

    /// What differs from `fresh`, which is an owner as new.
    void write(const Section& section, void* owner, void* fresh, const std::string& path) {
        for (const Field& field : section.fields) {
            const std::string text = std::visit(value_, field.target(owner));
            if (field.required || text != std::visit(value_, field.target(fresh)))
                text_.append(field.key).append(" = ").append(text).append("\n");
        }
        for (const Child& child : section.children) {
            const std::string childPath = (path.empty() ? "" : path + ".") + std::string(child.section->key);
            for (void* const there : child.access.there(owner)) {
                text_.append(child.repeated ? "\n[[" : "\n[").append(childPath);
                text_.append(child.repeated ? "]]\n" : "]\n");
                write(*child.section, there, child.access.open(fresh), childPath);
            }
        }
    }

    const std::string& text() const { return text_; }

  private:
    const ValueText value_;
    std::string text_;
};

} // namespace

std::string valueText(const Field& field, void* owner) {
    return std::visit(ValueText{{}}, field.target(owner));
}

std::string sceneText(Scene scene, const fs::path& folder) {
    Writer writer(folder);
    Scene fresh;
    if (scene.water) {
        WaterDesc& water = fresh.water.emplace();
        for (const PhotographicDefault& usual : photographicDefaults())
            if ((*scene.water).*usual.isSaid) usual.unset(water);
    }
    writer.write(sceneSection(), &scene, &fresh, "");
    return writer.text();
}

bool saveScene(const Scene& scene, const fs::path& file, Error& error) {
    return writeText(file, sceneText(scene, fs::absolute(file).lexically_normal().parent_path()), error);
}

} // namespace demos
