#include "measure/technique.h"

#include <algorithm>

#include "host/water/quality.h"
#include "scene/fields.h"
#include "scene/nearest.h"

namespace demos::measure {

namespace {

struct Quality {
    const char* name;
    const char* setting;        ///< null leaves all as it is
    std::string_view only = {}; ///< the technique that has it; empty: all that make an image
};

constexpr Quality qualities[] = {
    {"default", nullptr},
    {"coarse keys", "coarse_keys=true", "sspr"},
    {"no overhangs", "overhang_samples=0", "sspr"},
    {"no overhangs", "overhang_samples=0", "hybrid"},
    {"half", "downscale=2"},
    {"quarter", "downscale=4"},
    {"temporal", "temporal=0.9"},
    {"32 steps", "march_steps=32", "ssr"},
    {"128 steps", "march_steps=128", "ssr"},
    {"strides", "march_cells=false", "ssr"},
};

bool has(std::string_view technique, const Quality& quality) {
    if (!quality.setting) return true;
    return technique != "sky" && (quality.only.empty() || quality.only == technique);
}

std::vector<Technique> allTechniques() {
    std::vector<Technique> all = {{"none", "default", {}, false}};
    // A floor's are the same.
    for (const std::string_view word : choicesOf("water.reflection.technique")) {
        const std::string name(word);
        for (const Quality& quality : qualities) {
            if (!has(word, quality)) continue;
            Technique& added = all.emplace_back();
            added.name = name;
            added.quality = quality.name;
            added.settings = {"technique=" + name};
            if (quality.setting) added.settings.push_back(quality.setting);
        }
    }
    for (const std::string_view quality : demos::qualities())
        all.push_back({"water", std::string(quality), {}, true, true});
    return all;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool areKnown(const std::vector<std::string>& names, Error& error) {
    std::vector<std::string_view> known;
    for (const Technique& technique : techniques())
        if (std::ranges::find(known, technique.name) == known.end()) known.push_back(technique.name);
    return std::ranges::all_of(
        names, [&](const std::string& name) { return isOneOf("--technique", name, known, error); });
}

} // namespace

std::span<const Technique> techniques() {
    static const std::vector<Technique> all = allTechniques();
    return all;
}

std::optional<std::vector<const Technique*>> chooseTechniques(const std::vector<std::string>& names,
                                                              Error& error) {
    if (!areKnown(names, error)) return std::nullopt;
    std::vector<const Technique*> chosen;
    for (const Technique& technique : techniques())
        if (names.empty() || contains(names, technique.name)) chosen.push_back(&technique);
    return chosen;
}

} // namespace demos::measure
