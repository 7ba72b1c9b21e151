// Colour that a host holds as displays take it: which of its images do.
#pragma once

#include "gpu/context.h"

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

} // namespace seaglass
