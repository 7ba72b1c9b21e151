#include "scene.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace {

using Vertices = std::vector<Vertex>;

void addTriangle(Vertices& out, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 color) {
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const glm::vec3 corner : {a, b, c}) out.push_back({corner, normal, color});
}

/// Corners counter-clockwise, seen from where it faces.
void addQuad(Vertices& out, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, glm::vec3 color) {
    addTriangle(out, a, b, c, color);
    addTriangle(out, a, c, d, color);
}

void addBox(Vertices& out, glm::vec3 low, glm::vec3 high, glm::vec3 color) {
    const auto corner = [&](int x, int y, int z) {
        return glm::vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    addQuad(out, corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), color);
    addQuad(out, corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0), color);
    addQuad(out, corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0), color);
    addQuad(out, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1), color);
    addQuad(out, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1), color);
    addQuad(out, corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), color);
}

/// A ring of a body of revolution, from (radius, height) `low` to `high`.
void addRing(Vertices& out, glm::vec3 foot, glm::vec2 low, glm::vec2 high, glm::vec3 color) {
    constexpr int sides = 32;
    const auto at = [&](int side, glm::vec2 profile) {
        const float angle = 6.2831853f * static_cast<float>(side) / sides;
        return foot + glm::vec3(profile.x * std::cos(angle), profile.y, -profile.x * std::sin(angle));
    };
    for (int side = 0; side < sides; ++side) {
        addTriangle(out, at(side, low), at(side + 1, low), at(side, high), color);
        if (high.x > 0) addTriangle(out, at(side + 1, low), at(side + 1, high), at(side, high), color);
    }
}

/// Of the ground: a beach that rises behind the cove, a point of land to the left, and a bed 3 m down.
float groundHeight(float x, float z) {
    const float beach = -z - 26 - 4 * std::sin(x / 9) - 0.01f * x * x;
    const float point = 9 - std::hypot((x + 15) / 1.3f, z + 21);
    const float inland = std::fmax(beach, point);
    const float dunes = 0.35f * std::sin(x / 3.1f) * std::sin(z / 2.3f + x / 7);
    const float height =
        inland < 0 ? std::fmax(0.2f * inland, -3.0f) : 2.5f * (1 - std::exp(-0.12f * inland));
    return height + dunes * glm::smoothstep(-6.0f, 6.0f, inland) * 0.8f;
}

Vertices buildGround() {
    constexpr float step = 0.75f;
    const auto at = [](int i, int j) {
        const float x = step * static_cast<float>(i), z = step * static_cast<float>(j);
        return glm::vec3(x, groundHeight(x, z), z);
    };
    const auto colorAt = [](glm::vec3 p) {
        const glm::vec3 sand(0.72f, 0.6f, 0.42f), grass(0.28f, 0.42f, 0.16f);
        return glm::mix(sand, grass, glm::smoothstep(0.7f, 1.3f, p.y));
    };
    Vertices out;
    for (int i = -80; i < 80; ++i)
        for (int j = -80; j < 16; ++j)
            addQuad(out, at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), at(i, j), colorAt(at(i, j)));
    return out;
}

Vertices buildLighthouse() {
    const glm::vec3 foot(-14, 1.2f, -21), white(0.88f, 0.87f, 0.84f), red(0.68f, 0.1f, 0.07f);
    const glm::vec2 profile[] = {{1.8f, 0},    {1.65f, 2},   {1.5f, 4},    {1.35f, 6}, {1.2f, 8},
                                 {1.7f, 8.4f}, {0.9f, 8.4f}, {0.9f, 9.8f}, {0, 10.9f}};
    Vertices out;
    for (int i = 0; i < 8; ++i) addRing(out, foot, profile[i], profile[i + 1], i % 2 ? red : white);
    return out;
}

Vertices buildJetty() {
    const glm::vec3 plank(0.45f, 0.31f, 0.19f), post(0.3f, 0.2f, 0.13f);
    Vertices out;
    for (float z = -30; z < -9; z += 0.5f) addBox(out, {4.2f, 0.8f, z}, {6.2f, 0.9f, z + 0.44f}, plank);
    for (float z = -28; z < -8; z += 3)
        for (const float x : {4.1f, 6.1f}) addBox(out, {x, -3.2f, z}, {x + 0.2f, 1.4f, z + 0.2f}, post);
    return out;
}

} // namespace

Camera lookAtCove(float aspect) {
    Camera camera;
    camera.view = glm::lookAt(glm::vec3(-1, 2.2f, 6), glm::vec3(-3, 1.6f, -14), glm::vec3(0, 1, 0));
    camera.projection = glm::perspective(glm::radians(50.0f), aspect, 0.1f, 500.0f);
    camera.projection[1][1] *= -1; // GLM's y is up, Vulkan's down
    return camera;
}

std::vector<std::vector<Vertex>> buildTriangle() {
    const glm::vec3 facing(0, 0, 1);
    return {{{{-9, 0.5f, -14}, facing, {1, 0.1f, 0.1f}},
             {{-1, 0.5f, -14}, facing, {0.1f, 1, 0.1f}},
             {{-5, 6.5f, -14}, facing, {0.1f, 0.1f, 1}}}};
}

std::vector<std::vector<Vertex>> buildCove() {
    return {buildGround(), buildLighthouse(), buildJetty()};
}
