// What the demos read of a glTF file: drawn as the file says, named, or refused.
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>

#include <gtest/gtest.h>

#include "host/files/image_file.h"
#include "host/files/mesh_file.h"
#include "tests/gltf/plate.h"
#include "tests/program/run.h"

namespace {

using demos::Mesh;
using tests::Json;
using tests::Plate;

const std::vector<uint8_t> red = {255, 0, 0, 255}, green = {0, 255, 0, 255}, clear = {0, 255, 0, 128};

class Folder {
  public:
    std::optional<Mesh> read(const std::string& content, std::string& problem,
                             const std::string& name = "plate.gltf") {
        tests::writeAll(folder_.path() / name, content);
        demos::Error error;
        std::optional<Mesh> mesh = demos::readMesh(folder_.path() / name, error);
        problem = error.text;
        return mesh;
    }
    std::filesystem::path path() const { return folder_.path(); }

  private:
    tests::TemporaryFolder folder_;
};

/// A plate that is written in one way, and what must come of it.
struct Case {
    std::string name;
    std::function<void(Plate&)> change;
    std::function<void(const Mesh&)> check;
    std::vector<std::string> leftOut = {}; ///< words of the only line; none: nothing is left out
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

void expectBounds(const Mesh& mesh, const glm::vec3& low, const glm::vec3& high) {
    EXPECT_LT(glm::length(mesh.low - low), 1e-5f) << mesh.low.x << " " << mesh.low.y << " " << mesh.low.z;
    EXPECT_LT(glm::length(mesh.high - high), 1e-5f) << mesh.high.x << " " << mesh.high.y;
}

/// Of all triangles, by the order of their corners.
void expectFacing(const Mesh& mesh, const glm::vec3& normal) {
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](size_t k) { return mesh.vertices[mesh.indices[i + k]].position; };
        const glm::vec3 faces = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        EXPECT_LT(glm::length(faces - normal), 1e-4f) << "triangle " << i / 3;
    }
    for (const demos::MeshVertex& vertex : mesh.vertices)
        EXPECT_LT(glm::length(vertex.normal - normal), 0.01f);
}

void expectPlate(const Mesh& mesh) {
    expectBounds(mesh, {-1, 0, 0}, {1, 2, 0});
    ASSERT_EQ(mesh.vertices.size(), 4u);
    expectFacing(mesh, {0, 0, 1});
    for (const demos::MeshVertex& vertex : mesh.vertices) {
        EXPECT_LT(glm::length(vertex.normal - glm::vec3(0, 0, 1)), 0.01f);
        EXPECT_LT(glm::length(vertex.uv - glm::vec2((vertex.position.x + 1) / 2, 1 - vertex.position.y / 2)),
                  1e-4f);
    }
}

void expectUvs(const Mesh& mesh, const std::vector<glm::vec2>& uvs) {
    ASSERT_EQ(mesh.vertices.size(), uvs.size());
    for (size_t i = 0; i < uvs.size(); ++i)
        EXPECT_LT(glm::length(mesh.vertices[i].uv - uvs[i]), 1e-5f)
            << i << ": " << mesh.vertices[i].uv.x << " " << mesh.vertices[i].uv.y;
}

const demos::MeshMaterial& materialOf(const Mesh& mesh) {
    return mesh.materials[mesh.parts.front().material];
}

bool isRed(const Mesh& mesh) {
    const std::optional<uint32_t>& base = materialOf(mesh).textures[demos::baseSlot];
    return base && mesh.textures[*base].rgba == std::vector<uint8_t>(red);
}

std::string shorts(const std::vector<int>& values) {
    std::string bytes;
    for (const int value : values) {
        bytes += static_cast<char>(value & 255);
        bytes += static_cast<char>(value >> 8 & 255);
    }
    return bytes;
}

std::string bytes(const std::vector<int>& values) {
    std::string made;
    for (const int value : values) made += static_cast<char>(value);
    return made;
}

/// A texture of which another file is the better, in a format that is not read.
void addOptionalImage(Plate& plate, const char* extension, const std::string& image) {
    plate.texture("baseColorTexture", tests::png(1, 1, red));
    plate.root["images"].push_back({{"bufferView", plate.addView(image)}, {"mimeType", "image/other"}});
    plate.root["textures"][0]["extensions"][extension] = {{"source", 1}};
    plate.root["extensionsUsed"] = {extension};
}

void addSkin(Plate& plate, const std::vector<float>& jointAt) {
    plate.node() = {{"mesh", 0}, {"skin", 0}, {"translation", {3, 0, 0}}};
    plate.root["nodes"].push_back({{"translation", jointAt}});
    plate.root["scenes"][0]["nodes"] = {0, 1};
    const size_t inverse = plate.addFloats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4");
    plate.root["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", inverse}}};
    plate.primitive()["attributes"]["JOINTS_0"] = plate.addAccessor(std::string(16, '\0'), 5121, "VEC4", 4);
    plate.primitive()["attributes"]["WEIGHTS_0"] =
        plate.addFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
}

std::vector<Case> primitives() {
    return {
        {"Plain", [](Plate&) {}, expectPlate},
        {"IndicesOfBytes",
         [](Plate& p) {
             p.primitive()["indices"] = p.addAccessor(bytes({0, 1, 2, 0, 2, 3}), 5121, "SCALAR", 6);
         },
         expectPlate},
        {"Strip",
         [](Plate& p) {
             p.primitive()["mode"] = 5;
             p.primitive()["indices"] = p.addAccessor(bytes({0, 1, 3, 2}), 5121, "SCALAR", 4);
         },
         expectPlate},
        {"Fan",
         [](Plate& p) {
             p.primitive()["mode"] = 6;
             p.primitive()["indices"] = p.addAccessor(bytes({0, 1, 2, 3}), 5121, "SCALAR", 4);
         },
         expectPlate},
        {"FanWithoutIndices",
         [](Plate& p) {
             p.primitive()["mode"] = 6;
             p.primitive().erase("indices");
         },
         expectPlate},
        {"WithoutNormals", [](Plate& p) { p.primitive()["attributes"].erase("NORMAL"); },
         [](const Mesh& mesh) {
             ASSERT_EQ(mesh.vertices.size(), 6u);
             for (const demos::MeshVertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal.z, 1);
         }},
        {"SharedVerticesAreTakenOnce",
         [](Plate& p) {
             Json half = p.primitive(), other = half;
             half["indices"] = p.addAccessor(bytes({0, 1, 2}), 5121, "SCALAR", 3);
             other["indices"] = p.addAccessor(bytes({0, 2, 3}), 5121, "SCALAR", 3);
             p.root["meshes"][0]["primitives"] = {half, other};
         },
         [](const Mesh& mesh) {
             EXPECT_EQ(mesh.vertices.size(), 6u);
             expectBounds(mesh, {-1, 0, 0}, {1, 2, 0});
         }},
    };
}

std::vector<Case> accessors() {
    return {
        {"Sparse",
         [](Plate& p) {
             const size_t indices = p.addView(shorts({2})),
                          values = p.addView(std::string("\0\0\0\x40\0\0\x40\x40\0\0\0\0", 12));
             p.root["accessors"][0]["sparse"] = {
                 {"count", 1},
                 {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                 {"values", {{"bufferView", values}}}};
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {-1, 0, 0}, {2, 3, 0});
         }},
        {"SparseOverNothing",
         [](Plate& p) {
             const size_t indices = p.addView(bytes({1, 2})),
                          values = p.addView(std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0"
                                                         "\0\0\x80\x3f\0\0\0\x40\0\0\0\0",
                                                         24));
             p.root["accessors"][0] = {{"componentType", 5126},
                                       {"type", "VEC3"},
                                       {"count", 4},
                                       {"sparse",
                                        {{"count", 2},
                                         {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                         {"values", {{"bufferView", values}}}}}};
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {0, 0, 0}, {1, 2, 0});
         }},
        {"UvsWithoutBytesAreZeros",
         [](Plate& p) {
             p.root["accessors"][2] = {{"componentType", 5126}, {"type", "VEC2"}, {"count", 4}};
         },
         [](const Mesh& mesh) {
             expectUvs(mesh, {{0, 0}, {0, 0}, {0, 0}, {0, 0}});
         }},
        {"Quantised",
         [](Plate& p) {
             p.root["extensionsUsed"] = p.root["extensionsRequired"] = {"KHR_mesh_quantization"};
             p.node()["scale"] = {0.001, 0.001, 0.001};
             Json& attributes = p.primitive()["attributes"];
             attributes["POSITION"] =
                 p.addAccessor(shorts({-1000, 0, 0, 0, 1000, 0, 0, 0, 1000, 2000, 0, 0, -1000, 2000, 0, 0}),
                               5122, "VEC3", 4);
             p.root["bufferViews"].back()["byteStride"] = 8;
             attributes["NORMAL"] = p.addAccessor(
                 bytes({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}), 5120, "VEC3", 4);
             p.root["bufferViews"].back()["byteStride"] = 4;
             p.root["accessors"].back()["normalized"] = true;
             attributes["TEXCOORD_0"] =
                 p.addAccessor(shorts({0, 65535, 65535, 65535, 65535, 0, 0, 0}), 5123, "VEC2", 4);
             p.root["accessors"].back()["normalized"] = true;
         },
         expectPlate},
        {"ColoursOfBytes",
         [](Plate& p) {
             p.primitive()["attributes"]["COLOR_0"] =
                 p.addAccessor(bytes({255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 255}),
                               5121, "VEC4", 4);
         },
         [](const Mesh& mesh) {
             EXPECT_EQ(mesh.vertices[0].color[0], 65535);
             EXPECT_EQ(mesh.vertices[0].color[1], 0);
             EXPECT_EQ(mesh.vertices[0].color[2], 13107);
         }},
    };
}

std::vector<Case> skinsAndMorphs() {
    return {
        {"SkinIgnoresItsNode",
         [](Plate& p) {
             addSkin(p, {0, 0, 0});
         },
         expectPlate},
        {"SkinFollowsItsJoints",
         [](Plate& p) {
             addSkin(p, {0, 5, 0});
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {-1, 5, 0}, {1, 7, 0});
         }},
        {"SkinOfWeightsThatAddUpToTwo",
         [](Plate& p) {
             addSkin(p, {0, 0, 0});
             p.primitive()["attributes"]["WEIGHTS_0"] =
                 p.addFloats({1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0}, "VEC4");
         },
         expectPlate},
        {"MorphOfTheMesh",
         [](Plate& p) {
             p.primitive()["targets"] = {
                 {{"POSITION", p.addFloats({0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3")}}};
             p.root["meshes"][0]["weights"] = {1};
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {-1, 1, 0}, {1, 3, 0});
         }},
        {"MorphOfTheNode",
         [](Plate& p) {
             p.primitive()["targets"] = {
                 {{"POSITION", p.addFloats({0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3")}},
                 {{"POSITION", p.addFloats({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3")}}};
             p.root["meshes"][0]["weights"] = {1, 1};
             p.node()["weights"] = {0.5, 0};
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {-1, 0.5f, 0}, {1, 2.5f, 0});
         }},
    };
}

std::vector<Case> placements() {
    return {
        {"MirroredNode",
         [](Plate& p) {
             p.node()["scale"] = {-1, 1, 1};
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {-1, 0, 0}, {1, 2, 0});
             expectFacing(mesh, {0, 0, 1});
         }},
        {"MirroredThroughItsPlane",
         [](Plate& p) {
             p.node()["scale"] = {1, 1, -1};
         },
         [](const Mesh& mesh) {
             expectFacing(mesh, {0, 0, -1});
         }},
        {"ParentsMoveAfterTheirChildren",
         [](Plate& p) {
             p.node()["translation"] = {0, 0, 5};
             p.root["nodes"].push_back({{"children", {0}},
                                        {"translation", {10, 0, 0}},
                                        {"rotation", {0, 0.7071067812, 0, 0.7071067812}}});
             p.root["scenes"][0]["nodes"] = {1};
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {15, 0, -1}, {15, 2, 1});
             expectFacing(mesh, {1, 0, 0});
         }},
        {"Instances",
         [](Plate& p) {
             p.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                 {"TRANSLATION", p.addFloats({-4, 0, 0, 0, 0, 0, 4, 0, 0}, "VEC3")},
                 {"SCALE", p.addFloats({1, 1, 1, 1, 1, 1, 1, 2, 1}, "VEC3")}};
         },
         [](const Mesh& mesh) {
             EXPECT_EQ(mesh.vertices.size(), 12u);
             expectBounds(mesh, {-5, 0, 0}, {5, 4, 0});
         }},
        {"InstancesTurn",
         [](Plate& p) {
             p.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] =
                 p.addAccessor(bytes({0, 127, 0, 0}), 5120, "VEC4", 1);
             p.root["accessors"].back()["normalized"] = true;
         },
         [](const Mesh& mesh) { EXPECT_EQ(mesh.vertices[0].normal.z, -1); }},
        {"InstancesOfOtherAttributesAlone",
         [](Plate& p) {
             p.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["_ID"] =
                 p.addFloats({1, 2}, "SCALAR");
         },
         expectPlate},
        {"HiddenNode",
         [](Plate& p) {
             p.root["nodes"].push_back({{"mesh", 0},
                                        {"translation", {9, 0, 0}},
                                        {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
             p.root["scenes"][0]["nodes"] = {0, 1};
         },
         expectPlate},
        {"SecondSceneIsTheDefault",
         [](Plate& p) {
             p.root["nodes"].push_back({{"mesh", 0}, {"translation", {9, 0, 0}}});
             p.root["scenes"].push_back({{"nodes", {1}}});
             p.root["scene"] = 1;
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {8, 0, 0}, {10, 2, 0});
         }},
    };
}

std::vector<Case> besideThePlate() {
    return {
        {"NoSceneIsTheDefault",
         [](Plate& p) {
             p.root["scenes"].push_back({{"nodes", {0}}});
             p.root.erase("scene");
         },
         expectPlate,
         {"scenes:", "the first of 2"}},
        {"NoSceneAtAll",
         [](Plate& p) {
             p.root["nodes"].push_back({{"mesh", 0}, {"translation", {9, 0, 0}}});
             p.root.erase("scenes");
             p.root.erase("scene");
         },
         [](const Mesh& mesh) {
             expectBounds(mesh, {-1, 0, 0}, {10, 2, 0});
         }},
        {"NoSceneAndCoarserLevels",
         [](Plate& p) {
             p.root["nodes"].push_back({{"mesh", 0}, {"translation", {9, 0, 0}}});
             p.root["nodes"].push_back({{"children", {3}}});
             p.root["nodes"].push_back({{"mesh", 0}, {"translation", {-9, 0, 0}}});
             p.node()["extensions"]["MSFT_lod"]["ids"] = {1, 2};
             p.root.erase("scenes");
             p.root.erase("scene");
         },
         expectPlate},
        {"Animated",
         [](Plate& p) {
             p.root["animations"] = {{{"channels", Json::array()}}};
         },
         expectPlate,
         {"animations:", "at rest"}},
        {"PointsBesideIt",
         [](Plate& p) {
             Json points = p.primitive();
             points["mode"] = 0;
             p.root["meshes"][0]["primitives"].push_back(points);
         },
         expectPlate,
         {"meshes[0].primitives[1]", "points"}},
        {"LinesBesideIt",
         [](Plate& p) {
             Json lines = p.primitive();
             lines["mode"] = 3;
             p.root["meshes"][0]["primitives"].push_back(lines);
         },
         expectPlate,
         {"meshes[0].primitives[1]", "lines"}},
    };
}

std::vector<Case> extensionsBesideThePlate() {
    return {
        {"Lights",
         [](Plate& p) {
             p.node()["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
         },
         expectPlate,
         {"nodes[0]", "KHR_lights_punctual"}},
        {"UnknownOfANode",
         [](Plate& p) {
             p.node()["extensions"]["VENDOR_bent"] = {{"by", 3}};
         },
         expectPlate,
         {"nodes[0]", "VENDOR_bent"}},
        {"UnknownOfAMesh",
         [](Plate& p) { p.root["meshes"][0]["extensions"]["VENDOR_fur"] = Json::object(); },
         expectPlate,
         {"meshes[0]", "VENDOR_fur"}},
        {"UnknownOfTheFile",
         [](Plate& p) {
             p.root["extensions"]["CESIUM_RTC"] = {{"center", {100, 0, 0}}};
             p.root["extensions"]["KHR_lights_punctual"] = {{"lights", {{{"type", "point"}}}}};
         },
         expectPlate,
         {"the file", "CESIUM_RTC"}},
        {"ColoursOfInstances",
         [](Plate& p) {
             p.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                 {"TRANSLATION", p.addFloats({0, 0, 0}, "VEC3")},
                 {"_COLOR_0", p.addFloats({1, 0, 0}, "VEC3")}};
         },
         expectPlate,
         {"nodes[0]", "_COLOR_0"}},
        {"HarmlessOfANode",
         [](Plate& p) {
             p.node()["extensions"]["KHR_xmp_json_ld"] = {{"packet", 0}};
             p.root["cameras"] = {{{"type", "perspective"}}};
             p.node()["camera"] = 0;
         },
         expectPlate},
        {"OptionalDracoWithFallback",
         [](Plate& p) {
             p.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
         },
         expectPlate},
    };
}

void anything(const Mesh&) {}

std::vector<Case> uvSets() {
    return {
        {"SecondUvSet",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.material()["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
             p.primitive()["attributes"]["TEXCOORD_1"] = p.addFloats({0, 3, 3, 3, 3, 0, 0, 0}, "VEC2");
         },
         [](const Mesh& mesh) {
             expectUvs(mesh, {{0, 3}, {3, 3}, {3, 0}, {0, 0}});
             EXPECT_TRUE(mesh.otherUvs.empty());
         }},
        {"SecondUvSetOfOneTexture",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.texture("occlusionTexture", tests::png(1, 1, red));
             p.material()["occlusionTexture"]["texCoord"] = 1;
             p.primitive()["attributes"]["TEXCOORD_1"] = p.addFloats({0, 3, 3, 3, 3, 0, 0, 0}, "VEC2");
         },
         [](const Mesh& mesh) {
             expectUvs(mesh, {{0, 1}, {1, 1}, {1, 0}, {0, 0}});
             ASSERT_EQ(mesh.otherUvs.size(), 4u);
             EXPECT_EQ(mesh.otherUvs[1][demos::occlusionSlot - 1], glm::vec2(3, 3));
             EXPECT_EQ(mesh.otherUvs[1][demos::normalSlot - 1], glm::vec2(1, 1));
         }},
        {"MissingUvSet",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.material()["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 2;
         },
         [](const Mesh& mesh) {
             expectUvs(mesh, {{0, 0}, {0, 0}, {0, 0}, {0, 0}});
         },
         {"meshes[0].primitives[0]", "TEXCOORD_2"}},
        {"TextureTransform",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.material()["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] =
                 {{"scale", {4, 2}}, {"offset", {0.5, 0.25}}};
         },
         [](const Mesh& mesh) {
             expectUvs(mesh, {{0.5, 2.25}, {4.5, 2.25}, {4.5, 0.25}, {0.5, 0.25}});
         }},
        {"TextureTransformTurns", // the specification's example: the lower left quarter, turned clockwise
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.material()["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] =
                 {{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}};
         },
         [](const Mesh& mesh) {
             expectUvs(mesh, {{0.5, 1}, {0.5, 0.5}, {0, 0.5}, {0, 1}});
         }},
        {"TextureTransformChoosesTheSet",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.material()["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] =
                 {{"texCoord", 1}};
             p.primitive()["attributes"]["TEXCOORD_1"] = p.addFloats({0, 3, 3, 3, 3, 0, 0, 0}, "VEC2");
         },
         [](const Mesh& mesh) {
             expectUvs(mesh, {{0, 3}, {3, 3}, {3, 0}, {0, 0}});
         }},
    };
}

std::vector<Case> surfaces() {
    return {
        {"EmissiveStrength",
         [](Plate& p) {
             p.material()["emissiveFactor"] = {1, 0.5, 0};
             p.material()["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 20}};
         },
         [](const Mesh& mesh) { EXPECT_EQ(materialOf(mesh).emissive, glm::vec3(20, 10, 0)); }},
        {"EmissiveTexture",
         [](Plate& p) {
             p.material()["emissiveFactor"] = {1, 1, 1};
             p.texture("emissiveTexture", tests::png(1, 1, red));
         },
         [](const Mesh& mesh) {
             const auto& texture = materialOf(mesh).textures[demos::emissiveSlot];
             ASSERT_TRUE(texture);
             EXPECT_TRUE(mesh.textures[*texture].srgb);
         }},
        {"Unlit", [](Plate& p) { p.material()["extensions"]["KHR_materials_unlit"] = Json::object(); },
         [](const Mesh& mesh) { EXPECT_EQ(materialOf(mesh).features(), demos::unlitFeature); }},
        {"SpecularGlossiness",
         [](Plate& p) {
             p.material()["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
                 {"diffuseFactor", {0.8, 0.05, 0.05, 1}},
                 {"glossinessFactor", 0.25},
                 {"specularFactor", {0, 0, 1}}};
         },
         [](const Mesh& mesh) {
             const demos::MeshMaterial& material = materialOf(mesh);
             EXPECT_EQ(material.baseColor, glm::vec4(0.8f, 0.05f, 0.05f, 1));
             EXPECT_EQ(material.specular, glm::vec3(0, 0, 1));
             EXPECT_EQ(material.roughness, 0.75f);
         }},
        {"Nearest",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.root["textures"][0]["sampler"] = 0;
             p.root["samplers"] = {
                 {{"magFilter", 9728}, {"minFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}}};
         },
         [](const Mesh& mesh) {
             const demos::MeshTexture& texture = mesh.textures.at(0);
             EXPECT_EQ(texture.larger, demos::Filter::nearest);
             EXPECT_EQ(texture.smaller, demos::Filter::nearest);
             EXPECT_EQ(texture.mips, demos::Mips::none);
             EXPECT_EQ(texture.wrapU, demos::Wrap::clamp);
             EXPECT_EQ(texture.wrapV, demos::Wrap::mirror);
         }},
    };
}

std::vector<Case> alphas() {
    return {
        {"OpaqueIgnoresAlpha", [](Plate& p) { p.texture("baseColorTexture", tests::png(1, 1, clear)); },
         [](const Mesh& mesh) { EXPECT_EQ(materialOf(mesh).features(), 0u); }},
        {"BlendByFactor",
         [](Plate& p) {
             p.material()["alphaMode"] = "BLEND";
             p.material()["name"] = "glass";
             p.material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.3};
         },
         [](const Mesh& mesh) { EXPECT_EQ(materialOf(mesh).features(), demos::ditheredFeature); },
         {"materials[0] \"glass\"", "dithered"}},
        {"BlendByTexture",
         [](Plate& p) {
             p.material()["alphaMode"] = "BLEND";
             p.texture("baseColorTexture", tests::png(1, 1, clear));
         },
         [](const Mesh& mesh) { EXPECT_TRUE(materialOf(mesh).blends); },
         {"materials[0]", "dithered"}},
        {"BlendByVertices",
         [](Plate& p) {
             p.material()["alphaMode"] = "BLEND";
             p.primitive()["attributes"]["COLOR_0"] =
                 p.addFloats({1, 1, 1, 1, 1, 1, 1, 0.5, 1, 1, 1, 1, 1, 1, 1, 1}, "VEC4");
         },
         [](const Mesh& mesh) { EXPECT_TRUE(materialOf(mesh).blends); },
         {"materials[0]", "dithered"}},
        {"BlendOfNothingClear",
         [](Plate& p) {
             p.material()["alphaMode"] = "BLEND";
             p.texture("baseColorTexture", tests::png(1, 1, red));
         },
         [](const Mesh& mesh) { EXPECT_FALSE(materialOf(mesh).blends); }},
        {"Mask",
         [](Plate& p) {
             p.material()["alphaMode"] = "MASK";
             p.material()["alphaCutoff"] = 0.25;
         },
         [](const Mesh& mesh) { EXPECT_EQ(materialOf(mesh).alphaCutoff, 0.25f); }},
        {"AlphaModeThatIsNone",
         [](Plate& p) {
             p.material()["alphaMode"] = "Blend";
             p.texture("baseColorTexture", tests::png(1, 1, clear));
         },
         [](const Mesh& mesh) { EXPECT_EQ(materialOf(mesh).features(), 0u); },
         {"materials[0]", "\"Blend\"", "expected OPAQUE, MASK or BLEND", "opaque"}},
        {"AlphaModeThatIsNoText",
         [](Plate& p) { p.material()["alphaMode"] = 2; },
         [](const Mesh& mesh) { EXPECT_EQ(materialOf(mesh).features(), 0u); },
         {"materials[0]", "expected OPAQUE, MASK or BLEND"}},
        {"SamplerThatIsNone",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.root["samplers"] = {{{"wrapS", 33070}, {"wrapT", 33648}}};
             p.root["textures"][0]["sampler"] = 0;
         },
         [](const Mesh& mesh) {
             EXPECT_EQ(mesh.textures.at(0).wrapU, demos::Wrap::repeat);
             EXPECT_EQ(mesh.textures.at(0).wrapV, demos::Wrap::mirror);
         },
         {"samplers[0].wrapS", "unknown"}},
    };
}

std::vector<Case> images() {
    return {
        {"WebpWithFallback", [](Plate& p) { addOptionalImage(p, "EXT_texture_webp", "RIFFxxxxWEBP"); },
         [](const Mesh& mesh) { EXPECT_TRUE(isRed(mesh)); }},
        {"Ktx2WithFallback",
         [](Plate& p) { addOptionalImage(p, "KHR_texture_basisu", "\xabKTX 20\xbb\r\n\x1a\n"); },
         [](const Mesh& mesh) { EXPECT_TRUE(isRed(mesh)); }},
        {"Ktx2Alone",
         [](Plate& p) {
             addOptionalImage(p, "KHR_texture_basisu", "\xabKTX 20\xbb\r\n\x1a\n");
             p.root["textures"][0].erase("source");
         },
         [](const Mesh& mesh) { EXPECT_FALSE(materialOf(mesh).textures[demos::baseSlot]); },
         {"materials[0].baseColorTexture", "images[1]", "KTX2"}},
        {"ImageIsMissing",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.root["images"][0] = {{"uri", "textures%5Cnot_there.png"}};
         },
         [](const Mesh& mesh) { EXPECT_FALSE(materialOf(mesh).textures[demos::baseSlot]); },
         {"materials[0].baseColorTexture", "not_there.png", "no such file"}},
        {"ImageIsNoPicture",
         [](Plate& p) { p.texture("normalTexture", "this is text"); },
         anything,
         {"materials[0].normalTexture", "neither PNG nor JPEG"}},
        {"ImageIsCutOff",
         [](Plate& p) { p.texture("baseColorTexture", tests::png(1, 1, red).substr(0, 40)); },
         anything,
         {"materials[0].baseColorTexture", "images[0]"}},
        {"ImageWithinTheFile",
         [](Plate& p) {
             p.texture("baseColorTexture", "");
             p.root["images"][0] = {{"bufferView", p.addView(tests::png(1, 1, red))},
                                    {"mimeType", "image/jpeg"}};
         },
         [](const Mesh& mesh) { EXPECT_TRUE(isRed(mesh)); }},
        {"ImagePastItsBuffer",
         [](Plate& p) {
             p.texture("baseColorTexture", "");
             p.root["images"][0] = {{"bufferView", p.addView(tests::png(1, 1, red))},
                                    {"mimeType", "image/png"}};
             p.root["bufferViews"].back()["byteOffset"] = 1 << 20;
         },
         anything,
         {"materials[0].baseColorTexture", "images[0]", "reaches past its buffer"}},
        {"ImageThatNobodyUses",
         [](Plate& p) {
             p.root["images"] = {{{"uri", "nowhere.png"}}};
         },
         anything},
    };
}

std::vector<Case> unknownOfMaterials() {
    return {
        {"UnknownOfAMaterial",
         [](Plate& p) {
             p.material()["extensions"]["VENDOR_glitter"] = {{"grain", 3}};
         },
         anything,
         {"materials[0]", "VENDOR_glitter"}},
        {"UnknownOfATexture",
         [](Plate& p) {
             p.texture("baseColorTexture", tests::png(1, 1, red));
             p.root["textures"][0]["extensions"]["VENDOR_moving"] = Json::object();
         },
         anything,
         {"textures[0]", "VENDOR_moving"}},
        {"ManyAreOneLine",
         [](Plate& p) {
             p.material()["extensions"]["VENDOR_glitter"] = Json::object();
             p.root["materials"].push_back(p.material());
             Json second = p.primitive();
             second["material"] = 1;
             p.root["meshes"][0]["primitives"].push_back(second);
         },
         anything,
         {"materials[0] (and 1 more)"}},
        {"NameWithControlCharacters",
         [](Plate& p) {
             p.material()["name"] = "a\x1b[31m\nb" + std::string(500, 'x');
             p.material()["extensions"]["VENDOR_glitter"] = Json::object();
         },
         anything,
         {"materials[0] \"a?[31m bxxx"}},
        {"MaterialThatNobodyUses",
         [](Plate& p) {
             p.root["materials"].push_back({{"extensions", {{"VENDOR_glitter", Json::object()}}}});
         },
         anything},
    };
}

std::vector<Case> layers() {
    std::vector<Case> cases;
    const std::pair<const char*, Json> extensions[] = {
        {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}},
        {"KHR_materials_transmission", {{"transmissionFactor", 0.5}}},
        {"KHR_materials_sheen", {{"sheenColorFactor", {0, 0.1, 0}}}},
        {"KHR_materials_ior", {{"ior", 1.33}}},
        {"KHR_materials_specular", {{"specularFactor", 0}}},
        {"KHR_materials_iridescence", {{"iridescenceFactor", 1}}},
        {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}}},
        {"KHR_materials_volume", {{"thicknessFactor", 1}}},
        {"KHR_materials_dispersion", {{"dispersion", 1}}},
        {"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 1}}},
    };
    for (const auto& [name, value] : extensions) {
        const std::string extension = name;
        cases.push_back({extension.substr(4),
                         [=, given = value](Plate& p) { p.material()["extensions"][extension] = given; },
                         anything,
                         {"materials[0]", extension}});
        cases.push_back({extension.substr(4) + "_ofNothing",
                         [=](Plate& p) { p.material()["extensions"][extension] = Json::object(); },
                         anything});
    }
    return cases;
}

class Reads : public testing::TestWithParam<Case> {};

TEST_P(Reads, AsItIsWritten) {
    Plate plate;
    GetParam().change(plate);
    Folder folder;
    for (const bool binary : {false, true}) {
        std::string problem;
        const std::optional<Mesh> mesh = folder.read(binary ? plate.binary() : plate.text(), problem);
        ASSERT_TRUE(mesh) << problem;
        GetParam().check(*mesh);
        ASSERT_EQ(mesh->leftOut.size(), GetParam().leftOut.empty() ? 0u : 1u)
            << testing::PrintToString(mesh->leftOut);
        for (const std::string& word : GetParam().leftOut) {
            EXPECT_NE(mesh->leftOut[0].find(word), std::string::npos) << mesh->leftOut[0];
            EXPECT_LT(mesh->leftOut[0].size(), 300u);
        }
    }
}

const auto nameOf = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Primitives, Reads, testing::ValuesIn(primitives()), nameOf);
INSTANTIATE_TEST_SUITE_P(Accessors, Reads, testing::ValuesIn(accessors()), nameOf);
INSTANTIATE_TEST_SUITE_P(SkinsAndMorphs, Reads, testing::ValuesIn(skinsAndMorphs()), nameOf);
INSTANTIATE_TEST_SUITE_P(Placements, Reads, testing::ValuesIn(placements()), nameOf);
INSTANTIATE_TEST_SUITE_P(BesideThePlate, Reads, testing::ValuesIn(besideThePlate()), nameOf);
INSTANTIATE_TEST_SUITE_P(ExtensionsBesideThePlate, Reads, testing::ValuesIn(extensionsBesideThePlate()),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(UvSets, Reads, testing::ValuesIn(uvSets()), nameOf);
INSTANTIATE_TEST_SUITE_P(Surfaces, Reads, testing::ValuesIn(surfaces()), nameOf);
INSTANTIATE_TEST_SUITE_P(Alphas, Reads, testing::ValuesIn(alphas()), nameOf);
INSTANTIATE_TEST_SUITE_P(Images, Reads, testing::ValuesIn(images()), nameOf);
INSTANTIATE_TEST_SUITE_P(UnknownOfMaterials, Reads, testing::ValuesIn(unknownOfMaterials()), nameOf);
INSTANTIATE_TEST_SUITE_P(Layers, Reads, testing::ValuesIn(layers()), nameOf);

TEST(Reads, WhatAFileIsItsFirstBytesSay) {
    Folder folder;
    std::string problem;
    const Plate plate;
    for (const char* const name : {"a.gltf", "a.glb", "a.GLB", "a"}) {
        EXPECT_TRUE(folder.read(plate.text(), problem, name)) << problem;
        EXPECT_TRUE(folder.read(plate.binary(), problem, name)) << problem;
    }
    EXPECT_TRUE(folder.read("\xef\xbb\xbf" + plate.text(), problem)) << problem;
}

TEST(Reads, NamesOfImagesAsExportersWriteThem) {
    Folder folder;
    std::filesystem::create_directory(folder.path() / "textures");
    const std::pair<const char*, const char*> names[] = {{"textures\\Light.png", "textures/Light.png"},
                                                         {"textures%5CLight.png", "textures/Light.png"},
                                                         {"a b+c.png", "a b+c.png"},
                                                         {"a%20b+c.png", "a b+c.png"},
                                                         {"100%.png", "100%.png"},
                                                         {"./textures/../a b+c.png", "a b+c.png"}};
    for (const auto& [uri, file] : names) {
        tests::writeAll(folder.path() / file, tests::png(1, 1, red));
        Plate plate;
        plate.texture("baseColorTexture", "");
        plate.root["images"][0] = {{"uri", uri}};
        std::string problem;
        const std::optional<Mesh> mesh = folder.read(plate.text(), problem);
        ASSERT_TRUE(mesh) << problem;
        EXPECT_TRUE(isRed(*mesh)) << uri;
    }
}

TEST(Reads, DataUrisAsProgramsWriteThem) {
    const auto replaced = [](const std::string& text, const std::string& each, const std::string& with) {
        std::string out;
        for (const char c : text) out += each.find(c) == each.npos ? std::string(1, c) : with;
        return out;
    };
    Folder folder;
    Plate plate;
    plate.texture("baseColorTexture", tests::png(1, 1, red));
    const std::string uri = plate.root["images"][0]["uri"], digits = uri.substr(uri.find(',') + 1);
    ASSERT_NE(digits.find('='), digits.npos) << "padding, to be escaped below";
    for (const std::string& written :
         {"data:;base64," + digits, "data:image/png;charset=utf-8;base64," + digits,
          "DATA:image/png;base64," + digits, "data:image/png;base64," + replaced(digits, "=", "%3D"),
          "data:image/png;base64," + digits.substr(0, 9) + "\r\n " + digits.substr(9) + "\n"}) {
        plate.root["images"][0]["uri"] = written;
        std::string problem;
        const std::optional<Mesh> mesh = folder.read(plate.text(), problem);
        ASSERT_TRUE(mesh) << problem;
        EXPECT_TRUE(isRed(*mesh)) << written;
    }
}

/// A file that is refused, and words of the one line that says why.
struct Refused {
    std::string name;
    std::function<std::string(Plate&)> make;
    std::vector<std::string> says;
};

void PrintTo(const Refused& r, std::ostream* out) {
    *out << r.name;
}

std::function<std::string(Plate&)> changed(const std::function<void(Plate&)>& change) {
    return [change](Plate& plate) {
        change(plate);
        return plate.text();
    };
}

/// Vertices that the file holds no bytes for, as its first accessor's.
void addZeros(Plate& plate) {
    plate.root["accessors"].push_back({{"componentType", 5126}, {"count", 1 << 20}, {"type", "VEC3"}});
    plate.primitive()["attributes"] = {{"POSITION", plate.root["accessors"].size() - 1}};
}

std::string blackPng(uint32_t width, uint32_t height) {
    const tests::TemporaryFolder folder;
    const std::vector<uint8_t> rgb(size_t{width} * height * 3);
    demos::Error error;
    EXPECT_TRUE(demos::writePng(folder.path() / "a.png", width, height, rgb, error)) << error.text;
    return tests::readAll(folder.path() / "a.png");
}

std::string deep(size_t levels) {
    return R"({"asset":{"version":"2.0"},"extras":)" + std::string(levels, '[') + std::string(levels, ']') +
           "}";
}

std::vector<Refused> refusedFiles() {
    return {
        {"Empty", [](Plate&) { return std::string(); }, {"no glTF"}},
        {"NoJson", [](Plate&) { return std::string("hello\nworld"); }, {"no glTF", "line 1"}},
        {"NoObject", [](Plate&) { return std::string("[1]"); }, {"no glTF"}},
        {"CutOff", [](Plate& p) { return p.text().substr(0, 200); }, {"no glTF"}},
        {"NestedDeep", [](Plate&) { return deep(20000); }, {"64 levels"}},
        {"NestedAfterTheEnd", [](Plate& p) { return p.text() + std::string(20000, '['); }, {"64 levels"}},
        {"ManyValues",
         [](Plate&) {
             std::string list;
             for (int i = 0; i < 2'100'000; ++i) list += "0,";
             return R"({"asset":{"version":"2.0"},"extras":[)" + list + "0]}";
         },
         {"2 million values"}},
        {"BinaryCutOff", [](Plate& p) { return p.binary().substr(0, 300); }, {"cut off", "300 bytes"}},
        {"BinaryHeaderAlone", [](Plate& p) { return p.binary().substr(0, 14); }, {"cut off"}},
        {"BinaryOfVersion1",
         [](Plate& p) {
             std::string binary = p.binary();
             binary[4] = 1;
             return binary;
         },
         {"binary glTF 1", "expected 2"}},
        {"BinaryChunkTooLong",
         [](Plate& p) {
             std::string binary = p.binary();
             binary[15] = 0x7f;
             return binary;
         },
         {"chunk"}},
    };
}

std::vector<Refused> refusedVersions() {
    return {
        {"Version1",
         changed([](Plate& p) { p.root["asset"]["version"] = "1.0"; }),
         {"glTF \"1.0\"", "expected 2.0"}},
        {"Version3", changed([](Plate& p) { p.root["asset"]["version"] = "3.0"; }), {"glTF \"3.0\""}},
        {"NoVersion", changed([](Plate& p) { p.root.erase("asset"); }), {"asset.version"}},
        {"LaterLeastVersion", changed([](Plate& p) { p.root["asset"]["minVersion"] = "2.1"; }), {"\"2.1\""}},
        {"DracoRequired",
         changed([](Plate& p) { p.root["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
         {"KHR_draco_mesh_compression", "not read"}},
        {"DracoAlone",
         changed([](Plate& p) {
             p.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
             p.root["accessors"][0].erase("bufferView");
         }),
         {"KHR_draco_mesh_compression"}},
        {"MeshoptAlone",
         changed([](Plate& p) {
             p.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
             p.root["bufferViews"][0]["buffer"] = 1;
             p.root["buffers"] = {{{"byteLength", 4}, {"uri", "data:;base64,AAAAAA=="}},
                                  {{"byteLength", 99}}};
         }),
         {"EXT_meshopt_compression"}},
        {"UnknownRequired",
         changed([](Plate& p) { p.root["extensionsRequired"] = {"VENDOR_a\nb"}; }),
         {"VENDOR_a b"}},
    };
}

std::vector<Refused> refusedScenes() {
    return {
        {"NothingInIt",
         changed([](Plate& p) { p.root["scenes"][0]["nodes"] = Json::array(); }),
         {"no triangles"}},
        {"PointsAlone", changed([](Plate& p) { p.primitive()["mode"] = 0; }), {"no triangles", "points"}},
        {"SceneOutOfRange", changed([](Plate& p) { p.root["scene"] = 3; }), {".scene", "0, the only one"}},
        {"NodeOutOfRange",
         changed([](Plate& p) { p.root["scenes"][0]["nodes"] = {7}; }),
         {"scenes[0].nodes[0]"}},
        {"NodeIsNegative",
         changed([](Plate& p) { p.root["scenes"][0]["nodes"] = {-1}; }),
         {"scenes[0].nodes[0]"}},
        {"NodeIsItsParent", changed([](Plate& p) { p.node()["children"] = {0}; }), {"nodes[0]", "tree"}},
        {"NodeTwice",
         changed([](Plate& p) {
             p.root["scenes"][0]["nodes"] = {0, 0};
         }),
         {"nodes[0]", "tree"}},
        {"MeshIsText", changed([](Plate& p) { p.node()["mesh"] = "big"; }), {"nodes[0].mesh"}},
        {"MatrixIsShort",
         changed([](Plate& p) {
             p.node()["matrix"] = {1, 0};
         }),
         {"nodes[0].matrix", "16 numbers"}},
        {"TransformIsHuge",
         changed([](Plate& p) {
             p.node()["scale"] = {1e300, 1e300, 1e300};
         }),
         {"meshes[0].primitives[0]", "1e7 m away"}},
        {"MaterialOutOfRange", changed([](Plate& p) { p.primitive()["material"] = 9; }), {".material"}},
    };
}

std::vector<Refused> refusedVertices() {
    return {
        {"NoPositions",
         changed([](Plate& p) { p.primitive()["attributes"].erase("POSITION"); }),
         {"no positions"}},
        {"PositionIsNan",
         changed([](Plate& p) {
             p.primitive()["attributes"]["POSITION"] =
                 p.addFloats({-1, 0, 0, 1, NAN, 0, 1, 2, 0, -1, 2, 0}, "VEC3");
         }),
         {"vertex 1 is not finite"}},
        {"IndexOutOfRange",
         changed([](Plate& p) {
             p.primitive()["indices"] = p.addAccessor(bytes({0, 1, 9}), 5121, "SCALAR", 3);
         }),
         {"indices[2] is 9", "4 vertices"}},
        {"IndicesAreFloats",
         changed([](Plate& p) {
             p.primitive()["indices"] = p.addFloats({0, 1, 2}, "SCALAR");
         }),
         {"unsigned"}},
        {"CountIsHuge",
         changed([](Plate& p) { p.root["accessors"][0]["count"] = 9007199254740000; }),
         {"accessors[0]", "reaches past"}},
        {"CountIsHugeWithoutBytes",
         changed([](Plate& p) {
             p.root["accessors"][0].erase("bufferView");
             p.root["accessors"][0]["count"] = 4000000000;
         }),
         {"accessors[0]", "has no bytes"}},
        {"StrideIsShort",
         changed([](Plate& p) { p.root["bufferViews"][0]["byteStride"] = 4; }),
         {"reaches past"}},
        {"ViewPastItsBuffer",
         changed([](Plate& p) { p.root["bufferViews"][0]["byteOffset"] = 4000; }),
         {"bufferViews[0]", "reaches past"}},
        {"SparsePastItsEnd",
         changed([](Plate& p) {
             p.root["accessors"][0]["sparse"] = {
                 {"count", 1},
                 {"indices", {{"bufferView", p.addView(bytes({200}))}, {"componentType", 5121}}},
                 {"values", {{"bufferView", p.addView(std::string(12, '\0'))}}}};
         }),
         {"accessors[0].sparse"}},
        {"JointOutOfRange",
         changed([](Plate& p) {
             addSkin(p, {0, 0, 0});
             p.primitive()["attributes"]["JOINTS_0"] =
                 p.addAccessor(std::string(16, '\x05'), 5121, "VEC4", 4);
         }),
         {"joint 5 of 1"}},
    };
}

std::vector<Refused> refusedBuffers() {
    return {
        {"BufferIsMissing",
         changed([](Plate& p) {
             p.root["buffers"] = {{{"byteLength", 200}, {"uri", "gone.bin"}}};
         }),
         {"buffers[0]", "gone.bin", "no such file"}},
        {"BufferIsShort",
         changed([](Plate& p) {
             p.root["buffers"] = {{{"byteLength", 200}, {"uri", "data:;base64,AAAA"}}};
         }),
         {"buffers[0] has 3 bytes, expected 200"}},
        {"BufferIsNoBase64",
         changed([](Plate& p) {
             p.root["buffers"] = {{{"byteLength", 200}, {"uri", "data:;base64,A*"}}};
         }),
         {"buffers[0]", "data URI"}},
        {"BufferOnTheNetwork",
         changed([](Plate& p) {
             p.root["buffers"] = {{{"byteLength", 2}, {"uri", "https://x.org/a.bin"}}};
         }),
         {"only files"}},
    };
}

/// Small files that ask for much.
std::vector<Refused> refusedRepeats() {
    return {
        {"FewElementsReplacedOften",
         changed([](Plate& p) {
             constexpr size_t often = 200000;
             const size_t zeros = p.addView(std::string(often * 2, '\0'));
             p.root["accessors"][3] = {{"componentType", 5123},
                                       {"type", "SCALAR"},
                                       {"count", 6},
                                       {"sparse",
                                        {{"count", often},
                                         {"indices", {{"bufferView", zeros}, {"componentType", 5121}}},
                                         {"values", {{"bufferView", zeros}}}}}};
             p.root["meshes"][0]["primitives"] = std::vector<Json>(120, p.primitive());
         }),
         {"sparse brings what is read over"}},
    };
}

std::vector<Refused> refusedLoads() {
    return {
        {"AMeshTooOften",
         changed([](Plate& p) {
             std::vector<float> positions;
             for (int i = 0; i < 60000; ++i)
                 positions.insert(positions.end(), {float(i % 100), float(i / 100), 0});
             p.primitive() = {{"attributes", {{"POSITION", p.addFloats(positions, "VEC3")}}}};
             p.root["nodes"] = std::vector<Json>(266, Json{{"mesh", 0}});
             p.root.erase("scenes");
             p.root.erase("scene");
         }),
         {"brings the scene over"}},
        {"ManyPrimitivesOfNoBytes",
         changed([](Plate& p) {
             addZeros(p);
             p.root["meshes"][0]["primitives"] = std::vector<Json>(64, p.primitive());
         }),
         {"brings what is read over", "the most for so many bytes"}},
        {"ManyMorphTargets",
         changed([](Plate& p) {
             addZeros(p);
             p.root["meshes"][0]["weights"] = std::vector<int>(64, 1);
             p.primitive()["targets"] = std::vector<Json>(64, p.primitive()["attributes"]);
         }),
         {"brings what is read over"}},
        {"ManySparseZeros",
         changed([](Plate& p) {
             addZeros(p);
             p.root["accessors"].back()["type"] = "MAT4";
             p.root["accessors"].back()["sparse"] = {
                 {"count", 1},
                 {"indices", {{"bufferView", p.addView(bytes({2}))}, {"componentType", 5121}}},
                 {"values", {{"bufferView", p.addView(std::string(64, '\0'))}}}};
             for (const char* name : {"NORMAL", "COLOR_0", "TEXCOORD_0"})
                 p.primitive()["attributes"][name] = p.primitive()["attributes"]["POSITION"];
             p.root["meshes"][0]["weights"] = {1, 1};
             p.primitive()["targets"] = {p.primitive()["attributes"], p.primitive()["attributes"]};
         }),
         {"sparse", "over 256 MiB"}},
        {"ManyJoints",
         changed([](Plate& p) {
             addSkin(p, {0, 0, 0});
             p.root["skins"][0].erase("inverseBindMatrices");
             p.root["skins"][0]["joints"] = std::vector<int>(20000, 0);
             p.root["nodes"] = std::vector<Json>(64, p.node());
             p.root.erase("scenes");
             p.root.erase("scene");
         }),
         {"skins[0]", "brings what is read over"}},
        {"ManyWeights",
         changed([](Plate& p) {
             p.root["meshes"][0]["weights"] = std::vector<int>(200000, 0);
             p.root["nodes"] = std::vector<Json>(128, Json{{"mesh", 0}});
             p.root.erase("scenes");
             p.root.erase("scene");
         }),
         {"brings what is read over"}},
        {"ManyFlatTextures",
         [](Plate& p) {
             p.root["images"] = {{{"uri", "data:;base64," + tests::base64(blackPng(4096, 4096))}}};
             p.root["textures"] = std::vector<Json>(2, Json{{"source", 0}});
             p.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
             p.material()["normalTexture"] = {{"index", 1}};
             return p.text();
         },
         {"images[0]", "brings the textures over", "the most for so many bytes"}},
    };
}

class Refuses : public testing::TestWithParam<Refused> {};

TEST_P(Refuses, InOneLine) {
    Plate plate;
    Folder folder;
    std::string problem;
    EXPECT_FALSE(folder.read(GetParam().make(plate), problem));
    EXPECT_TRUE(problem.starts_with((folder.path() / "plate.gltf").string())) << problem;
    EXPECT_EQ(problem.find('\n'), std::string::npos) << problem;
    EXPECT_LT(problem.size(), 400u);
    for (const std::string& word : GetParam().says)
        EXPECT_NE(problem.find(word), std::string::npos) << "'" << word << "' is not in: " << problem;
}

INSTANTIATE_TEST_SUITE_P(Files, Refuses, testing::ValuesIn(refusedFiles()), nameOf);
INSTANTIATE_TEST_SUITE_P(Versions, Refuses, testing::ValuesIn(refusedVersions()), nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, Refuses, testing::ValuesIn(refusedScenes()), nameOf);
INSTANTIATE_TEST_SUITE_P(Vertices, Refuses, testing::ValuesIn(refusedVertices()), nameOf);
INSTANTIATE_TEST_SUITE_P(Buffers, Refuses, testing::ValuesIn(refusedBuffers()), nameOf);
INSTANTIATE_TEST_SUITE_P(Repeats, Refuses, testing::ValuesIn(refusedRepeats()), nameOf);
INSTANTIATE_TEST_SUITE_P(Loads, Refuses, testing::ValuesIn(refusedLoads()), nameOf);

} // namespace
