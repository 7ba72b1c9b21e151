// Edge reach: what a mirrored ray leaves the picture in front of is taken to go on beyond the border, as the
// plane that it is inside.
#pragma once

#include "reflection/core/color_kernel.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"
#include "reflection/march/open_tiles.h"

namespace seaglass {

struct EdgeReachKernel {
    SeenColumnsKernel columns;
    ColorKernel kernel;
    Status create(Context& context);
};

constexpr uint32_t edgeReachDispatches = 2;

/// Both images come and go as techniques leave them. `tiles` tell where the plane is seen, and list columns
/// afterwards.
Status recordEdgeReach(const ReflectPass& pass, EdgeReachKernel& reach, const gpu::Buffer& tiles,
                       const OwnedReflection& images);

} // namespace seaglass
