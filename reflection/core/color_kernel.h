// A kernel that reads the scene's colour, linear or as displays take it.
#pragma once

#include <span>

#include "gpu/pipeline/kernel.h"
#include "gpu/view/encoding.h"

namespace seaglass {

/// Its constants are those of shaders/shared/scene_constants.h. That for encoded scenes is made when the
/// first comes.
class ColorKernel {
  public:
    /// `spirv` stays.
    Status create(Context& context, std::span<const uint32_t> spirv, const char* what);
    Status of(const Context& context, const Image& sceneColor, const gpu::Kernel*& out);

  private:
    std::span<const uint32_t> spirv_;
    const char* what_ = nullptr;
    gpu::Kernel linear_, encoded_;
    bool hasEncoded_ = false;
};

} // namespace seaglass
