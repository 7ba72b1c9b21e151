// Materials and their textures, read where a triangle of the scene first uses them.
#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <string>

#include "host/files/mesh_file.h"
#include "host/gltf/buffers.h"
#include "host/gltf/image.h"
#include "host/gltf/notes.h"

namespace demos::gltf {

/// Where a texture lies on a mesh: one of its UV sets, moved (KHR_texture_transform).
struct UvMapping {
    size_t set = 0;
    glm::dmat2 turn{1};
    glm::dvec2 offset{0};

    bool operator==(const UvMapping&) const = default;
};

/// Of each texture slot; without a texture, as the material's first one.
using UvMappings = std::array<UvMapping, textureSlots>;

class Materials {
  public:
    /// Gives `mesh` as many materials as the file has, and one more for what has none.
    bool create(const Document& document, Buffers& buffers, Notes& notes, Mesh& mesh, Error& error);

    /// Null: the one for what has none. `out` is an index of Mesh::materials.
    bool use(std::optional<size_t> material, uint32_t& out, Error& error);
    const UvMappings& mappings(uint32_t material) const { return mappings_[material]; }
    /// Says which blend, and draws those as opaque that turned out to be nowhere clear.
    void finish(const std::vector<bool>& clearVertices);

  private:
    struct Source;
    bool read(size_t index, Error& error);
    bool readMetallicRoughness(const Source& source, MeshMaterial& material, Error& error);
    bool readSpecularGlossiness(const Source& source, MeshMaterial& material, Error& error);
    bool readLight(const Source& source, MeshMaterial& material, Error& error);
    bool readAlpha(const Source& source, MeshMaterial& material, Error& error);
    bool readSlot(const Source& source, const Json& parent, const char* key, TextureSlot slot, bool srgb,
                  MeshMaterial& material, Error& error);
    bool readMapping(const Json& info, const std::string& where, UvMapping& out, Error& error);
    bool readTexture(size_t index, bool srgb, const std::string& where, std::optional<uint32_t>& out,
                     Error& error);
    bool decode(const Json& texture, const std::string& where, Pixels& out, size_t& from,
                std::string& problem, Error& error);
    bool readImage(size_t index, const std::string& place, Pixels& out, std::string& problem, Error& error);
    bool imageBytes(size_t index, std::span<const uint8_t>& out,
                    std::shared_ptr<const std::vector<uint8_t>>& held, std::string& problem);
    size_t readWay(size_t sampler, const char* key, std::initializer_list<size_t> known);
    void readSampler(size_t sampler, MeshTexture& out);
    void noteExtensions(const Source& source);

    const Document* document_ = nullptr;
    Buffers* buffers_ = nullptr;
    Notes* notes_ = nullptr;
    Mesh* mesh_ = nullptr;
    std::vector<bool> read_;
    std::vector<UvMappings> mappings_;
    std::map<std::pair<size_t, bool>, std::optional<uint32_t>> textures_;
    std::map<size_t, std::string> broken_; ///< images, and what is wrong with them
    std::map<size_t, uint32_t> decoded_;   ///< images, and a texture that has their pixels
    uint64_t pixels_ = 0;
};

} // namespace demos::gltf
