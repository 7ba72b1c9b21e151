#include "host/gltf/primitives.h"

#include <algorithm>
#include <cmath>

namespace demos::gltf {
namespace {

constexpr double maxCoordinate = 1e7;
constexpr size_t maxUvSets = 16;

enum Mode : size_t { points, lines, lineLoop, lineStrip, triangles, triangleStrip, triangleFan };

std::vector<uint32_t> asTriangles(const std::vector<uint32_t>& corners, size_t mode) {
    std::vector<uint32_t> made;
    for (size_t i = 2; i < corners.size(); ++i) {
        const bool odd = i % 2 == 1;
        if (mode == triangleFan)
            made.insert(made.end(), {corners[0], corners[i - 1], corners[i]});
        else
            made.insert(made.end(), {corners[odd ? i - 1 : i - 2], corners[odd ? i - 2 : i - 1], corners[i]});
    }
    return made;
}

/// Cofactors carry normals through any linear map, a singular one included.
glm::dvec3 normalThrough(const glm::dmat3& m, const glm::dvec3& normal) {
    const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return (glm::determinant(m) < 0 ? -1.0 : 1.0) * (cofactor * normal);
}

/// Gives every triangle vertices of its own, with its own normal (glTF 2.0, 3.7.2.1).
template<class T>
void takeApart(std::vector<T>& of, const std::vector<uint32_t>& corners) {
    std::vector<T> apart(corners.size());
    for (size_t i = 0; i < corners.size(); ++i) apart[i] = of[corners[i]];
    of = std::move(apart);
}

void makeFlat(std::vector<MeshVertex>& vertices) {
    for (size_t i = 0; i < vertices.size(); i += 3) {
        const glm::dvec3 a(vertices[i].position), b(vertices[i + 1].position), c(vertices[i + 2].position);
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double length = glm::length(n);
        for (size_t k = 0; k < 3; ++k)
            vertices[i + k].normal = length > 0 ? glm::vec3(n / length) : glm::vec3(0, 1, 0);
    }
}

} // namespace

float Primitives::Attribute::at(size_t vertex, size_t c) const {
    float value = base.component(vertex, c);
    for (const auto& [target, weight] : added) value += weight * target.component(vertex, c);
    return value;
}

/// One primitive, before it stands anywhere.
struct Primitives::Source {
    Attribute position, normal, color;
    std::vector<Attribute> uvs; ///< by set
    std::vector<Influences> influences;
    std::vector<uint32_t> corners; ///< of `used`
    std::vector<uint32_t> used;    ///< vertices that a triangle has
    uint32_t material = 0;
    const UvMappings* mappings = nullptr;

    /// What is read for each, wherever it stands.
    size_t perVertex() const {
        size_t count = 1 + 4 * influences.size();
        for (const Attribute* const attribute : {&position, &normal, &color})
            count += attribute->added.size();
        for (const Attribute& attribute : uvs) count += attribute.added.size();
        return count;
    }
};

bool Primitives::add(const Json& primitive, const std::string& where, const Stand& stand, Error& error) {
    size_t mode = triangles;
    if (!buffers_.spend(limits::gltfPrimitiveWork, where, error) ||
        !readCount(primitive, "mode", where, mode, error))
        return false;
    if (mode > triangleFan) {
        error.text = where + ".mode is " + std::to_string(mode) + ", expected 0 to 6";
        return false;
    }
    if (mode < triangles) {
        notes_.add(where, mode == points ? "its points are left out" : "its lines are left out");
        return true;
    }
    Source source;
    if (!readSource(primitive, where, stand, source, error)) return false;
    const size_t places = stand.joints.empty() ? stand.places.size() : 1;
    for (size_t i = 0; i < places; ++i)
        if (!place(source, where, stand, i, error)) return false;
    return true;
}

bool Primitives::readSource(const Json& primitive, const std::string& where, const Stand& stand, Source& out,
                            Error& error) {
    std::optional<size_t> material;
    constexpr const char* draco = "KHR_draco_mesh_compression";
    notes_.addExtensions(where, primitive, {draco});
    if (!readIndex(primitive, "material", document_.count("materials"), where, material, error) ||
        !materials_.use(material, out.material, error))
        return false;
    out.mappings = &materials_.mappings(out.material);
    std::optional<size_t> position;
    const Json& attributes = member(primitive, "attributes");
    const size_t accessors = document_.count("accessors");
    if (!readIndex(attributes, "POSITION", accessors, where, position, error)) return false;
    if (!position) {
        error.text = where + " has no positions";
        return false;
    }
    if (!extension(primitive, draco).is_null() &&
        member(document_.at("accessors", *position), "bufferView").is_null()) {
        error.text = where + " is compressed by " + draco + ", which is not read";
        return false;
    }
    if (!readAttribute(primitive, "POSITION", 3, where, stand, 0, out.position, error)) return false;
    const size_t count = out.position.base.count;
    if (count > limits::gltfVertices.most) {
        error.text = where + " has over 16 million vertices";
        return false;
    }
    if (!readAttribute(primitive, "NORMAL", 3, where, stand, count, out.normal, error) ||
        !readAttribute(primitive, "COLOR_0", 3, where, stand, count, out.color, error))
        return false;
    // Integers of colours are shares of 1, whether the file says so or not.
    out.color.base.normalized = true;
    return readUvs(primitive, where, stand, out, error) &&
           readInfluences(primitive, where, stand, out, error) && readCorners(primitive, where, out, error);
}

bool Primitives::readAttribute(const Json& primitive, const std::string& name, size_t least,
                               const std::string& where, const Stand& stand, size_t count, Attribute& out,
                               Error& error) {
    const size_t accessors = document_.count("accessors");
    const std::string what = where + "." + name;
    const auto read = [&](const Json& attributes, Elements& elements) {
        std::optional<size_t> accessor;
        if (!readIndex(attributes, name.c_str(), accessors, where, accessor, error)) return false;
        if (!accessor) return true;
        if (!buffers_.elements(*accessor, what, elements, error)) return false;
        if (elements.components >= least && (count == 0 || elements.count == count)) return true;
        error.text = what + " has the wrong type or count";
        return false;
    };
    if (!read(member(primitive, "attributes"), out.base)) return false;
    if (!out.present()) return true;
    const size_t whole = out.base.count;
    const Json& targets = member(primitive, "targets");
    for (size_t i = 0; i < stand.weights.size() && targets.is_array() && i < targets.size(); ++i) {
        Elements target;
        if (stand.weights[i] == 0) continue;
        if (!read(targets[i], target)) return false;
        if (target.count != 0 && target.count != whole) {
            error.text = what + " has a morph target of another count";
            return false;
        }
        if (target.count != 0) out.added.emplace_back(target, static_cast<float>(stand.weights[i]));
    }
    return true;
}

bool Primitives::readUvs(const Json& primitive, const std::string& where, const Stand& stand, Source& out,
                         Error& error) {
    const MeshMaterial& material = mesh_.materials[out.material];
    for (size_t slot = 0; slot < textureSlots; ++slot) {
        const size_t set = (*out.mappings)[slot].set;
        const bool used = material.textures[slot].has_value();
        if (set >= maxUvSets) {
            error.text = where + ": TEXCOORD_" + std::to_string(set) + " is asked for, expected 0 to 15";
            return false;
        }
        if (out.uvs.size() <= set) out.uvs.resize(set + 1);
        if (out.uvs[set].present()) continue;
        const std::string name = "TEXCOORD_" + std::to_string(set);
        if (!readAttribute(primitive, name, 2, where, stand, out.position.base.count, out.uvs[set], error))
            return false;
        if (used && !out.uvs[set].present())
            notes_.add(where, "has a texture but no " + name + " for it: that is taken as 0");
    }
    return true;
}

bool Primitives::readInfluences(const Json& primitive, const std::string& where, const Stand& stand,
                                Source& out, Error& error) {
    if (stand.joints.empty()) return true;
    const size_t count = out.position.base.count;
    for (size_t i = 0;; ++i) {
        const std::string number = std::to_string(i);
        Attribute joints, weights;
        if (!readAttribute(primitive, "JOINTS_" + number, 4, where, {}, count, joints, error) ||
            !readAttribute(primitive, "WEIGHTS_" + number, 4, where, {}, count, weights, error))
            return false;
        if (!joints.present() || !weights.present()) return true;
        if (!joints.base.isWhole()) {
            error.text = where + ".JOINTS_" + number + " has the wrong type";
            return false;
        }
        out.influences.push_back({joints.base, weights.base});
    }
}

bool Primitives::readCorners(const Json& primitive, const std::string& where, Source& out, Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = where + what;
        return false;
    };
    std::optional<size_t> accessor;
    size_t mode = triangles;
    if (!readIndex(primitive, "indices", document_.count("accessors"), where, accessor, error) ||
        !readCount(primitive, "mode", where, mode, error))
        return false;
    const size_t vertices = out.position.base.count;
    if (!accessor) {
        out.corners.resize(vertices);
        for (size_t i = 0; i < vertices; ++i) out.corners[i] = static_cast<uint32_t>(i);
    } else {
        Elements indices;
        if (!buffers_.elements(*accessor, where + ".indices", indices, error)) return false;
        if (!indices.isWhole() || indices.components != 1)
            return fail(".indices have the wrong type, expected unsigned scalars");
        if (indices.count > 3 * limits::gltfVertices.most) return fail(".indices are over 48 million");
        out.corners.resize(indices.count);
        for (size_t i = 0; i < indices.count; ++i) {
            out.corners[i] = indices.whole(i, 0);
            if (out.corners[i] >= vertices)
                return fail(".indices[" + std::to_string(i) + "] is " + std::to_string(out.corners[i]) +
                            ", but there are " + std::to_string(vertices) + " vertices");
        }
    }
    if (mode != triangles) out.corners = asTriangles(out.corners, mode);
    if (out.corners.empty() || out.corners.size() % 3 != 0)
        return fail(" has " + std::to_string(out.corners.size()) + " corners, expected a multiple of 3");

    // Many primitives may share one file's vertices: only those with a triangle are taken.
    std::vector<uint32_t> place(vertices, 0);
    for (const uint32_t corner : out.corners) place[corner] = 1;
    for (size_t i = 0; i < vertices; ++i) {
        if (place[i] == 0) continue;
        place[i] = static_cast<uint32_t>(out.used.size());
        out.used.push_back(static_cast<uint32_t>(i));
    }
    for (uint32_t& corner : out.corners) corner = place[corner];
    return true;
}

/// From the mesh to the scene, of one of its places: with a skin, by the joints that a vertex hangs on.
bool Primitives::worldOf(const Source& source, const std::string& where, const Stand& stand, size_t which,
                         size_t vertex, glm::dmat4& out, Error& error) const {
    out = which < stand.places.size() ? stand.places[which] : glm::dmat4(1);
    if (source.influences.empty()) return true;
    out = glm::dmat4(0);
    double whole = 0;
    for (const auto& [joints, weights] : source.influences)
        for (size_t c = 0; c < 4; ++c) {
            const double weight = double{weights.component(vertex, c)};
            if (!(weight > 0)) continue;
            const size_t joint = joints.whole(vertex, c);
            if (joint >= stand.joints.size()) {
                error.text = where + ": vertex " + std::to_string(vertex) + " hangs on joint " +
                             std::to_string(joint) + " of " + std::to_string(stand.joints.size());
                return false;
            }
            out += weight * stand.joints[joint];
            whole += weight;
        }
    out = whole > 0 ? out / whole : stand.joints.front();
    return true;
}

/// `mirrored`: by the first vertex's transform.
bool Primitives::readVertices(const Source& source, const std::string& where, const Stand& stand,
                              size_t which, Vertices& out, bool& mirrored, Error& error) const {
    const bool others = mesh_.materials[source.material].otherUvs;
    out.vertices.resize(source.used.size());
    if (others) out.otherUvs.resize(source.used.size());
    for (size_t i = 0; i < source.used.size(); ++i) {
        const size_t vertex = source.used[i];
        glm::dmat4 world(1);
        if (!worldOf(source, where, stand, which, vertex, world, error)) return false;
        if (i == 0) mirrored = glm::determinant(glm::dmat3(world)) < 0;
        std::string problem;
        bool read = readVertex(source, vertex, world, out.vertices[i], problem) &&
                    readUv(source, vertex, baseSlot, out.vertices[i].uv);
        for (uint32_t slot = 1; read && others && slot < textureSlots; ++slot)
            read = readUv(source, vertex, static_cast<TextureSlot>(slot), out.otherUvs[i][slot - 1]);
        if (read) continue;
        if (problem.empty()) problem = "has a texture coordinate that is not finite or over 1e6";
        error.text = where + ": vertex " + std::to_string(vertex) + " " + problem;
        return false;
    }
    return true;
}

bool Primitives::place(const Source& source, const std::string& where, const Stand& stand, size_t which,
                       Error& error) {
    const bool flat = !source.normal.present();
    const size_t made = flat ? source.corners.size() : source.used.size();
    const uint64_t allowed = buffers_.allowed(limits::gltfVertices);
    if (mesh_.vertices.size() + made > allowed || cornerCount_ + source.corners.size() > 3 * allowed) {
        error.text = where + " brings the scene over " + std::to_string(allowed) +
                     " vertices, or three times as many corners: the most for so many bytes";
        return false;
    }
    if (!buffers_.spend(source.used.size() * source.perVertex(), where, error)) return false;
    Vertices vertices;
    bool mirrored = false;
    if (!readVertices(source, where, stand, which, vertices, mirrored, error)) return false;
    std::vector<uint32_t> corners = source.corners;
    if (mirrored) // its triangles are wound the other way round
        for (size_t i = 0; i < corners.size(); i += 3) std::swap(corners[i + 1], corners[i + 2]);
    if (flat) {
        takeApart(vertices.vertices, corners);
        if (!vertices.otherUvs.empty()) takeApart(vertices.otherUvs, corners);
        makeFlat(vertices.vertices);
        for (size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<uint32_t>(i);
    }
    append(source, std::move(vertices), std::move(corners));
    return true;
}

bool Primitives::readVertex(const Source& source, size_t vertex, const glm::dmat4& world, MeshVertex& out,
                            std::string& problem) const {
    const auto vec3 = [&](const Attribute& attribute) {
        return glm::dvec3(attribute.at(vertex, 0), attribute.at(vertex, 1), attribute.at(vertex, 2));
    };
    const glm::dvec3 p = glm::dvec3(world * glm::dvec4(vec3(source.position), 1));
    for (int c = 0; c < 3; ++c)
        if (!(std::abs(p[c]) <= maxCoordinate)) {
            problem = "is not finite or over 1e7 m away";
            return false;
        }
    out.position = glm::vec3(p);
    out.normal = glm::vec3(0, 1, 0);
    if (source.normal.present()) {
        const glm::dvec3 n = normalThrough(glm::dmat3(world), vec3(source.normal));
        const double length = glm::length(n);
        if (!std::isfinite(length)) {
            problem = "has a normal that is not finite";
            return false;
        }
        if (length > 0) out.normal = glm::vec3(n / length);
    }
    for (size_t c = 0; c < 4; ++c) {
        const bool has = source.color.present() && c < source.color.base.components;
        const float value = has ? source.color.at(vertex, c) : 1.0f;
        out.color[c] = static_cast<uint16_t>(
            std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) * 65535.0f + 0.5f : 0.0f);
    }
    return true;
}

bool Primitives::readUv(const Source& source, size_t vertex, TextureSlot slot, glm::vec2& out) const {
    const UvMapping& mapping = (*source.mappings)[slot];
    const Attribute& attribute = source.uvs[mapping.set];
    out = glm::vec2(0);
    if (!attribute.present()) return true;
    const glm::dvec2 uv(attribute.at(vertex, 0), attribute.at(vertex, 1));
    out = mapping == UvMapping{} ? glm::vec2(uv) : glm::vec2(mapping.turn * uv + mapping.offset);
    return std::abs(out.x) <= 1e6f && std::abs(out.y) <= 1e6f;
}

void Primitives::append(const Source& source, Vertices&& made, std::vector<uint32_t>&& corners) {
    cornerCount_ += corners.size();
    const size_t material = source.material, first = mesh_.vertices.size();
    for (const MeshVertex& vertex : made.vertices)
        if (vertex.color[3] < 65535) clear_[material] = true;
    if (!made.otherUvs.empty()) mesh_.otherUvs.resize(first);
    mesh_.vertices.insert(mesh_.vertices.end(), made.vertices.begin(), made.vertices.end());
    mesh_.otherUvs.insert(mesh_.otherUvs.end(), made.otherUvs.begin(), made.otherUvs.end());
    std::vector<uint32_t>& list = corners_[material];
    for (const uint32_t corner : corners) list.push_back(static_cast<uint32_t>(first) + corner);
}

} // namespace demos::gltf
