// reference_pages FOLDER: writes docs/reference from the tables of settings, the library's and the scenes'.
#include <cctype>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/water/quality.h"
#include "scene/fields.h"
#include "scene/save.h"
#include "scene/text_file.h"
#include "seaglass/water.h"

namespace {

using demos::Section;
using seaglass::Field;
using seaglass::FieldRule;
using seaglass::FieldTable;
using seaglass::FieldType;

constexpr const char* note = "<!-- Written by scripts/reference from the tables: do not edit. -->\n";

/// 1e6, where printf has 1e+06.
std::string withoutPlus(std::string text) {
    for (size_t plus = text.find("e+0"); plus != text.npos; plus = text.find("e+0")) text.erase(plus + 1, 2);
    return text;
}

/// Empty: any finite one.
std::string number(double value) {
    if (std::isinf(value)) return "infinity";
    if (std::abs(value) == seaglass::mostFinite) return "";
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return withoutPlus(text);
}

std::string code(const std::string& text) {
    return text.empty() ? "" : "`" + text + "`";
}

/// A description as new, whatever it is.
struct Described {
    FieldTable table;
    const char* header;
    std::function<std::string(const Field&)> asNew;
};

std::string valueOf(const Field& field, double value) {
    if (field.choices) return field.choices[static_cast<size_t>(value - field.low)];
    if (field.type == FieldType::boolean) return value != 0 ? "yes" : "no";
    return number(static_cast<double>(static_cast<float>(value)));
}

template<class Desc>
Described described(const char* header) {
    return {fieldsOf(Desc{}), header, [](const Field& field) {
                const Desc desc;
                std::string text;
                for (uint32_t i = 0; i < field.count; ++i)
                    text.append(i == 0 ? "" : ", ").append(valueOf(field, field.get(&desc, i)));
                return text;
            }};
}

std::string rangeOf(const Field& field) {
    if (field.type == FieldType::boolean) return "yes, no";
    std::string text;
    if (field.choices) {
        for (double value = field.low; value <= field.high; ++value)
            text.append(value == field.low ? "" : ", ").append(valueOf(field, value));
        return text;
    }
    const std::string low = number(field.low), high = number(field.high);
    if (low.empty()) return "finite";
    text = low + (high.empty() ? " or more" : " to " + high);
    if (field.rule == FieldRule::zeroOrWithin) text = "0, " + text;
    if (field.rule == FieldRule::powerOfTwo) text = "powers of two, " + text;
    return text;
}

/// " Of ssr, hybrid." behind what only some read.
std::string readersOf(const FieldTable& table, const Field& field) {
    const Field& kind = table.fields[0];
    std::string text;
    for (auto value = static_cast<uint32_t>(kind.low); field.readBy >> value != 0; ++value)
        if ((field.readBy >> value & 1u) != 0)
            text.append(text.empty() ? " Of " : ", ").append(valueOf(kind, value));
    return text.empty() ? "" : text + ".";
}

/// Where scenes hold each row, first come.
std::map<const Field*, std::string> sceneKeys(const Section& section, const std::string& path = "") {
    std::map<const Field*, std::string> keys;
    for (const demos::Field& field : section.fields)
        if (field.row) keys.emplace(field.row, path + std::string(field.key));
    for (const demos::Child& child : section.children)
        keys.merge(sceneKeys(*child.section, path + std::string(child.section->key) + "."));
    return keys;
}

void addTable(const Described& of, const std::map<const Field*, std::string>& keys, std::string& page) {
    page += "\n## " + std::string(of.table.desc) + "\n\n`" + of.header + "`\n\n";
    page += "| field | range | default | unit | in scenes | what it is |\n|---|---|---|---|---|---|\n";
    for (const Field& field : of.table) {
        const auto key = keys.find(&field);
        page += "| " + code(field.name) + " | " + rangeOf(field) + " | " + of.asNew(field) + " | " +
                field.unit + " | " + code(key == keys.end() ? "" : key->second) + " | " + field.about +
                readersOf(of.table, field) + " |\n";
    }
}

void addQuality(const std::vector<Described>& all, std::string& page) {
    page += "\n## What setQuality() sets\n\n| |";
    for (const std::string_view name : demos::qualities()) page.append(" ").append(name).append(" |");
    page += "\n|---|---|---|---|---|\n";
    for (const Described& of : all) {
        for (const Field& field : of.table) {
            if (!field.graded) continue;
            page += "| `" + std::string(of.table.desc) + "::" + field.name + "` |";
            for (const double grade : field.grades) page += " " + valueOf(field, grade) + " |";
            page += "\n";
        }
    }
    page += "| `BodyDesc::bed` | none | as it was | as it was | as it was |\n\n"
            "`ReflectionDesc::technique` stays where it is `sky` or `planar`.\n";
}

std::string settingsPage() {
    using namespace seaglass;
    const std::vector<Described> all = {
        described<BodyDesc>("seaglass/water.h"),
        described<ExtentDesc>("seaglass/water.h"),
        described<MeshDesc>("seaglass/water.h"),
        described<ShadingDesc>("seaglass/water.h"),
        described<SeaDesc>("seaglass/sea.h"),
        described<SwellDesc>("seaglass/sea.h"),
        described<SpectrumSample>("seaglass/sea.h"),
        described<ShoreDesc>("seaglass/sea.h"),
        described<FoamDesc>("seaglass/sea.h"),
        described<RefractionDesc>("seaglass/water.h"),
        described<ReflectionDesc>("seaglass/reflection.h"),
        described<UnderwaterDesc>("seaglass/water.h"),
        described<CausticsDesc>("seaglass/water.h"),
        described<SprayDesc>("seaglass/water.h"),
        described<BedDesc>("seaglass/water.h"),
        described<LightingDesc>("seaglass/host.h"),
        described<SunShadow>("seaglass/host.h"),
        described<FogDesc>("seaglass/fog.h"),
        described<ViewDesc>("seaglass/host.h"),
        described<Image>("seaglass/host.h"),
        described<SceneSamples>("seaglass/reflection.h"),
        described<TargetDesc>("seaglass/water.h"),
        described<OverlayDesc>("seaglass/reflection.h"),
        described<DeviceDesc>("seaglass/host.h"),
    };
    std::string page = note;
    page += "# Settings\n\nWhat the descriptions hold, but pointers and images: `fieldsOf()` of "
            "`seaglass/fields.h`, for a host's own panels, consoles and files.\nBeyond its range a field is "
            "refused: `Status::invalidArgument`, "
            "and a line that names it. How "
            "they work together, the headers say.\n";
    const auto keys = sceneKeys(demos::sceneSection());
    for (const Described& of : all) addTable(of, keys, page);
    addQuality(all, page);
    return page;
}

std::string sentence(std::string_view words) {
    std::string text(words);
    if (text.empty()) return text;
    // No formula's letter.
    if (text.size() > 1 && text[1] != ' ')
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    if (text.back() != '.') text += '.';
    return text;
}

void addSection(const Section& section, void* asNew, const std::string& path, bool repeated,
                std::string& page) {
    page += "\n## " +
            (path.empty() ? "At the top" : (repeated ? "`[[" : "`[") + path + (repeated ? "]]`" : "]`")) +
            "\n\n" + sentence(section.about) +
            "\n\n| key | what it may hold | as new | what it is |\n|---|---|---|---|\n";
    const std::string noForce = code(std::to_string(demos::WavesDesc::noForce));
    for (const demos::Field& field : section.fields) {
        const demos::Target target = field.target(asNew);
        std::string value = field.required ? "must be said" : code(demos::valueText(field, asNew));
        if (value == "`\"\"`" || value == "`[]`" || value == noForce) value.clear();
        page += "| " + code(std::string(field.key)) + " | " + demos::expectation(field, target) + " | " +
                value + " | " + sentence(field.about) + " |\n";
    }
    for (const demos::Child& child : section.children) {
        const std::string childPath = (path.empty() ? "" : path + ".") + std::string(child.section->key);
        // A floor's are the water's.
        if (childPath == "floor.reflection") {
            page += "\n## `[floor.reflection]`\n\nAs `[water.reflection]`.\n";
            continue;
        }
        addSection(*child.section, child.access.open(asNew), childPath, child.repeated, page);
    }
}

std::string scenesPage() {
    std::string page = note;
    page += "# Scene files\n\nEvery key of a scene file (TOML). `--set` takes the same by its path: `--set "
            "water.waves.wind_m_s=12`; a "
            "camera by its name,\nother elements of lists by their number: `camera.low.roll_deg`, "
            "`mesh.0.scale`.\n";
    demos::Scene scene;
    addSection(demos::sceneSection(), &scene, "", false, page);
    return withoutPlus(page);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("reference_pages: expected a folder\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    demos::Error error;
    for (const auto& [name, page] : {std::pair{"settings.md", settingsPage()}, {"scenes.md", scenesPage()}}) {
        if (demos::writeText(folder / name, page, error)) continue;
        std::fprintf(stderr, "%s\n", error.text.c_str());
        return 1;
    }
    return 0;
}
