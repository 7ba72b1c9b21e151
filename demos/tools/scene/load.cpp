#include "scene/scene.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <span>
#include <sstream>
#include <system_error>

// Files break what its parser asserts of keys, behind which an error stands all the same. With NDEBUG such an
// assert would be a promise to the compiler.
#define TOML_ASSERT(condition) static_assert(true)
#ifdef NDEBUG
#undef NDEBUG
#include <toml++/toml.h>
#define NDEBUG
#else
#include <toml++/toml.h>
#endif

#include "scene/fields.h"
#include "scene/former_keys.h"
#include "scene/input_limits.h"
#include "scene/motion/motion.h"
#include "scene/nearest.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

constexpr size_t longestValue = 60;
constexpr size_t mostSwells = 4;

std::string join(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
}

/// A value as it would be written, cut to fit on a line.
std::string quote(const toml::node& node) {
    if (node.is_table()) return "a table";
    if (node.is_array_of_tables()) return "an array of tables";
    std::ostringstream stream;
    node.visit([&stream](const auto& value) { stream << value; });
    std::string text = stream.str();
    std::replace(text.begin(), text.end(), '\n', ' ');
    if (text.size() > longestValue) text = text.substr(0, longestValue) + "...";
    return text;
}

/// An override's nodes carry its text as their source and no useful line.
constexpr std::string_view overrideMark = "--set ";

std::string place(const toml::source_region& source, const std::string& file) {
    if (!source.path || source.path->empty()) return file;
    if (source.path->starts_with(overrideMark)) return *source.path;
    return *source.path + ":" + std::to_string(source.begin.line);
}

std::string place(const toml::node& node, const std::string& file) {
    return place(node.source(), file);
}

// ---- Did you mean

/// Full paths of everything that a section holds.
void listPaths(const Section& section, const std::string& path, std::vector<std::string>& out) {
    for (const Field& field : section.fields) out.push_back(join(path, field.key));
    for (const Child& child : section.children) {
        const std::string childPath = join(path, child.section->key);
        out.push_back(childPath);
        listPaths(*child.section, childPath, out);
    }
}

std::string_view lastOf(std::string_view path) {
    return path.substr(path.rfind('.') + 1);
}
std::string_view parentOf(std::string_view path) {
    const size_t dot = path.rfind('.');
    return dot == path.npos ? std::string_view{} : path.substr(0, dot);
}

/// The nearest known path; of equally near ones, one in the same section.
std::string nearestPath(const std::string& schemaPath) {
    const std::string parent(parentOf(schemaPath));
    const std::string_view now = presentKey(lastOf(parent), lastOf(schemaPath));
    if (now != lastOf(schemaPath)) return join(parent, now);
    std::vector<std::string> known;
    listPaths(sceneSection(), "", known);
    const auto distance = [&schemaPath](const std::string& candidate) {
        const size_t elsewhere = parentOf(candidate) == parentOf(schemaPath) ? 0 : 1;
        return 2 * editDistance(lastOf(schemaPath), lastOf(candidate)) + elsewhere;
    };
    return *std::min_element(
        known.begin(), known.end(),
        [&distance](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
}

// ---- Reading values

/// Fills a scene from parsed TOML. The first error wins.
class Reader {
  public:
    Reader(const fs::path& file, Error& error)
        : file_(file.string()), folder_(fs::absolute(file).parent_path()), error_(error) {}

    /// `path` is what errors say ("mesh.0"), `schemaPath` what the table calls it ("mesh").
    bool read(const toml::table& table, const Section& section, void* owner, const std::string& path,
              const std::string& schemaPath) {
        for (const auto& [key, node] : table) {
            if (!isKnown(section, key.str())) return unknown(node, key, path, schemaPath);
        }
        for (const Field& field : section.fields) {
            const toml::node* node = table.get(field.key);
            if (!node && field.required) return missing(table, field, owner, path);
            if (node && !read(*node, field, field.target(owner), join(path, field.key))) return false;
        }
        for (const Child& child : section.children) {
            if (!read(table, child, owner, path, schemaPath)) return false;
        }
        return true;
    }

    bool fail(const std::string& where, const std::string& what) {
        error_.text = where + ": " + what;
        return false;
    }

    const std::string& file() const { return file_; }

  private:
    static bool isKnown(const Section& section, std::string_view key) {
        return std::any_of(section.fields.begin(), section.fields.end(),
                           [key](const Field& field) { return field.key == key; }) ||
               std::any_of(section.children.begin(), section.children.end(),
                           [key](const Child& child) { return child.section->key == key; });
    }

    bool unknown(const toml::node& node, const toml::key& key, const std::string& path,
                 const std::string& schemaPath) {
        const toml::source_region& source = key.source().path ? key.source() : node.source();
        return fail(place(source, file_), join(path, key.str()) + " is not a known key, the nearest is " +
                                              nearestPath(join(schemaPath, key.str())));
    }

    bool missing(const toml::table& table, const Field& field, void* owner, const std::string& path) {
        return fail(place(table, file_), join(path, field.key) + " is missing, expected " +
                                             expectation(field, field.target(owner)));
    }

    bool wrong(const toml::node& node, const std::string& path, const std::string& expected) {
        return fail(place(node, file_), path + " is " + quote(node) + ", expected " + expected);
    }

    bool read(const toml::table& parent, const Child& child, void* owner, const std::string& path,
              const std::string& schemaPath) {
        const std::string_view key = child.section->key;
        const std::string childPath = join(path, key), childSchemaPath = join(schemaPath, key);
        const toml::node* node = parent.get(key);
        if (!node) {
            if (!child.required) return true;
            return fail(file_, childPath + " is missing, expected " + heading(child, childSchemaPath));
        }
        if (!child.repeated) {
            const toml::table* table = node->as_table();
            if (!table) return wrong(*node, childPath, "a table: " + heading(child, childSchemaPath));
            return read(*table, *child.section, child.access.open(owner), childPath, childSchemaPath);
        }
        const toml::array* tables = node->as_array();
        if (!tables) return wrong(*node, childPath, "an array of tables: " + heading(child, childSchemaPath));
        if (tables->empty() && child.required) {
            return wrong(*node, childPath, "at least one: " + heading(child, childSchemaPath));
        }
        if (tables->size() > limits::sceneTables)
            return fail(place(*node, file_), childPath + " has " + std::to_string(tables->size()) +
                                                 " tables, expected at most 256");
        for (size_t i = 0; i < tables->size(); ++i) {
            const toml::node& element = (*tables)[i];
            const std::string elementPath = join(childPath, std::to_string(i));
            if (!element.is_table())
                return wrong(element, elementPath, "a table: " + heading(child, childSchemaPath));
            if (!read(*element.as_table(), *child.section, child.access.open(owner), elementPath,
                      childSchemaPath))
                return false;
        }
        return true;
    }

    static std::string heading(const Child& child, const std::string& path) {
        return child.repeated ? "[[" + path + "]]" : "[" + path + "]";
    }

    bool read(const toml::node& node, const Field& field, const Target& target, const std::string& path) {
        const bool good = std::visit([&](auto value) { return convert(node, field, value); }, target);
        if (!good) return wrong(node, path, expectation(field, target));
        if (const auto* file = std::get_if<fs::path*>(&target)) return findFile(node, **file, field, path);
        return true;
    }

    /// Every range is finite, so that NaN and infinity are in none.
    static bool inRange(const Field& field, double value) {
        if (field.rule == Rule::zeroOrRange && value == 0) return true;
        if (field.rule == Rule::positive && value == field.least) return false;
        return field.least <= value && value <= field.most;
    }

    template<class Value>
    static bool convert(const toml::node& node, const Field& field, Value* out) {
        return convert(node, field, *out);
    }

    static bool convert(const toml::node& node, const Field& field, const Setting& out) {
        switch (out.field->type) {
        case seaglass::FieldType::boolean:
            return convertTo<bool>(node, field, out);
        case seaglass::FieldType::integer:
            return convertTo<uint32_t>(node, field, out);
        case seaglass::FieldType::choice:
            return choose(node, field, out);
        default:
            return convertTo<double>(node, field, out);
        }
    }

    template<class Value>
    static bool convertTo(const toml::node& node, const Field& field, const Setting& out) {
        Value value{};
        if (!convert(node, field, value)) return false;
        out.set(static_cast<double>(value));
        return true;
    }

    static bool choose(const toml::node& node, const Field& field, const Setting& out) {
        std::string word;
        if (!convert(node, field, word)) return false;
        const auto index = std::ranges::find(field.choices, word) - field.choices.begin();
        out.set(out.field->low + static_cast<double>(index));
        return true;
    }

    static bool convert(const toml::node& node, const Field& field, double& out) {
        // value<double>() has none for a whole number that no double is.
        if (node.is_integer())
            out = static_cast<double>(node.as_integer()->get());
        else if (node.is_floating_point())
            out = node.as_floating_point()->get();
        else
            return false;
        return inRange(field, out);
    }

    static bool convert(const toml::node& node, const Field& field, std::vector<Vec2>& out) {
        const toml::array* pairs = node.as_array();
        if (!pairs) return false;
        out.resize(pairs->size());
        for (size_t i = 0; i < out.size(); ++i) {
            if (!convert((*pairs)[i], field, out[i])) return false;
        }
        return true;
    }

    template<size_t count>
    static bool convert(const toml::node& node, const Field& field, std::array<double, count>& out) {
        const toml::array* numbers = node.as_array();
        if (!numbers || numbers->size() != out.size()) return false;
        for (size_t i = 0; i < out.size(); ++i) {
            if (!convert((*numbers)[i], field, out[i])) return false;
        }
        return true;
    }

    static bool convert(const toml::node& node, const Field& field, uint64_t& out) {
        const auto* integer = node.as_integer();
        if (!integer || integer->get() < 0) return false;
        out = static_cast<uint64_t>(integer->get());
        return inRange(field, static_cast<double>(out));
    }

    static bool convert(const toml::node& node, const Field& field, uint32_t& out) {
        uint64_t wide = 0;
        if (!convert(node, field, wide)) return false;
        out = static_cast<uint32_t>(wide);
        if (field.rule == Rule::powerOfTwo) return std::has_single_bit(out);
        return true;
    }

    static bool convert(const toml::node& node, const Field&, bool& out) {
        if (!node.is_boolean()) return false;
        out = node.as_boolean()->get();
        return true;
    }

    static bool convert(const toml::node& node, const Field& field, std::string& out) {
        if (!node.is_string()) return false;
        out = node.as_string()->get();
        if (field.rule == Rule::identifier) {
            return !out.empty() &&
                   out.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                         "0123456789_-") == out.npos;
        }
        return field.choices.empty() ||
               std::find(field.choices.begin(), field.choices.end(), out) != field.choices.end();
    }

    static bool convert(const toml::node& node, const Field&, fs::path& out) {
        if (!node.is_string() || node.as_string()->get().empty()) return false;
        out = node.as_string()->get();
        return true;
    }

    bool findFile(const toml::node& node, fs::path& file, const Field& field, const std::string& path) {
        file = (folder_ / file).lexically_normal();
        std::error_code code;
        if (fs::is_regular_file(file, code)) return true;
        const std::string why = fs::is_directory(file, code) ? " is a folder" : " is not there";
        return wrong(node, path, "a " + std::string(field.about) + "; " + file.string() + why);
    }

    std::string file_;
    fs::path folder_;
    Error& error_;
};

// ---- What is said in one way of two: the colour of water, and how much a camera shows

constexpr const char* colorByTint[] = {"tint", "visibility_m"};
constexpr const char* colorByWater[] = {"type", "absorption_per_m", "backscatter_per_m"};
constexpr const char* shownByAngle[] = {"vertical_fov_deg"};
constexpr const char* shownByHeight[] = {"orthographic_height_m"};

bool isOverride(const toml::node& node) {
    const toml::source_region& source = node.source();
    return source.path && source.path->starts_with(overrideMark);
}

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

// ---- What was once called otherwise

std::string calledNow(const std::string& where, const std::string& path, std::string_view key,
                      std::string_view now) {
    return where + ": " + join(path, key) + " is called " + std::string(now) + " now";
}

std::string isGone(const std::string& where, const std::string& path, const GoneKey& gone) {
    return where + ": " + join(path, gone.key) + " is no more: " + std::string(gone.why);
}

/// Gives the file's former keys their present names, but where both are there, and drops those that went.
void renameFormer(toml::table& table, const Section& section, const std::string& path,
                  const std::string& file, std::vector<std::string>& notes) {
    for (const FormerKey& former : formerKeys) {
        const toml::node* const node = table.get(former.before);
        if (section.key != former.section || !node || table.contains(former.now)) continue;
        notes.push_back(calledNow(place(*node, file), path, former.before, former.now));
        table.get(former.before)->visit([&](auto& found) { table.insert(former.now, std::move(found)); });
        table.erase(former.before);
    }
    for (const GoneKey& gone : goneKeys) {
        const toml::node* const node = table.get(gone.key);
        if (section.key != gone.section || !node) continue;
        notes.push_back(isGone(place(*node, file), path, gone));
        table.erase(gone.key);
    }
    for (const Child& child : section.children) {
        toml::node* const node = table.get(child.section->key);
        if (!node) continue;
        const std::string childPath = join(path, child.section->key);
        if (toml::table* const below = node->as_table())
            renameFormer(*below, *child.section, childPath, file, notes);
        toml::array* const elements = node->as_array();
        for (size_t i = 0; elements && i < elements->size(); ++i)
            if (toml::table* const below = (*elements)[i].as_table())
                renameFormer(*below, *child.section, join(childPath, std::to_string(i)), file, notes);
    }
}

// ---- TOML

/// Where the string that begins at `at` is over; one of a line ends with that at the latest.
size_t endOfString(std::string_view text, size_t at) {
    const std::string_view three = text.substr(at, 3);
    const bool escapes = text[at] == '"', lines = three == "\"\"\"" || three == "'''";
    const std::string_view closing = lines ? three : text.substr(at, 1);
    for (at += closing.size(); at < text.size(); ++at) {
        if (text.substr(at).starts_with(closing)) {
            at += closing.size();
            // Up to two quotes may stand right before the closing ones.
            while (lines && at < text.size() && text[at] == closing[0]) ++at;
            return at;
        }
        if (text[at] == '\n' && !lines) return at;
        if (text[at] == '\\' && escapes) ++at;
    }
    return text.size();
}

/// Whether keys are as short as those of scenes: toml++ recurses into each part of a dotted one.
bool hasShortKeys(std::string_view text) {
    constexpr std::string_view betweenKeys = "\n=,[{#";
    size_t dots = 0;
    for (size_t i = 0; i < text.size();) {
        if (text[i] == '"' || text[i] == '\'') {
            i = endOfString(text, i);
            continue;
        }
        if (betweenKeys.find(text[i]) != betweenKeys.npos) dots = 0;
        if (text[i] == '#') i = std::min(text.find('\n', i), text.size() - 1);
        if (text[i] == '.' && ++dots >= limits::sceneKeyParts) return false;
        ++i;
    }
    return true;
}

// ---- Overrides

/// The value of "path=value": TOML, or else a bare word. Its nodes say where they come from.
std::optional<toml::table> parseValue(const std::string& text, const std::string& source) {
    if (!hasShortKeys(text)) return std::nullopt;
    toml::parse_result parsed = toml::parse("v = " + text + "\n", source);
    if (parsed && parsed.table().size() == 1) return std::move(parsed).table();
    if (text.empty() || text.find_first_of("\"'[]{}\n") != text.npos) return std::nullopt;
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

// ---- What fields say together

bool checkOrthographic(const Scene& scene, const CameraDesc& camera, const toml::table& table,
                       const std::string& path, Reader& reader) {
    if (camera.orthographicHeightM == 0) return true;
    const auto fail = [&](const char* why) {
        return reader.fail(place(*table.get("orthographic_height_m"), reader.file()),
                           path + ".orthographic_height_m is set, " + why);
    };
    if (table.contains("vertical_fov_deg"))
        return fail("expected no vertical_fov_deg then: a camera shows an angle or a height");
    return scene.floor ? fail("expected no [floor], which is seen from an eye") : true;
}

/// Keyframes come one after another, and what loops ends where it began.
template<class Moving>
bool checkKeyframes(const Moving& moving, const toml::table& table, const std::string& path, Reader& reader) {
    if (moving.keyframes.empty()) {
        return !moving.loops || reader.fail(place(*table.get("loops"), reader.file()),
                                            path + ".loops is true, expected keyframes to go through");
    }
    const auto keyframe = [&](size_t i) { return path + ".keyframes." + std::to_string(i); };
    const toml::array& tables = *table.get_as<toml::array>("keyframes");
    for (size_t i = 1; i < moving.keyframes.size(); ++i) {
        if (moving.keyframes[i].timeS > moving.keyframes[i - 1].timeS) continue;
        const toml::node& time = *tables[i].as_table()->get("time_s");
        return reader.fail(place(time, reader.file()), keyframe(i) + ".time_s is " + quote(time) +
                                                           ", expected a later time than that of " +
                                                           keyframe(i - 1));
    }
    if (!moving.loops || endsWhereItBegins(moving)) return true;
    return reader.fail(place(tables.back(), reader.file()),
                       keyframe(moving.keyframes.size() - 1) + " is elsewhere than " + path +
                           " begins, expected the same pose: " + path + ".loops is true");
}

bool checkCameras(const Scene& scene, const toml::table& root, Reader& reader) {
    const toml::array& tables = *root.get_as<toml::array>("camera");
    for (size_t i = 0; i < scene.cameras.size(); ++i) {
        const CameraDesc& camera = scene.cameras[i];
        const toml::table& table = *tables[i].as_table();
        const std::string path = "camera." + std::to_string(i);
        const auto first =
            std::find_if(scene.cameras.begin(), scene.cameras.end(),
                         [&camera](const CameraDesc& other) { return other.name == camera.name; });
        if (&*first != &camera) {
            return reader.fail(place(*table.get("name"), reader.file()),
                               path + ".name is '" + camera.name + "', expected a name that camera." +
                                   std::to_string(first - scene.cameras.begin()) + " does not have");
        }
        const double away =
            std::hypot(camera.targetM[0] - camera.positionM[0], camera.targetM[1] - camera.positionM[1],
                       camera.targetM[2] - camera.positionM[2]);
        if (away < 1e-6) {
            return reader.fail(place(*table.get("target_m"), reader.file()),
                               path + ".target_m is its position_m, expected a point away from the eye");
        }
        if (!checkOrthographic(scene, camera, table, path, reader)) return false;
        if (!checkKeyframes(camera, table, path, reader)) return false;
    }
    return true;
}

bool checkMeshes(const Scene& scene, const toml::table& root, Reader& reader) {
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
        const toml::table& table = *root["mesh"][i].as_table();
        const std::string path = "mesh." + std::to_string(i);
        if (!checkKeyframes(scene.meshes[i], table, path, reader)) return false;
        if (scene.meshes[i].floats && !(scene.water && scene.water->tiltDeg == 0))
            return reader.fail(place(*table.get("floats"), reader.file()),
                               path + ".floats is true, expected [water], and water.tilt_deg of 0");
    }
    return true;
}

bool checkWater(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || scene.water->waves) return true;
    if (scene.water->shore)
        return reader.fail(place(*root["water"]["shore"].node(), reader.file()),
                           "water.shore is set, expected [water.waves] too: it is they who run up a shore");
    if (!scene.water->foam) return true;
    return reader.fail(place(*root["water"]["foam"].node(), reader.file()),
                       "water.foam is set, expected [water.waves] too: foam comes from waves");
}

bool checkWaves(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || !scene.water->waves) return true;
    const WavesDesc& waves = *scene.water->waves;
    const toml::table& table = *root["water"]["waves"].as_table();
    const size_t most = waves.beaufort == WavesDesc::noForce ? mostSwells : mostSwells - 1;
    if (waves.swells.size() > most) {
        return reader.fail(place(*table.get("swells"), reader.file()),
                           "water.waves.swells are " + std::to_string(waves.swells.size()) +
                               ", expected at most " + std::to_string(most) +
                               (most < mostSwells ? ": beaufort has one of its own" : ""));
    }
    if (waves.spectrum != "table" || !waves.spectrumTable.empty()) return true;
    return reader.fail(place(*table.get("spectrum"), reader.file()),
                       "water.waves.spectrum is 'table', expected water.waves.spectrum_table too");
}

/// The first of `keys` that a table has, or null.
const char* firstOf(const toml::table& table, std::span<const char* const> keys) {
    const auto found = std::ranges::find_if(keys, [&](const char* key) { return table.contains(key); });
    return found == keys.end() ? nullptr : *found;
}

bool checkRefraction(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || !scene.water->refraction) return true;
    const toml::table& table = *root["water"]["refraction"].as_table();
    const char* const set = firstOf(table, colorByTint);
    if (!set) return true;
    const char* const other = firstOf(table, colorByWater);
    const auto fail = [&](const char* key, const std::string& expected) {
        return reader.fail(place(*table.get(key), reader.file()),
                           std::string("water.refraction.") + key + " is set, expected " + expected);
    };
    if (other)
        return fail(other, std::string("no water.refraction.") + set + " then: a water has one colour");
    for (const char* const key : colorByTint)
        if (!table.contains(key)) return fail(set, std::string("water.refraction.") + key + " too");
    return true;
}

bool checkExtent(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || !scene.water->extent) return true;
    if (scene.water->planetRadiusM != 0)
        return reader.fail(place(*root["water"]["planet_radius_m"].node(), reader.file()),
                           "water.planet_radius_m is set, expected no water.extent then: its water is level");
    const ExtentDesc& extent = *scene.water->extent;
    const char* missing = nullptr;
    if (extent.shape == "rectangle" && extent.sizeM[0] == 0) missing = "size_m";
    if (extent.shape == "polygon" && extent.pointsM.empty()) missing = "points_m";
    if (extent.shape == "mesh" && extent.file.empty()) missing = "file";
    if (!missing) return true;
    return reader.fail(place(*root["water"]["extent"].node(), reader.file()),
                       "water.extent is a " + extent.shape + ", expected water.extent." + missing + " too");
}

bool checkFloor(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.floor) return true;
    if (scene.water) {
        return reader.fail(place(*root["floor"].node(), reader.file()),
                           "floor is set, expected no [water] then: a scene has one surface that mirrors");
    }
    const Vec3& normal = scene.floor->normal;
    if (std::hypot(normal[0], normal[1], normal[2]) >= 1e-6) return true;
    return reader.fail(place(*root["floor"]["normal"].node(), reader.file()),
                       "floor.normal has no length, expected a direction, such as [0, 1, 0]");
}

bool checkFog(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.fog || scene.fog->shape != "linear" || scene.fog->startM < scene.fog->endM) return true;
    const toml::table& table = *root["fog"].as_table();
    const char* const keys[] = {"start_m", "end_m"};
    const char* const set = firstOf(table, keys);
    return reader.fail(place(*table.get(set), reader.file()),
                       std::string("fog.") + set +
                           " leaves no way from fog.start_m to fog.end_m, expected a start before the end");
}

/// Where meshes and sky were named, for those who will find out whether they can be read.
void rememberPlaces(Scene& scene, const toml::table& root, const std::string& file) {
    scene.sky.where = place(*root["sky"]["file"].node(), file) + ": sky.file";
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
        scene.meshes[i].where =
            place(*root["mesh"][i]["file"].node(), file) + ": mesh." + std::to_string(i) + ".file";
    }
    if (scene.water && scene.water->extent && !scene.water->extent->file.empty())
        scene.water->extent->where =
            place(*root["water"]["extent"]["file"].node(), file) + ": water.extent.file";
    if (scene.water && scene.water->shore)
        scene.water->shore->where =
            place(*root["water"]["shore"]["file"].node(), file) + ": water.shore.file";
    if (scene.floor && !scene.floor->texture.empty())
        scene.floor->where = place(*root["floor"]["texture"].node(), file) + ": floor.texture";
}

std::optional<std::string> readText(const fs::path& file, Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = file.string() + ": " + what;
        return std::nullopt;
    };
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) return fail("no such file, expected a scene (TOML)");
    if (fs::is_directory(status)) return fail("is a folder, expected a scene file (TOML)");
    if (!fs::is_regular_file(status)) return fail("is no regular file, expected a scene file (TOML)");
    const uintmax_t size = fs::file_size(file, code);
    if (code) return fail("cannot be read: " + code.message());
    if (size > limits::sceneBytes)
        return fail("has " + std::to_string(size) + " bytes, expected a scene of at most 1 MB");
    std::ifstream stream(file, std::ios::binary);
    std::string text(static_cast<size_t>(size), '\0');
    if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
        return fail("cannot be read, expected a scene (TOML)");
    return text;
}

} // namespace

std::optional<Scene> loadScene(const fs::path& file, const std::vector<std::string>& overrides,
                               Error& error) {
    const std::optional<std::string> text = readText(file, error);
    if (!text) return std::nullopt;

    if (!hasShortKeys(*text)) {
        error.text = file.string() + ": has a key of over 16 parts, expected a scene (TOML)";
        return std::nullopt;
    }
    toml::parse_result parsed = toml::parse(*text, file.string());
    if (!parsed) {
        std::string what(parsed.error().description());
        std::replace(what.begin(), what.end(), '\n', ' ');
        error.text = place(parsed.error().source(), file.string()) + ": not valid TOML: " + what;
        return std::nullopt;
    }
    toml::table& root = parsed.table();

    Scene scene;
    renameFormer(root, sceneSection(), "", file.string(), scene.notes);
    Overrider overrider(root, scene.notes, error);
    for (const std::string& assignment : overrides) {
        if (!overrider.apply(assignment)) return std::nullopt;
    }

    scene.file = fs::absolute(file).lexically_normal();
    Reader reader(file, error);
    if (!reader.read(root, sceneSection(), &scene, "", "")) return std::nullopt;
    if (!checkCameras(scene, root, reader) || !checkMeshes(scene, root, reader) ||
        !checkWater(scene, root, reader) || !checkRefraction(scene, root, reader) ||
        !checkExtent(scene, root, reader) || !checkWaves(scene, root, reader) ||
        !checkFloor(scene, root, reader) || !checkFog(scene, root, reader))
        return std::nullopt;
    if (scene.water) scene.water->saysGlitter = root["water"].as_table()->contains("glitter");
    rememberPlaces(scene, root, file.string());
    return scene;
}

} // namespace demos
