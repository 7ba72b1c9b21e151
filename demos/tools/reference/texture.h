// Textures of the CPU meshes as a GPU filters them: linear light, halved levels, trilinear.
#pragma once

#include <vector>

#include "host/files/mesh_file.h"

namespace demos::reference {

class Texture {
  public:
    explicit Texture(const MeshTexture& source);

    /// `right` and `below` are what uv changes by to the next pixels.
    glm::vec4 sample(const glm::vec2& uv, const glm::vec2& right, const glm::vec2& below) const;

  private:
    struct Level {
        uint32_t width = 0, height = 0;
        std::vector<glm::vec4> texels;
    };
    glm::vec4 bilinear(const Level& level, const glm::vec2& uv) const;
    glm::vec4 nearest(const Level& level, const glm::vec2& uv) const;

    Wrap wrapU_, wrapV_;
    Filter larger_, smaller_;
    Mips mips_;
    std::vector<Level> levels_;
};

} // namespace demos::reference
