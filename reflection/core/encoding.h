// Colour that a host holds as displays take it: which of its images do, and the kernels that read them.
#pragma once

#include <span>

#include "gpu/context.h"
#include "gpu/pipeline/kernel.h"

namespace seaglass {

/// Formats that are decoded when sampled and encoded when written.
bool appliesSrgb(VkFormat format);

/// UNORM formats that hold what displays take, unless somebody says otherwise.
bool isDisplayFormat(VkFormat format);

inline bool isEncoded(const Image& image) {
    return image.encoding == Encoding::srgb;
}

/// Once a context, of a scene whose format makes linear unlikely, and where no target was told of.
void tellUnspecified(Context& context, const Image& sceneColor);

/// A kernel that reads the scene's colour, whose constants are those of shaders/shared/scene_constants.h.
/// That for encoded scenes is made when the first comes.
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
