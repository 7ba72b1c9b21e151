#include "water/deferred/placed_samples.h"

#include "spirv/placed_samples.frag.h"

namespace seaglass {

PlacedSamplesVariant placedSamplesVariant(const SurfaceVariant& all) {
    PlacedSamplesVariant v = {foundVariant(all).surface};
    v.surface.hasRefraction = v.surface.manySamples = false;
    return v;
}

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const PlacedSamplesVariant& variant,
                     DrawPipeline& out) {
    return buildMeshPipeline(device, target, placed_samples_frag, variant.surface, "placed samples pipeline",
                             out);
}

} // namespace seaglass
