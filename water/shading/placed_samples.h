// What was shaded of a surface, placed in a multisampled pass by its mesh.
#pragma once

#include "water/shading/found_surface.h"

namespace seaglass {

struct PlacedSamplesVariant {
    SurfaceVariant surface;
    auto operator<=>(const PlacedSamplesVariant&) const = default;
};
/// What placing it depends on.
PlacedSamplesVariant placedSamplesVariant(const SurfaceVariant& all);
Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const PlacedSamplesVariant& variant,
                     DrawPipeline& out);

using PlacedSamplesPipelines = DrawPipelines<PlacedSamplesVariant>;

} // namespace seaglass
