// The scene that a file shows first: its nodes, where they stand, and what hangs on them.
#pragma once

#include <map>

#include "host/gltf/primitives.h"

namespace demos::gltf {

class Nodes {
  public:
    Nodes(const Document& document, Buffers& buffers, Primitives& primitives, Notes& notes)
        : document_(document), buffers_(buffers), primitives_(primitives), notes_(notes) {}

    /// Adds the meshes of the default scene's nodes. Without recursion, so that no file can overflow the
    /// stack.
    bool read(Error& error);

  private:
    bool readChildren(Error& error);
    bool placeAll(Error& error);
    bool readRoots(std::vector<size_t>& out, Error& error);
    bool readAllRoots(std::vector<size_t>& out, Error& error) const;
    bool readList(const Json& list, const std::string& where, std::vector<size_t>& out, Error& error) const;
    bool readMesh(size_t node, Error& error);
    bool readInstances(const Json& node, const std::string& where, const glm::dmat4& world, Stand& out,
                       Error& error);
    bool readSkin(size_t skin, Stand& out, Error& error);
    bool readJoints(const Json& skin, const std::string& where, std::vector<glm::dmat4>& out, Error& error);
    bool readWeights(const Json& node, const Json& mesh, const std::string& where, Stand& out, Error& error);
    std::string placeOfNode(size_t node) const { return placeOf("nodes", node, document_.at("nodes", node)); }

    const Document& document_;
    Buffers& buffers_;
    Primitives& primitives_;
    Notes& notes_;
    std::vector<std::vector<size_t>> children_;
    std::vector<bool> isChild_;
    std::vector<std::optional<glm::dmat4>> world_;    ///< none on a cycle
    std::map<size_t, std::vector<glm::dmat4>> skins_; ///< Stand::joints of those that were read
    size_t instances_ = 0;
};

} // namespace demos::gltf
