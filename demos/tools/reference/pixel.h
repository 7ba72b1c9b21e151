// What a pixel gathers, sample by sample.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

/// Samples that fall on water count by the area of the facets they met, but together no more than their
/// number.
class PixelSum {
  public:
    /// Number `sample` of FrameDesc::samples, each once and in turn.
    void add(const Frame& frame, uint32_t x, uint32_t y, uint32_t sample);
    /// Of those that were added, linear.
    glm::vec3 mean() const;

  private:
    glm::vec3 sum_{0}, waterSum_{0};
    float waterWeight_ = 0;
    uint32_t waterCount_ = 0, count_ = 0;
};

} // namespace demos::reference
