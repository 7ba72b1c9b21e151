#include "tests/reference/box_world.h"

#include <gtest/gtest.h>

namespace tests {

demos::SkyImage evenSky(const glm::vec3& radiance) {
    demos::SkyImage sky;
    sky.width = 64;
    sky.height = 32;
    sky.radiance.assign(size_t(sky.width) * sky.height, radiance);
    return sky;
}

demos::Mesh shiningBoxes(const std::vector<Box>& boxes, const glm::vec3& radiance) {
    demos::Mesh mesh;
    demos::MeshMaterial material;
    material.baseColor = glm::vec4(0, 0, 0, 1);
    material.emissive = radiance;
    mesh.materials.push_back(material);
    for (const Box& box : boxes)
        for (int axis = 0; axis < 3; ++axis)
            for (const bool upper : {false, true}) {
                const int next = (axis + 1) % 3, other = (axis + 2) % 3;
                const auto first = static_cast<uint32_t>(mesh.vertices.size());
                for (int corner = 0; corner < 4; ++corner) {
                    glm::dvec3 p = box.low;
                    if (upper) p[axis] = box.high[axis];
                    if (corner == 1 || corner == 2) p[next] = box.high[next];
                    if (corner >= 2) p[other] = box.high[other];
                    demos::MeshVertex vertex{};
                    vertex.position = glm::vec3(p);
                    vertex.normal[axis] = upper ? 1.0f : -1.0f;
                    for (uint16_t& channel : vertex.color) channel = 65535;
                    mesh.vertices.push_back(vertex);
                }
                // Counter-clockwise from outside.
                const uint32_t a = upper ? 1 : 2, b = upper ? 2 : 1;
                for (const uint32_t i : {0u, a, b}) mesh.indices.push_back(first + i);
                for (const uint32_t i : {0u, upper ? 2u : 3u, upper ? 3u : 2u})
                    mesh.indices.push_back(first + i);
            }
    mesh.parts.push_back(
        {0, static_cast<uint32_t>(mesh.indices.size()), 0, glm::vec3(-1e3f), glm::vec3(1e3f)});
    return mesh;
}

bool lightWorld(const glm::vec3& sky, demos::reference::World& out) {
    demos::SunDesc sun;
    sun.irradiance = {0, 0, 0};
    demos::Error error;
    const bool made = demos::reference::makeLight(evenSky(sky), {}, sun, out.light, error);
    EXPECT_TRUE(made) << error.text;
    return made;
}

void addMesh(const std::string& name, demos::Mesh mesh, demos::reference::World& out) {
    const auto entry = out.models.emplace(name, demos::reference::Model(std::move(mesh))).first;
    out.instances.push_back({&entry->second, {}});
}

demos::reference::FrameDesc smallFrame() {
    demos::reference::FrameDesc frame;
    frame.width = 80;
    frame.height = 45;
    frame.camera.name = "test";
    frame.camera.positionM = {0, 2, 6};
    frame.camera.targetM = {0, 0.8, -6};
    frame.camera.verticalFovDeg = 50;
    frame.camera.nearM = 0.1;
    return frame;
}

} // namespace tests
