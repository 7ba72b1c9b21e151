// Edge stretch (Genin 2017, of Ghost Recon Wildlands): seen from above, columns of the picture spread towards
// the eye, and what the plane mirrors near a side border lies beyond it. Reflections near the border are
// stretched outwards over what is missing.
#pragma once

#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"

namespace seaglass {

struct StretchKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

constexpr uint32_t stretchDispatches = 1;

/// Both images come and go as techniques leave them.
Status recordStretch(const ReflectPass& pass, const StretchKernel& stretch, const OwnedReflection& images);

} // namespace seaglass
