// What is drawn over a whole view. For an eye in the water: the water before the opaque scene, drawn before
// any surface, and the line where the near plane leaves it, drawn after. For any: caustics on what lies
// below, and surfaces that are shaded already.
#pragma once

#include <span>

#include "gpu/context.h"
#include "gpu/frame.h"
#include "gpu/pipeline/constants.h"
#include "shaders/shared/below/marine_snow_lattice.h"
#include "water/body/draw_pipeline.h"

namespace seaglass {

/// What drifts before an eye in the water.
constexpr uint32_t snowParticles = snowSizes * snowCellsAcross * snowCellsAcross * snowCellsAcross;

enum class ViewPass : uint32_t { water, waterline, caustics, surface, shafts, snow };

struct ViewPassVariant {
    ViewPass pass = ViewPass::water;
#define CONSTANTS "shaders/shared/below/view_pass_constants.h"
#include "gpu/pipeline/constants.inl"
    auto operator<=>(const ViewPassVariant&) const = default;
};

using ViewPassPipelines = DrawPipelines<ViewPassVariant>;
Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const ViewPassVariant& variant,
                     DrawPipeline& out);

/// Makes a variant's pipeline ahead of its first draw.
Status prepareViewPass(ViewPassPipelines& pipelines, const ViewPassVariant& variant);

/// `resources`: all that the variant's shaders read.
Status recordViewPass(Context& context, const DrawCall& call, const BodyView& view,
                      const ViewPassVariant& variant, std::span<const gpu::Bound> resources);

} // namespace seaglass
