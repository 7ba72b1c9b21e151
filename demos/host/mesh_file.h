// glTF files as triangles. The node hierarchy is baked into the vertices, which stay in the file's own frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace demos {

struct MeshVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 uv;
    uint16_t color[4]; ///< linear, unorm
};

enum class Wrap : uint8_t { repeat, mirror, clamp };

struct MeshTexture {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba;
    bool srgb = false;
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
};

struct MeshMaterial {
    glm::vec4 baseColor{1};
    glm::vec3 emissive{0};
    float metallic = 1, roughness = 1;
    float alphaCutoff = 0; ///< 0: opaque
    bool doubleSided = false;
    std::optional<uint32_t> baseTexture, metallicRoughnessTexture;
};

/// Triangles of one material that lie near each other.
struct MeshPart {
    uint32_t firstIndex = 0, indexCount = 0, material = 0;
    glm::vec3 low{0}, high{0};
};

struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<uint32_t> indices;
    std::vector<MeshPart> parts;
    std::vector<MeshMaterial> materials;
    std::vector<MeshTexture> textures;
    glm::vec3 low{0}, high{0}; ///< bounds of the vertices
};

/// Reads .gltf or .glb. Untrusted: sizes are capped, every index and offset is checked, and what is wrong is
/// named. Points and lines are left out; blended materials are cut out at half their alpha.
std::optional<Mesh> readMesh(const std::filesystem::path& file, Error& error);

} // namespace demos
