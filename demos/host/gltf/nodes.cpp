#include "host/gltf/nodes.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace demos::gltf {
namespace {

glm::dmat4 transformOf(const double (&translation)[3], const double (&rotation)[4],
                       const double (&scale)[3]) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::make_vec3(translation));
    const glm::dmat4 turned =
        moved * glm::mat4_cast(glm::dquat(rotation[3], rotation[0], rotation[1], rotation[2]));
    return glm::scale(turned, glm::make_vec3(scale));
}

bool readLocal(const Json& node, const std::string& where, glm::dmat4& out, Error& error) {
    double matrix[16], translation[3] = {0, 0, 0}, rotation[4] = {0, 0, 0, 1}, scale[3] = {1, 1, 1};
    if (!member(node, "matrix").is_null()) {
        if (!readNumbers(node, "matrix", where, matrix, error)) return false;
        out = glm::make_mat4(matrix);
        return true;
    }
    if (!readNumbers(node, "translation", where, translation, error) ||
        !readNumbers(node, "rotation", where, rotation, error) ||
        !readNumbers(node, "scale", where, scale, error))
        return false;
    out = transformOf(translation, rotation, scale);
    return true;
}

bool isFinite(const glm::dmat4& matrix) {
    return std::all_of(glm::value_ptr(matrix), glm::value_ptr(matrix) + 16,
                       [](double value) { return std::isfinite(value); });
}

bool isHidden(const Json& node) {
    const Json& visible = member(extension(node, "KHR_node_visibility"), "visible");
    return visible.is_boolean() && !visible.get<bool>();
}

} // namespace

bool Nodes::read(Error& error) {
    std::vector<size_t> open;
    if (!readChildren(error) || !placeAll(error) || !readRoots(open, error)) return false;
    // Of lights and images around the scene it is said where they shine.
    notes_.addExtensions("the file", document_.root,
                         {"KHR_lights_punctual", "EXT_lights_ies", "EXT_lights_image_based"});
    if (document_.count("animations") > 0) notes_.add("animations", "are not played: all is drawn at rest");
    while (!open.empty()) {
        const size_t node = open.back();
        open.pop_back();
        if (!world_[node]) {
            error.text = placeOfNode(node) + " is its own descendant, expected a tree";
            return false;
        }
        if (isHidden(document_.at("nodes", node))) continue;
        if (!readMesh(node, error)) return false;
        open.insert(open.end(), children_[node].begin(), children_[node].end());
    }
    return true;
}

bool Nodes::readList(const Json& list, const std::string& where, std::vector<size_t>& out,
                     Error& error) const {
    const size_t count = document_.count("nodes");
    for (size_t i = 0; list.is_array() && i < list.size(); ++i) {
        std::optional<size_t> index = indexOf(list[i], count);
        // Which names what is wrong.
        if (!index && !readIndex({{"index", list[i]}}, "index", count, where + "[" + std::to_string(i) + "]",
                                 index, error))
            return false;
        if (index) out.push_back(*index);
    }
    return true;
}

bool Nodes::readChildren(Error& error) {
    const size_t count = document_.count("nodes");
    children_.resize(count);
    isChild_.resize(count, false);
    for (size_t i = 0; i < count; ++i) {
        const Json& list = member(document_.at("nodes", i), "children");
        if (list.is_null()) continue;
        if (!readList(list, placeOfNode(i) + ".children", children_[i], error)) return false;
        for (const size_t child : children_[i]) {
            if (isChild_[child]) {
                error.text = placeOfNode(child) + " is reached twice, expected a tree";
                return false;
            }
            isChild_[child] = true;
        }
    }
    return true;
}

/// From the roots down; what lies on a cycle is not reached.
bool Nodes::placeAll(Error& error) {
    world_.resize(children_.size());
    std::vector<std::pair<size_t, glm::dmat4>> open;
    for (size_t i = 0; i < children_.size(); ++i)
        if (!isChild_[i]) open.emplace_back(i, glm::dmat4(1));
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        glm::dmat4 local;
        if (!readLocal(document_.at("nodes", node), placeOfNode(node), local, error)) return false;
        const glm::dmat4 world = parent * local;
        if (!isFinite(world)) {
            error.text = placeOfNode(node) + " has a transform that is not finite";
            return false;
        }
        world_[node] = world;
        for (const size_t child : children_[node]) open.emplace_back(child, world);
    }
    return true;
}

/// Of a file without scenes all, but for those that stand for another where it is seen from afar.
bool Nodes::readAllRoots(std::vector<size_t>& out, Error& error) const {
    std::vector<size_t> coarser;
    for (size_t i = 0; i < children_.size(); ++i)
        if (!readList(member(extension(document_.at("nodes", i), "MSFT_lod"), "ids"),
                      placeOfNode(i) + ".MSFT_lod.ids", coarser, error))
            return false;
    std::vector<bool> isRoot = isChild_;
    isRoot.flip();
    for (const size_t node : coarser) isRoot[node] = false;
    for (size_t i = 0; i < isRoot.size(); ++i)
        if (isRoot[i]) out.push_back(i);
    return true;
}

bool Nodes::readRoots(std::vector<size_t>& out, Error& error) {
    const size_t scenes = document_.count("scenes");
    if (scenes == 0) return readAllRoots(out, error);
    std::optional<size_t> scene;
    if (!readIndex(document_.root, "scene", scenes, "the file", scene, error)) return false;
    if (!scene && scenes > 1)
        notes_.add("scenes",
                   "none is said to be shown: the first of " + std::to_string(scenes) + " is drawn");
    const Json& shown = document_.at("scenes", scene.value_or(0));
    const std::string where = placeOf("scenes", scene.value_or(0), shown);
    notes_.addExtensions(where, shown);
    if (!readList(member(shown, "nodes"), where + ".nodes", out, error)) return false;
    std::vector<bool> known(children_.size(), false);
    for (const size_t node : out) {
        if (known[node]) {
            error.text = placeOfNode(node) + " is reached twice, expected a tree";
            return false;
        }
        known[node] = true;
    }
    return true;
}

bool Nodes::readMesh(size_t index, Error& error) {
    const Json& node = document_.at("nodes", index);
    const std::string where = placeOfNode(index);
    notes_.addExtensions(where, node, {"EXT_mesh_gpu_instancing", "KHR_node_visibility"});
    std::optional<size_t> meshIndex, skin;
    if (!readIndex(node, "mesh", document_.count("meshes"), where, meshIndex, error) ||
        !readIndex(node, "skin", document_.count("skins"), where, skin, error))
        return false;
    if (!meshIndex) return true;
    const Json& mesh = document_.at("meshes", *meshIndex);
    const std::string meshWhere = placeOf("meshes", *meshIndex, mesh);
    notes_.addExtensions(meshWhere, mesh);
    Stand stand;
    if (!readWeights(node, mesh, where, stand, error) ||
        !readInstances(node, where, *world_[index], stand, error) || (skin && !readSkin(*skin, stand, error)))
        return false;
    const Json& primitives = member(mesh, "primitives");
    for (size_t i = 0; primitives.is_array() && i < primitives.size(); ++i)
        if (!primitives_.add(primitives[i], meshWhere + ".primitives[" + std::to_string(i) + "]", stand,
                             error))
            return false;
    return true;
}

bool Nodes::readWeights(const Json& node, const Json& mesh, const std::string& where, Stand& out,
                        Error& error) {
    const Json& own = member(node, "weights");
    const Json& source = own.is_null() ? mesh : node;
    const Json& weights = member(source, "weights");
    out.weights.resize(weights.is_array() ? weights.size() : 0);
    return buffers_.spend(out.weights.size(), where, error) &&
           readNumbers(source, "weights", where, out.weights, error);
}

bool Nodes::readInstances(const Json& node, const std::string& where, const glm::dmat4& world, Stand& out,
                          Error& error) {
    const Json& attributes = member(extension(node, "EXT_mesh_gpu_instancing"), "attributes");
    if (attributes.is_null()) {
        out.places = {world};
        return true;
    }
    Elements translations, rotations, scales;
    size_t count = 0;
    const auto read = [&](const char* name, size_t components, Elements& elements) {
        std::optional<size_t> accessor;
        const std::string what = where + "." + name;
        if (!readIndex(attributes, name, document_.count("accessors"), where, accessor, error)) return false;
        if (!accessor) return true;
        if (!buffers_.elements(*accessor, what, elements, error)) return false;
        if (elements.components == components && (count == 0 || elements.count == count)) {
            count = elements.count;
            return true;
        }
        error.text = what + " has the wrong type or count";
        return false;
    };
    for (const char* const color : {"_COLOR_0", "COLOR_0"})
        if (!member(attributes, color).is_null())
            notes_.add(where, std::string(color) + " of its instances is left out");
    if (!read("TRANSLATION", 3, translations) || !read("ROTATION", 4, rotations) || !read("SCALE", 3, scales))
        return false;
    // Attributes of other names place nothing: all instances then stand where the node does.
    if (count == 0) out.places = {world};
    instances_ += count;
    if (instances_ > limits::gltfInstances) {
        error.text = where + " brings the scene over a million instances";
        return false;
    }
    for (size_t i = 0; i < count; ++i) {
        double translation[3] = {0, 0, 0}, rotation[4] = {0, 0, 0, 1}, scale[3] = {1, 1, 1};
        for (size_t c = 0; c < 4; ++c) {
            if (c < 3 && translations.count > 0) translation[c] = double{translations.component(i, c)};
            if (c < 3 && scales.count > 0) scale[c] = double{scales.component(i, c)};
            if (rotations.count > 0) rotation[c] = double{rotations.component(i, c)};
        }
        out.places.push_back(world * transformOf(translation, rotation, scale));
    }
    return true;
}

/// A skinned mesh stands where its joints have it, whatever node it hangs on (glTF 2.0, 3.7.3.3). Read once,
/// however many nodes have it.
bool Nodes::readSkin(size_t index, Stand& out, Error& error) {
    const Json& skin = document_.at("skins", index);
    const std::string where = placeOf("skins", index, skin);
    if (!buffers_.spend(16 * member(skin, "joints").size(), where, error)) return false;
    const auto [known, fresh] = skins_.try_emplace(index);
    if (fresh && !readJoints(skin, where, known->second, error)) return false;
    out.joints = known->second;
    return true;
}

bool Nodes::readJoints(const Json& skin, const std::string& where, std::vector<glm::dmat4>& out,
                       Error& error) {
    std::vector<size_t> joints;
    std::optional<size_t> inverse;
    Elements matrices;
    if (!readList(member(skin, "joints"), where + ".joints", joints, error) ||
        !readIndex(skin, "inverseBindMatrices", document_.count("accessors"), where, inverse, error) ||
        (inverse && !buffers_.elements(*inverse, where + ".inverseBindMatrices", matrices, error)))
        return false;
    if (inverse && (matrices.components != 16 || matrices.count < joints.size())) {
        error.text = where + ".inverseBindMatrices has the wrong type or count";
        return false;
    }
    for (size_t i = 0; i < joints.size(); ++i) {
        glm::dmat4 bound(1);
        for (int c = 0; inverse && c < 16; ++c)
            glm::value_ptr(bound)[c] = double{matrices.component(i, static_cast<size_t>(c))};
        const std::optional<glm::dmat4>& world = world_[joints[i]];
        if (!world) {
            error.text = placeOfNode(joints[i]) + " is its own descendant, expected a tree";
            return false;
        }
        out.push_back(*world * bound);
    }
    return true;
}

} // namespace demos::gltf
