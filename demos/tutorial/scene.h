// What is drawn, in metres, y up: the triangle that every renderer begins with, or a cove with a lighthouse
// and a jetty.
#pragma once

#include <vector>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

struct Vertex {
    glm::vec3 position, normal, color;
};

/// Near and far plane at 0.1 and 500 m.
struct Camera {
    glm::mat4 view, projection;
};

const glm::vec3 toSun = glm::normalize(glm::vec3(0.55f, 0.5f, 0.45f));
const glm::vec3 sunLight(0.62f, 0.56f, 0.48f); ///< that a white surface facing the sun sends back
const glm::vec3 skyLight(0.26f, 0.31f, 0.38f); ///< the same of the sky, for one that faces up

const glm::vec3 haze(0.4f, 0.5f, 0.6f); ///< of the sky at the horizon, seen

Camera lookAtCove(float aspect);
std::vector<std::vector<Vertex>> buildTriangle();
std::vector<std::vector<Vertex>> buildCove();
