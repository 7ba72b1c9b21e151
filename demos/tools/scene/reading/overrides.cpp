#include "scene/reading/overrides.h"

#include <algorithm>
#include <optional>

#include "scene/fields.h"
#include "scene/reading/either_way.h"
#include "scene/reading/former_names.h"
#include "scene/reading/nearest_path.h"
#include "scene/reading/places.h"
#include "scene/reading/short_keys.h"

namespace demos::reading {
namespace {

/// What is set by hand in one way takes the place of what the file says in the other.
void dropOtherWay(const Section& section, toml::table& table, std::string_view key) {
    const auto drop = [&](const auto& keys, const auto& others) {
        if (std::ranges::find(keys, key) == std::end(keys)) return;
        for (const char* const other : others) {
            const toml::node* const node = table.get(other);
            if (node && !isOverride(*node)) table.erase(other);
        }
    };
    if (section.key == "refraction") {
        drop(colorByTint, colorByWater);
        drop(colorByWater, colorByTint);
    }
    if (section.key == "camera") {
        drop(shownByAngle, shownByHeight);
        drop(shownByHeight, shownByAngle);
    }
}

/// The value of "path=value": TOML, or else a bare word. Its nodes say where they come from.
std::optional<toml::table> parseValue(const std::string& text, const std::string& source) {
    // A file may have any name, and what begins like that is no TOML.
    const bool isFile = text.starts_with('/');
    if (!isFile) {
        if (!hasShortKeys(text)) return std::nullopt;
        toml::parse_result parsed = toml::parse("v = " + text + "\n", source);
        if (parsed && parsed.table().size() == 1) return std::move(parsed).table();
        if (text.empty() || text.find_first_of("\"'[]{}\n") != text.npos) return std::nullopt;
    }
    toml::parse_result word = toml::parse("v = ''\n", source);
    if (!word) return std::nullopt;
    word.table().get_as<std::string>("v")->get() = text;
    return std::move(word).table();
}

std::vector<std::string> split(std::string_view path) {
    std::vector<std::string> keys;
    for (size_t start = 0; start <= path.size();) {
        const size_t dot = std::min(path.find('.', start), path.size());
        keys.emplace_back(path.substr(start, dot - start));
        start = dot + 1;
    }
    return keys;
}

/// Puts overrides into the parsed file, before anything is checked.
class Overrider {
  public:
    Overrider(toml::table& root, std::vector<std::string>& notes, Error& error)
        : root_(root), notes_(notes), error_(error) {}

    bool apply(const std::string& assignment) {
        source_ = std::string(overrideMark) + assignment;
        const size_t equals = assignment.find('=');
        if (equals == 0 || equals == assignment.npos)
            return fail("expected path=value, such as water.waves.wind_m_s=12");
        const std::string path = assignment.substr(0, equals);
        std::optional<toml::table> value = parseValue(assignment.substr(equals + 1), source_);
        if (!value) return fail("the value is not TOML, expected a number, true, false, a text or [a, b, c]");

        std::vector<std::string> keys = split(path);
        toml::table* table = &root_;
        const Section* section = &sceneSection();
        for (size_t i = 0; i + 1 < keys.size(); ++i) {
            rename(*section, keys, i);
            const auto child = std::find_if(section->children.begin(), section->children.end(),
                                            [&](const Child& c) { return c.section->key == keys[i]; });
            if (child == section->children.end()) return unknown(path);
            section = child->section;
            table = child->repeated ? element(*table, keys[i], keys[i + 1]) : descend(*table, keys[i]);
            if (!table) return false;
            // The name or the number took a key of its own, and must itself have one.
            if (child->repeated && ++i + 1 == keys.size()) {
                return fail("expected a key after " + path + ", such as " + path + "." +
                            std::string(section->fields.back().key));
            }
        }
        rename(*section, keys, keys.size() - 1);
        if (const GoneKey* const gone = goneKey(section->key, keys.back())) {
            notes_.push_back(isGone(source_, pathTo(keys, keys.size() - 1), *gone));
            return true;
        }
        dropOtherWay(*section, *table, keys.back());
        // The last key is checked with all others, by the reader, which knows this override by its source.
        value->get("v")->visit([&](auto& node) { table->insert_or_assign(keys.back(), std::move(node)); });
        return true;
    }

  private:
    bool fail(const std::string& what) {
        error_.text = source_ + ": " + what;
        return false;
    }

    bool unknown(const std::string& path) {
        return fail(path + " is not a known key, the nearest is " + nearestPath(path));
    }

    void rename(const Section& section, std::vector<std::string>& keys, size_t i) {
        const std::string_view now = presentKey(section.key, keys[i]);
        if (now == keys[i]) return;
        notes_.push_back(calledNow(source_, pathTo(keys, i), keys[i], now));
        keys[i] = now;
    }

    /// To the key number `i`.
    static std::string pathTo(const std::vector<std::string>& keys, size_t i) {
        std::string path;
        for (size_t j = 0; j < i; ++j) path = join(path, keys[j]);
        return path;
    }

    toml::table* descend(toml::table& parent, const std::string& key) {
        if (!parent.contains(key)) parent.insert(key, toml::table{});
        toml::table* found = parent.get_as<toml::table>(key);
        if (!found) fail(key + " is " + quote(*parent.get(key)) + " in the scene, expected a table");
        return found;
    }

    toml::table* element(toml::table& parent, const std::string& key, const std::string& which) {
        toml::array* elements = parent.get_as<toml::array>(key);
        std::string known;
        for (size_t i = 0; elements && i < elements->size(); ++i) {
            toml::table* candidate = (*elements)[i].as_table();
            if (!candidate) continue;
            const std::string number = std::to_string(i);
            const std::string name = (*candidate)["name"].value_or(number);
            if (which == name || which == number) return candidate;
            known += (known.empty() ? "" : ", ") + name;
        }
        fail("the scene has no " + key + " " + which +
             ", expected one of: " + (known.empty() ? "none" : known));
        return nullptr;
    }

    toml::table& root_;
    std::vector<std::string>& notes_;
    Error& error_;
    std::string source_;
};

} // namespace

bool applyOverrides(toml::table& root, const std::vector<std::string>& assignments,
                    std::vector<std::string>& notes, Error& error) {
    Overrider overrider(root, notes, error);
    return std::ranges::all_of(assignments,
                               [&](const std::string& assignment) { return overrider.apply(assignment); });
}

} // namespace demos::reading
