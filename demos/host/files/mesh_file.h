// glTF files as triangles. The node hierarchy is baked into the vertices, which stay in the file's own frame.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "scene/surroundings.h"

namespace demos {

struct MeshVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 uv;
    uint16_t color[4]; ///< linear, unorm
};

enum class Wrap : uint8_t { repeat, mirror, clamp };
enum class Filter : uint8_t { linear, nearest };
enum class Mips : uint8_t { linear, nearest, none };

struct MeshTexture {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba;
    bool srgb = false;
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    Filter larger = Filter::linear, smaller = Filter::linear; ///< than its texels; smaller
    Mips mips = Mips::linear;
};

/// `surfaceSlot` holds metalness in blue and roughness in green, or specular colour and glossiness in alpha.
enum TextureSlot : uint32_t {
    baseSlot,
    surfaceSlot,
    emissiveSlot,
    normalSlot,
    occlusionSlot,
    textureSlots,
};

/// What of a material the shaders are specialised for, as opaque.frag numbers it.
enum MaterialFeature : uint32_t {
    maskedFeature = 1,
    ditheredFeature = 2,
    unlitFeature = 4,
    specularFeature = 8,
    emissiveMapFeature = 16,
    normalMapFeature = 32,
    occlusionMapFeature = 64,
    otherUvsFeature = 128,
};
constexpr uint32_t materialFeatures = 8;

struct MeshMaterial {
    glm::vec4 baseColor{1};
    glm::vec3 emissive{0}; ///< 1: as bright as a white surface of radiance 1
    float metallic = 1, roughness = 1;
    float alphaCutoff = 0; ///< 0: opaque
    bool blends = false;   ///< by its alpha: that share of its pixels is drawn
    bool doubleSided = false;
    bool unlit = false;                   ///< its base colour is the light that leaves it
    std::optional<glm::vec3> specular;    ///< in place of metalness; glossiness is 1 - `roughness`
    float normalScale = 1, occlusion = 1; ///< of their maps
    bool otherUvs = false;                ///< its textures lie at Mesh::otherUvs, but for the first
    std::array<std::optional<uint32_t>, textureSlots> textures;

    uint32_t features() const;
};

/// Triangles of one material that lie near each other.
struct MeshPart {
    uint32_t firstIndex = 0, indexCount = 0, material = 0;
    glm::vec3 low{0}, high{0};
};

/// Where the texture of each slot lies but for baseSlot's.
using OtherUvs = std::array<glm::vec2, textureSlots - 1>;

struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<OtherUvs> otherUvs; ///< of each vertex; none where no material asks for them
    std::vector<uint32_t> indices;
    std::vector<MeshPart> parts;
    std::vector<MeshMaterial> materials;
    std::vector<MeshTexture> textures;
    glm::vec3 low{0}, high{0}; ///< bounds of the vertices
    uint64_t fileBytes = 0;
    /// What changes the file's picture and is not drawn as it says, each in one line without the file's name.
    std::vector<std::string> leftOut;
};

/// Reads .gltf or .glb. Untrusted: sizes are capped, every index and offset is checked, and what is wrong is
/// named. Skins and morph targets are drawn at rest.
std::optional<Mesh> readMesh(const std::filesystem::path& file, Error& error);

/// What the meshes of a scene come to, each as often as it is placed.
class PlacedTriangles {
  public:
    void readFile(uint64_t bytes) { bytes_ += bytes; }
    /// False with `error` once they are too many for so many bytes.
    bool place(uint64_t triangles, const std::filesystem::path& file, Error& error);

  private:
    uint64_t bytes_ = 0, triangles_ = 0;
};

} // namespace demos
