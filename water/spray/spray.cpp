#include "water/spray/spray.h"

#include "spirv/spray.frag.h"
#include "spirv/spray.vert.h"
#include "water/body/part.h"
#include "water/body/target.h"

namespace seaglass {

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const SprayVariant& variant,
                     DrawPipeline& out) {
    SprayVariant drawn = variant;
    drawn.inViews = target.viewMask != 0;
    drawn.targetIsEncoded = target.encoding == Encoding::srgb;
    return createDrawPipeline(device, target, {spray_vert, spray_frag, drawn.constants()}, Drawing::floating,
                              "spray pipeline", out);
}

Status recordSpray(Context& context, const DrawCall& call, const BodyView& view, const SprayVariant& variant,
                   uint32_t particles, std::span<const gpu::Bound> resources) {
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = call.target.spray.get(variant, pipeline); s != Status::ok) return s;
    return recordTriangles(context, call, view, *pipeline, "spray", particles, resources);
}

} // namespace seaglass
