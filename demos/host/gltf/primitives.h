// Primitives as triangles with their vertices: morphed and skinned as at rest, in each place they stand in.
#pragma once

#include "host/gltf/materials.h"

namespace demos::gltf {

/// Where a mesh stands: in places, or where the joints of a skin have it.
struct Stand {
    std::vector<glm::dmat4> places;
    std::vector<glm::dmat4> joints; ///< from the mesh at rest to the scene; none without a skin
    std::vector<double> weights;    ///< of morph targets
};

class Primitives {
  public:
    Primitives(const Document& document, Buffers& buffers, Materials& materials, Notes& notes, Mesh& mesh)
        : document_(document), buffers_(buffers), materials_(materials), notes_(notes), mesh_(mesh),
          corners_(mesh.materials.size()), clear_(mesh.materials.size(), false) {}

    bool add(const Json& primitive, const std::string& where, const Stand& stand, Error& error);

    /// Indices of vertices, three a triangle, by material.
    const std::vector<std::vector<uint32_t>>& corners() const { return corners_; }
    /// Materials with vertices of an alpha below 1.
    const std::vector<bool>& clear() const { return clear_; }

  private:
    /// An attribute and what the morph targets that count add to it.
    struct Attribute {
        Elements base;
        std::vector<std::pair<Elements, float>> added;

        bool present() const { return base.count > 0; }
        float at(size_t vertex, size_t c) const;
    };
    struct Influences {
        Elements joints, weights;
    };
    struct Source;
    struct Vertices {
        std::vector<MeshVertex> vertices;
        std::vector<OtherUvs> otherUvs;
    };

    bool readSource(const Json& primitive, const std::string& where, const Stand& stand, Source& out,
                    Error& error);
    bool readAttribute(const Json& primitive, const std::string& name, size_t least, const std::string& where,
                       const Stand& stand, size_t count, Attribute& out, Error& error);
    bool readUvs(const Json& primitive, const std::string& where, const Stand& stand, Source& out,
                 Error& error);
    bool readInfluences(const Json& primitive, const std::string& where, const Stand& stand, Source& out,
                        Error& error);
    bool readCorners(const Json& primitive, const std::string& where, Source& out, Error& error);
    bool worldOf(const Source& source, const std::string& where, const Stand& stand, size_t which,
                 size_t vertex, glm::dmat4& out, Error& error) const;
    bool readVertices(const Source& source, const std::string& where, const Stand& stand, size_t which,
                      Vertices& out, bool& mirrored, Error& error) const;
    bool place(const Source& source, const std::string& where, const Stand& stand, size_t which,
               Error& error);
    bool readVertex(const Source& source, size_t vertex, const glm::dmat4& world, MeshVertex& out,
                    std::string& problem) const;
    bool readUv(const Source& source, size_t vertex, TextureSlot slot, glm::vec2& out) const;
    void append(const Source& source, Vertices&& made, std::vector<uint32_t>&& corners);

    const Document& document_;
    Buffers& buffers_;
    Materials& materials_;
    Notes& notes_;
    Mesh& mesh_;
    std::vector<std::vector<uint32_t>> corners_;
    std::vector<bool> clear_;
    size_t cornerCount_ = 0;
};

} // namespace demos::gltf
