// Where the frame before showed things: what a surface's motion is drawn by.
#pragma once

#include <map>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gpu/view/view.h"

namespace seaglass {

class LastViews {
  public:
    /// The last frame's pixels of points relative to this frame's eye; this frame is the next one's last.
    glm::mat4 pixelFromRelative(const ViewDesc& view, const ViewGeometry& geometry);

  private:
    struct LastView {
        glm::dmat4 pixelFromRelative{1};
        glm::dvec3 eye{0};
        glm::dvec2 jitter{0}; ///< [pixel]
    };
    std::map<uint32_t, LastView> views_; ///< by index, of those that motion was drawn of
};

} // namespace seaglass
