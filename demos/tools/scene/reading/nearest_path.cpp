#include "scene/reading/nearest_path.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "scene/fields.h"
#include "scene/former_keys.h"
#include "scene/nearest.h"
#include "scene/reading/places.h"

namespace demos::reading {
namespace {

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

} // namespace

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

} // namespace demos::reading
