#include "tests/reference/box_file.h"

#include <algorithm>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "tests/reference/box_world.h"

namespace tests {
namespace {

std::string listed(const glm::vec3& v) {
    return "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]";
}

/// Tests run beside each other, and no two may write the same file.
std::string ownName(const std::string& name) {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    std::string own = std::string(test.test_suite_name()) + "_" + test.name() + "_" + name;
    std::ranges::replace(own, '/', '_');
    return own;
}

} // namespace

std::filesystem::path writeBoxes(const std::string& suffix, const std::vector<Box>& boxes, double albedo,
                                 double roughness) {
    const std::filesystem::path folder = testing::TempDir();
    const std::string name = ownName(suffix);
    const demos::Mesh mesh = shiningBoxes(boxes, glm::vec3(0));
    glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
    std::ofstream data(folder / (name + ".bin"), std::ios::binary);
    for (const demos::MeshVertex& vertex : mesh.vertices) {
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
        data.write(reinterpret_cast<const char*>(&vertex.position), 12);
        data.write(reinterpret_cast<const char*>(&vertex.normal), 12);
    }
    data.write(reinterpret_cast<const char*>(mesh.indices.data()),
               static_cast<std::streamsize>(mesh.indices.size() * 4));
    const std::string corners = std::to_string(mesh.vertices.size()),
                      indices = std::to_string(mesh.indices.size()),
                      cornerBytes = std::to_string(mesh.vertices.size() * 24),
                      indexBytes = std::to_string(mesh.indices.size() * 4),
                      bytes = std::to_string(mesh.vertices.size() * 24 + mesh.indices.size() * 4),
                      shade = std::to_string(albedo);
    std::ofstream text(folder / (name + ".gltf"));
    text << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":)"
         << roughness << R"(,"baseColorFactor":[)" << shade << "," << shade << "," << shade << R"(,1]}}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)"
         << corners << R"(,"min":)" << listed(low) << R"(,"max":)" << listed(high) << R"(},
{"bufferView":0,"byteOffset":12,"componentType":5126,"type":"VEC3","count":)"
         << corners << R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" << indices
         << R"(}],
"bufferViews":[{"buffer":0,"byteStride":24,"byteLength":)"
         << cornerBytes << R"(},{"buffer":0,"byteOffset":)" << cornerBytes << R"(,"byteLength":)"
         << indexBytes << R"(}],
"buffers":[{"uri":")"
         << name << R"(.bin","byteLength":)" << bytes << "}]}";
    return folder / (name + ".gltf");
}

} // namespace tests
