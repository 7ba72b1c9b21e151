#include "host/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <map>
#include <span>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <tiny_gltf.h>

namespace demos {
namespace {

constexpr uintmax_t maxFileBytes = uintmax_t(1) << 30;
constexpr size_t maxVertices = 16'000'000;
constexpr size_t maxIndices = 48'000'000;
constexpr size_t maxTexturePixels = size_t(1) << 27;
constexpr int maxTextureSide = 8192;
constexpr size_t maxTextures = 256;
constexpr size_t maxMaterials = 1024;
constexpr double maxCoordinate = 1e7;
constexpr size_t maxPartTriangles = 2048;

// What tinygltf asks the host for: files and images. Its own readers have no caps, and its path expansion is
// not wanted.

bool readWholeFile(std::vector<unsigned char>* out, std::string* error, const std::string& path, void*) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed) ||
        std::filesystem::file_size(path, failed) > maxFileBytes) {
        if (error) *error += path + " is no file of at most 1 GiB\n";
        return false;
    }
    return tinygltf::ReadWholeFile(out, error, path, nullptr);
}

bool fileExists(const std::string& path, void*) {
    std::error_code failed;
    return std::filesystem::is_regular_file(path, failed);
}

std::string samePath(const std::string& path, void*) {
    return path;
}

bool decodeImage(tinygltf::Image* image, int index, std::string* error, std::string*, int, int,
                 const unsigned char* bytes, int size, void* pixelsSoFar) {
    const auto fail = [&](const std::string& what) {
        if (error) *error += "images[" + std::to_string(index) + "]: " + what + "\n";
        return false;
    };
    OIIO::Filesystem::IOMemReader memory(const_cast<unsigned char*>(bytes),
                                         static_cast<size_t>(std::max(size, 0)));
    const bool png = size > 1 && bytes[0] == 0x89 && bytes[1] == 'P';
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::Filesystem::IOProxy* proxy = &memory;
    hints.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto input = OIIO::ImageInput::open(png ? "memory.png" : "memory.jpg", &hints);
    if (!input) return fail(OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > maxTextureSide || spec.height > maxTextureSide)
        return fail("is " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                    ", expected 1 to 8192");
    auto& pixels = *static_cast<size_t*>(pixelsSoFar);
    pixels += size_t(spec.width) * static_cast<size_t>(spec.height);
    if (pixels > maxTexturePixels) return fail("brings the file's textures over 2^27 pixels");
    const int channels = std::min(spec.nchannels, 4);
    image->width = spec.width;
    image->height = spec.height;
    image->component = 4;
    image->bits = 8;
    image->pixel_type = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    image->image.assign(size_t(spec.width) * static_cast<size_t>(spec.height) * 4, 255);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, image->image.data(), 4))
        return fail(input->geterror());
    if (channels <= 2)
        for (size_t i = 0; i < image->image.size(); i += 4) {
            unsigned char* const p = &image->image[i];
            if (channels == 2) p[3] = p[1];
            p[1] = p[2] = p[0];
        }
    return true;
}

std::string firstLine(const std::string& text) {
    const size_t start = text.find_first_not_of("\n");
    if (start == std::string::npos) return "is not a readable glTF file";
    // Capped, since it may quote the file.
    return text.substr(start, std::min(text.find('\n', start) - start, size_t(200)));
}

/// An accessor whose every element lies inside its buffer.
struct Elements {
    const unsigned char* data = nullptr;
    size_t count = 0, stride = 0;
    int componentType = 0, components = 0;
    bool normalized = false;
};

float component(const Elements& e, size_t index, int c) {
    const unsigned char* const at = e.data + index * e.stride;
    const auto read = [&](auto value) {
        std::memcpy(&value, at + static_cast<size_t>(c) * sizeof(value), sizeof(value));
        return value;
    };
    switch (e.componentType) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return read(float());
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return static_cast<float>(read(uint8_t())) / (e.normalized ? 255.0f : 1.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return static_cast<float>(read(uint16_t())) / (e.normalized ? 65535.0f : 1.0f);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return e.normalized ? std::max(-1.0f, static_cast<float>(read(int8_t())) / 127.0f)
                            : static_cast<float>(read(int8_t()));
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return e.normalized ? std::max(-1.0f, static_cast<float>(read(int16_t())) / 32767.0f)
                            : static_cast<float>(read(int16_t()));
    default:
        return static_cast<float>(read(uint32_t()));
    }
}

uint32_t indexAt(const Elements& e, size_t i) {
    const unsigned char* const at = e.data + i * e.stride;
    uint32_t value = 0;
    if (e.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *at;
    if (e.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
        uint16_t half = 0;
        std::memcpy(&half, at, sizeof(half));
        return half;
    }
    std::memcpy(&value, at, sizeof(value));
    return value;
}

bool inRange(int index, size_t size) {
    return index >= 0 && static_cast<size_t>(index) < size;
}

/// One model being turned into a Mesh. Every function returns false with `problem` set.
class Reader {
  public:
    explicit Reader(const tinygltf::Model& model) : model_(model) {}

    bool read() { return checkExtensions() && readMaterials() && readScene() && collectParts(); }
    Mesh mesh;
    std::string problem;

  private:
    bool fail(const std::string& what) {
        problem = what;
        return false;
    }

    bool checkExtensions() {
        for (const std::string& extension : model_.extensionsRequired)
            return fail("requires the extension " + extension + ", which is not supported");
        return true;
    }

    bool readTexture(int index, bool srgb, const std::string& where, std::optional<uint32_t>& out) {
        if (index < 0) return true;
        if (!inRange(index, model_.textures.size())) return fail(where + " is out of range");
        const auto [known, fresh] =
            textures_.try_emplace({index, srgb}, static_cast<uint32_t>(mesh.textures.size()));
        out = known->second;
        if (!fresh) return true;
        const tinygltf::Texture& texture = model_.textures[static_cast<size_t>(index)];
        if (!inRange(texture.source, model_.images.size()))
            return fail(where + ": its image is out of range");
        const tinygltf::Image& image = model_.images[static_cast<size_t>(texture.source)];
        MeshTexture made;
        made.width = static_cast<uint32_t>(std::max(image.width, 0));
        made.height = static_cast<uint32_t>(std::max(image.height, 0));
        if (image.image.empty() || image.image.size() != size_t(made.width) * made.height * 4)
            return fail(where + ": its image has no pixels");
        texturePixels_ += size_t(made.width) * made.height;
        if (texturePixels_ > maxTexturePixels || mesh.textures.size() >= maxTextures)
            return fail("has over 256 textures or over 2^27 pixels of them");
        made.rgba = image.image;
        made.srgb = srgb;
        if (inRange(texture.sampler, model_.samplers.size())) {
            const tinygltf::Sampler& sampler = model_.samplers[static_cast<size_t>(texture.sampler)];
            const auto wrap = [](int mode) {
                return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Wrap::clamp
                       : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror
                                                                       : Wrap::repeat;
            };
            made.wrapU = wrap(sampler.wrapS);
            made.wrapV = wrap(sampler.wrapT);
        }
        mesh.textures.push_back(std::move(made));
        return true;
    }

    bool readMaterial(const tinygltf::Material& source, const std::string& where) {
        MeshMaterial material;
        const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
        const auto factor = [](double value) {
            return std::isfinite(value) ? static_cast<float>(std::clamp(value, 0.0, 1.0)) : 1.0f;
        };
        for (size_t i = 0; i < 4 && i < pbr.baseColorFactor.size(); ++i)
            material.baseColor[static_cast<int>(i)] = factor(pbr.baseColorFactor[i]);
        for (size_t i = 0; i < 3 && i < source.emissiveFactor.size(); ++i)
            material.emissive[static_cast<int>(i)] = factor(source.emissiveFactor[i]);
        material.metallic = factor(pbr.metallicFactor);
        material.roughness = factor(pbr.roughnessFactor);
        material.doubleSided = source.doubleSided;
        if (source.alphaMode == "MASK") material.alphaCutoff = std::max(1e-3f, factor(source.alphaCutoff));
        if (source.alphaMode == "BLEND") material.alphaCutoff = 0.5f;
        const bool read = readTexture(pbr.baseColorTexture.index, true, where + ".baseColorTexture",
                                      material.baseTexture) &&
                          readTexture(pbr.metallicRoughnessTexture.index, false,
                                      where + ".metallicRoughnessTexture", material.metallicRoughnessTexture);
        mesh.materials.push_back(material);
        return read;
    }

    bool readMaterials() {
        if (model_.materials.size() > maxMaterials) return fail("has over 1024 materials");
        for (size_t i = 0; i < model_.materials.size(); ++i)
            if (!readMaterial(model_.materials[i], "materials[" + std::to_string(i) + "]")) return false;
        mesh.materials.emplace_back(); // for primitives without one
        byMaterial_.resize(mesh.materials.size());
        return true;
    }

    /// Walks the nodes without recursion, so that no file can overflow the stack, and each once, so that a
    /// cycle ends.
    bool readScene() {
        struct Visit {
            int node;
            glm::dmat4 parent;
        };
        std::vector<Visit> stack;
        if (model_.scenes.empty()) {
            std::vector<bool> isChild(model_.nodes.size(), false);
            for (const tinygltf::Node& node : model_.nodes)
                for (const int child : node.children)
                    if (inRange(child, isChild.size())) isChild[static_cast<size_t>(child)] = true;
            for (size_t i = 0; i < model_.nodes.size(); ++i)
                if (!isChild[i]) stack.push_back({static_cast<int>(i), glm::dmat4(1)});
        } else {
            const int scene = std::max(model_.defaultScene, 0);
            if (!inRange(scene, model_.scenes.size())) return fail("scene is out of range");
            for (const int node : model_.scenes[static_cast<size_t>(scene)].nodes)
                stack.push_back({node, glm::dmat4(1)});
        }
        std::vector<bool> visited(model_.nodes.size(), false);
        while (!stack.empty()) {
            const Visit visit = stack.back();
            stack.pop_back();
            const std::string where = "nodes[" + std::to_string(visit.node) + "]";
            if (!inRange(visit.node, model_.nodes.size())) return fail(where + " is out of range");
            if (visited[static_cast<size_t>(visit.node)])
                return fail(where + " is reached twice, expected a tree");
            visited[static_cast<size_t>(visit.node)] = true;
            const tinygltf::Node& node = model_.nodes[static_cast<size_t>(visit.node)];
            const glm::dmat4 world = visit.parent * localMatrix(node);
            for (int i = 0; i < 16; ++i)
                if (!std::isfinite(glm::value_ptr(world)[i]))
                    return fail(where + " has a transform that is not finite");
            if (node.mesh >= 0 && !readMeshOfNode(node.mesh, world, where)) return false;
            for (const int child : node.children) stack.push_back({child, world});
        }
        return true;
    }

    static glm::dmat4 localMatrix(const tinygltf::Node& node) {
        if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
        glm::dmat4 matrix(1);
        if (node.translation.size() == 3)
            matrix = glm::translate(matrix, glm::make_vec3(node.translation.data()));
        if (node.rotation.size() == 4)
            matrix *= glm::mat4_cast(
                glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
        if (node.scale.size() == 3) matrix = glm::scale(matrix, glm::make_vec3(node.scale.data()));
        return matrix;
    }

    bool readMeshOfNode(int index, const glm::dmat4& world, const std::string& where) {
        if (!inRange(index, model_.meshes.size())) return fail(where + ".mesh is out of range");
        const tinygltf::Mesh& source = model_.meshes[static_cast<size_t>(index)];
        for (size_t i = 0; i < source.primitives.size(); ++i)
            if (!readPrimitive(source.primitives[i], world,
                               "meshes[" + std::to_string(index) + "].primitives[" + std::to_string(i) + "]"))
                return false;
        return true;
    }

    bool elements(int index, const std::string& where, Elements& out) {
        if (!inRange(index, model_.accessors.size())) return fail(where + ": accessor is out of range");
        const tinygltf::Accessor& accessor = model_.accessors[static_cast<size_t>(index)];
        if (accessor.sparse.isSparse) return fail(where + ": sparse accessors are not supported");
        if (!inRange(accessor.bufferView, model_.bufferViews.size()))
            return fail(where + ": bufferView is out of range");
        const tinygltf::BufferView& view = model_.bufferViews[static_cast<size_t>(accessor.bufferView)];
        if (!inRange(view.buffer, model_.buffers.size())) return fail(where + ": buffer is out of range");
        const size_t bytes = model_.buffers[static_cast<size_t>(view.buffer)].data.size();
        const int componentBytes =
            tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType));
        out.components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
        if (componentBytes <= 0 || componentBytes > 4 || out.components <= 0)
            return fail(where + ": unknown component type");
        const size_t element = static_cast<size_t>(componentBytes) * static_cast<size_t>(out.components);
        const size_t stride = view.byteStride == 0 ? element : view.byteStride;
        const bool viewFits = view.byteOffset <= bytes && view.byteLength <= bytes - view.byteOffset;
        // Divisions, so that hostile sizes cannot wrap around.
        const bool fits = viewFits && stride >= element && accessor.count > 0 &&
                          accessor.byteOffset <= view.byteLength &&
                          element <= view.byteLength - accessor.byteOffset &&
                          accessor.count - 1 <= (view.byteLength - accessor.byteOffset - element) / stride;
        if (!fits) return fail(where + ": is empty or reaches past its buffer");
        out.data = model_.buffers[static_cast<size_t>(view.buffer)].data.data() + view.byteOffset +
                   accessor.byteOffset;
        out.count = accessor.count;
        out.stride = stride;
        out.componentType = accessor.componentType;
        out.normalized = accessor.normalized;
        return true;
    }

    /// Absent is fine and leaves out.count 0.
    bool attribute(const tinygltf::Primitive& primitive, const std::string& name, int minComponents,
                   size_t count, const std::string& where, Elements& out) {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return true;
        const std::string what = where + "." + name;
        if (!elements(found->second, what, out)) return false;
        if (out.components < minComponents || (count != 0 && out.count != count))
            return fail(what + ": has the wrong type or count");
        return true;
    }

    bool readIndices(const tinygltf::Primitive& primitive, size_t vertexCount, const std::string& where,
                     std::vector<uint32_t>& out) {
        if (primitive.indices < 0) {
            out.resize(vertexCount);
            for (size_t i = 0; i < vertexCount; ++i) out[i] = static_cast<uint32_t>(i);
        } else {
            Elements source;
            if (!elements(primitive.indices, where + ".indices", source)) return false;
            const bool integer = source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                 source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                 source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
            if (!integer || source.components != 1)
                return fail(where + ".indices: expected unsigned scalars");
            if (source.count > maxIndices) return fail(where + ".indices: over 48 million");
            out.resize(source.count);
            for (size_t i = 0; i < source.count; ++i) {
                out[i] = indexAt(source, i);
                if (out[i] >= vertexCount)
                    return fail(where + ".indices[" + std::to_string(i) + "] is " + std::to_string(out[i]) +
                                ", but there are " + std::to_string(vertexCount) + " vertices");
            }
        }
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES) out = asTriangles(out, primitive.mode);
        if (out.empty() || out.size() % 3 != 0)
            return fail(where + ": has " + std::to_string(out.size()) + " corners, expected a multiple of 3");
        return true;
    }

    static std::vector<uint32_t> asTriangles(const std::vector<uint32_t>& corners, int mode) {
        std::vector<uint32_t> triangles;
        for (size_t i = 2; i < corners.size(); ++i) {
            const bool odd = i % 2 == 1;
            if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
                triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
            else
                triangles.insert(triangles.end(),
                                 {corners[odd ? i - 1 : i - 2], corners[odd ? i - 2 : i - 1], corners[i]});
        }
        return triangles;
    }

    bool readPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& world,
                       const std::string& where) {
        const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
        if (mode > TINYGLTF_MODE_TRIANGLE_FAN) return fail(where + ": unknown mode");
        if (mode < TINYGLTF_MODE_TRIANGLES) return true; // points and lines
        if (primitive.material >= 0 && !inRange(primitive.material, model_.materials.size()))
            return fail(where + ".material is out of range");
        Elements position, normal, uv, color;
        if (!attribute(primitive, "POSITION", 3, 0, where, position)) return false;
        if (position.count == 0) return fail(where + ": has no positions");
        if (position.count > maxVertices) return fail(where + ": over 16 million vertices");
        if (!attribute(primitive, "NORMAL", 3, position.count, where, normal) ||
            !attribute(primitive, "TEXCOORD_0", 2, position.count, where, uv) ||
            !attribute(primitive, "COLOR_0", 3, position.count, where, color))
            return false;
        std::vector<MeshVertex> vertices(position.count);
        for (size_t i = 0; i < vertices.size(); ++i)
            if (!readVertex(position, normal, uv, color, i, world, vertices[i]))
                return fail(where + ": vertex " + std::to_string(i) + " " + problem);
        std::vector<uint32_t> indices;
        tinygltf::Primitive triangles = primitive;
        triangles.mode = mode;
        if (!readIndices(triangles, vertices.size(), where, indices)) return false;
        // A mirroring transform turns triangles inside out.
        if (glm::determinant(glm::dmat3(world)) < 0)
            for (size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
        if (normal.count == 0) makeFlat(vertices, indices);
        return append(vertices, indices,
                      primitive.material < 0 ? mesh.materials.size() - 1
                                             : static_cast<size_t>(primitive.material));
    }

    bool readVertex(const Elements& position, const Elements& normal, const Elements& uv,
                    const Elements& color, size_t i, const glm::dmat4& world, MeshVertex& out) {
        const auto vec3 = [&](const Elements& e) {
            return glm::dvec3(component(e, i, 0), component(e, i, 1), component(e, i, 2));
        };
        const glm::dvec3 p = glm::dvec3(world * glm::dvec4(vec3(position), 1));
        for (int c = 0; c < 3; ++c)
            if (!(std::abs(p[c]) <= maxCoordinate)) return fail("is not finite or over 1e7 m away");
        out.position = glm::vec3(p);
        out.normal = glm::vec3(0, 1, 0);
        if (normal.count > 0) {
            // Cofactors carry normals through any linear map, a singular one included.
            const glm::dmat3 m(world);
            const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
            const double sign = glm::determinant(m) < 0 ? -1 : 1;
            const glm::dvec3 n = sign * (cofactor * vec3(normal));
            const double length = glm::length(n);
            if (!std::isfinite(length)) return fail("has a normal that is not finite");
            if (length > 0) out.normal = glm::vec3(n / length);
        }
        out.uv = uv.count == 0 ? glm::vec2(0) : glm::vec2(component(uv, i, 0), component(uv, i, 1));
        if (!(std::abs(out.uv.x) <= 1e6f && std::abs(out.uv.y) <= 1e6f))
            return fail("has a texture coordinate that is not finite or over 1e6");
        for (int c = 0; c < 4; ++c) {
            const float value = c < color.components ? component(color, i, c) : 1.0f;
            out.color[c] = static_cast<uint16_t>(
                std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) * 65535.0f + 0.5f : 0.0f);
        }
        return true;
    }

    /// Gives every triangle vertices of its own, with its own normal (glTF 2.0, 3.7.2.1).
    static void makeFlat(std::vector<MeshVertex>& vertices, std::vector<uint32_t>& indices) {
        std::vector<MeshVertex> apart(indices.size());
        for (size_t i = 0; i < indices.size(); i += 3) {
            for (size_t c = 0; c < 3; ++c) apart[i + c] = vertices[indices[i + c]];
            const glm::dvec3 a(apart[i].position), b(apart[i + 1].position), c(apart[i + 2].position);
            const glm::dvec3 n = glm::cross(b - a, c - a);
            const double length = glm::length(n);
            for (size_t k = 0; k < 3; ++k)
                apart[i + k].normal = length > 0 ? glm::vec3(n / length) : glm::vec3(0, 1, 0);
        }
        vertices = std::move(apart);
        for (size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<uint32_t>(i);
    }

    bool append(const std::vector<MeshVertex>& vertices, const std::vector<uint32_t>& indices,
                size_t material) {
        indexCount_ += indices.size();
        if (mesh.vertices.size() + vertices.size() > maxVertices || indexCount_ > maxIndices)
            return fail("has over 16 million vertices or 48 million indices");
        const auto base = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
        std::vector<uint32_t>& list = byMaterial_[material];
        for (const uint32_t index : indices) list.push_back(base + index);
        return true;
    }

    using Triangle = std::array<uint32_t, 3>;

    /// Halves the triangles along their longest side until a part is small enough to be culled with profit.
    void addParts(std::span<Triangle> triangles, uint32_t material) {
        if (triangles.empty()) return;
        MeshPart part;
        part.low = part.high = mesh.vertices[triangles.front()[0]].position;
        for (const Triangle& triangle : triangles)
            for (const uint32_t index : triangle) {
                part.low = glm::min(part.low, mesh.vertices[index].position);
                part.high = glm::max(part.high, mesh.vertices[index].position);
            }
        if (triangles.size() > maxPartTriangles) {
            const glm::vec3 size = part.high - part.low;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
            // Ties go by index, so that the order is the same with every library.
            std::nth_element(triangles.begin(), middle, triangles.end(),
                             [&](const Triangle& a, const Triangle& b) {
                                 const float pa = mesh.vertices[a[0]].position[axis],
                                             pb = mesh.vertices[b[0]].position[axis];
                                 return pa != pb ? pa < pb : a < b;
                             });
            addParts({triangles.begin(), middle}, material);
            addParts({middle, triangles.end()}, material);
            return;
        }
        std::sort(triangles.begin(), triangles.end());
        part.firstIndex = static_cast<uint32_t>(mesh.indices.size());
        part.indexCount = static_cast<uint32_t>(triangles.size() * 3);
        part.material = material;
        for (const Triangle& triangle : triangles)
            mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
        mesh.parts.push_back(part);
    }

    bool collectParts() {
        for (size_t material = 0; material < byMaterial_.size(); ++material) {
            std::vector<Triangle> triangles;
            const std::vector<uint32_t>& list = byMaterial_[material];
            for (size_t i = 0; i + 2 < list.size(); i += 3)
                triangles.push_back({list[i], list[i + 1], list[i + 2]});
            addParts(triangles, static_cast<uint32_t>(material));
        }
        if (mesh.parts.empty()) return fail("has no triangles");
        mesh.low = mesh.high = mesh.vertices.front().position;
        for (const MeshVertex& vertex : mesh.vertices) {
            mesh.low = glm::min(mesh.low, vertex.position);
            mesh.high = glm::max(mesh.high, vertex.position);
        }
        return true;
    }

    const tinygltf::Model& model_;
    std::map<std::pair<int, bool>, uint32_t> textures_;
    std::vector<std::vector<uint32_t>> byMaterial_;
    size_t texturePixels_ = 0, indexCount_ = 0;
};

bool loadModel(const std::filesystem::path& file, tinygltf::Model& model, std::string& problem) {
    tinygltf::TinyGLTF loader;
    size_t pixels = 0;
    loader.SetImageLoader(decodeImage, &pixels);
    loader.SetFsCallbacks({fileExists, samePath, readWholeFile, tinygltf::WriteWholeFile, nullptr});
    std::string errors, warnings;
    bool loaded = false;
    try {
        std::string extension = file.extension().string();
        std::transform(extension.begin(), extension.end(), extension.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        loaded = extension == ".glb" ? loader.LoadBinaryFromFile(&model, &errors, &warnings, file.string())
                                     : loader.LoadASCIIFromFile(&model, &errors, &warnings, file.string());
    } catch (const std::exception& thrown) { // the JSON library inside throws
        errors = thrown.what();
        loaded = false;
    }
    if (!loaded) problem = firstLine(errors);
    return loaded;
}

} // namespace

std::optional<Mesh> readMesh(const std::filesystem::path& file, Error& error) {
    std::error_code ignored;
    std::string problem;
    if (!std::filesystem::is_regular_file(file, ignored)) {
        error.text = file.string() + ": no such file";
        return std::nullopt;
    }
    tinygltf::Model model;
    if (!loadModel(file, model, problem)) {
        error.text = file.string() + ": " + problem;
        return std::nullopt;
    }
    Reader reader(model);
    if (!reader.read()) {
        error.text = file.string() + ": " + reader.problem;
        return std::nullopt;
    }
    return std::move(reader.mesh);
}

} // namespace demos
