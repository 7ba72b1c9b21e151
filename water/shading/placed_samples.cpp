#include "water/shading/placed_samples.h"

#include "spirv/placed_samples.frag.h"

namespace seaglass {

PlacedSamplesVariant placedSamplesVariant(const SurfaceVariant& all) {
    SurfaceVariant v = shapeVariant(all);
    v.surfaceOutput = all.surfaceOutput;
    return {v};
}

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const PlacedSamplesVariant& variant,
                     DrawPipeline& out) {
    return buildMeshPipeline(device, target, placed_samples_frag, variant.surface, "placed samples pipeline",
                             out);
}

} // namespace seaglass
