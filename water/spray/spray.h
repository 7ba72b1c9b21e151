// Draws spray: drops that wind tears off breaking crests, as particles whose places are a function of the
// waves and the time alone.
#pragma once

#include <span>

#include "gpu/context.h"
#include "gpu/frame.h"
#include "gpu/pipeline/constants.h"
#include "water/body/draw_pipeline.h"

namespace seaglass {

struct SprayVariant {
#define CONSTANTS "shaders/shared/spray/spray_constants.h"
#include "gpu/pipeline/constants.inl"
    auto operator<=>(const SprayVariant&) const = default;
};

using SprayPipelines = DrawPipelines<SprayVariant>;
Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const SprayVariant& variant,
                     DrawPipeline& out);

/// `resources`: all that the variant's shaders read.
Status recordSpray(Context& context, const DrawCall& call, const BodyView& view, const SprayVariant& variant,
                   uint32_t particles, std::span<const gpu::Bound> resources);

} // namespace seaglass
