#include "host/files/mesh_file.h"

#include <algorithm>

#include "host/gltf/nodes.h"
#include "host/mesh_parts.h"
#include "scene/input_limits.h"

namespace demos {
namespace {

bool readDocument(const gltf::Document& document, Mesh& mesh, Error& error) {
    gltf::Notes notes;
    gltf::Buffers buffers(document);
    gltf::Materials materials;
    if (!materials.create(document, buffers, notes, mesh, error)) return false;
    gltf::Primitives primitives(document, buffers, materials, notes, mesh);
    if (!gltf::Nodes(document, buffers, primitives, notes).read(error)) return false;
    mesh.fileBytes = document.bytes + buffers.uris().bytes();
    materials.finish(primitives.clear());
    if (!mesh.otherUvs.empty()) mesh.otherUvs.resize(mesh.vertices.size());
    divideIntoParts(primitives.corners(), mesh);
    mesh.leftOut = notes.lines();
    if (!mesh.parts.empty()) return true;
    error.text = "has no triangles to draw";
    for (const std::string& line : mesh.leftOut) error.text += "; " + line;
    return false;
}

} // namespace

uint32_t MeshMaterial::features() const {
    uint32_t bits = 0;
    const auto add = [&](bool has, MaterialFeature feature) { bits |= has ? feature : 0u; };
    add(alphaCutoff > 0, maskedFeature);
    add(blends, ditheredFeature);
    add(unlit, unlitFeature);
    add(specular.has_value(), specularFeature);
    add(textures[emissiveSlot].has_value(), emissiveMapFeature);
    add(textures[normalSlot].has_value(), normalMapFeature);
    add(textures[occlusionSlot].has_value(), occlusionMapFeature);
    add(otherUvs, otherUvsFeature);
    return bits;
}

std::optional<Mesh> readMesh(const std::filesystem::path& file, Error& error) {
    Mesh mesh;
    const std::optional<gltf::Document> document = gltf::readDocument(file, error);
    if (document && readDocument(*document, mesh, error)) return mesh;
    error.text = file.string() + ": " + error.text;
    return std::nullopt;
}

bool PlacedTriangles::place(uint64_t triangles, const std::filesystem::path& file, Error& error) {
    triangles_ += triangles;
    const uint64_t most = limits::sceneTriangles.of(bytes_);
    if (triangles_ <= most) return true;
    error.text = file.string() + ": brings the scene over " + std::to_string(most) +
                 " triangles: the most for so many bytes";
    return false;
}

} // namespace demos
