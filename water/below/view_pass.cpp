#include "water/below/view_pass.h"

#include "spirv/caustics.frag.h"
#include "spirv/caustics.vert.h"
#include "spirv/marine_snow.frag.h"
#include "spirv/marine_snow.vert.h"
#include "spirv/placed_surface.frag.h"
#include "spirv/underwater.frag.h"
#include "spirv/underwater.vert.h"
#include "spirv/waterline.frag.h"
#include "water/body/part.h"
#include "water/body/target.h"

namespace seaglass {

namespace {

struct PassInfo {
    const char* name;
    std::span<const uint32_t> vertex, fragment;
    Drawing drawing;
    uint32_t triangles = 1;
};

PassInfo infoOf(ViewPass pass) {
    switch (pass) {
    case ViewPass::water:
        return {"underwater", underwater_vert, underwater_frag, Drawing::over};
    case ViewPass::waterline:
        return {"waterline", underwater_vert, waterline_frag, Drawing::blended};
    case ViewPass::surface:
        return {"placed_surface", underwater_vert, placed_surface_frag, Drawing::solid};
    case ViewPass::shafts:
        return {"shafts", underwater_vert, underwater_frag, Drawing::added};
    case ViewPass::snow:
        return {"marine_snow", marine_snow_vert, marine_snow_frag, Drawing::floating, snowParticles};
    case ViewPass::caustics:
        break;
    }
    return {"caustics", caustics_vert, caustics_frag, Drawing::scaled};
}

} // namespace

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const ViewPassVariant& variant,
                     DrawPipeline& out) {
    ViewPassVariant drawn = variant;
    drawn.ofShafts = variant.pass == ViewPass::shafts;
    drawn.inViews = target.viewMask != 0;
    drawn.targetIsEncoded = target.encoding == Encoding::srgb;
    const PassInfo info = infoOf(variant.pass);
    return createDrawPipeline(device, target, {info.vertex, info.fragment, drawn.constants()}, info.drawing,
                              "view pass pipeline", out);
}

Status prepareViewPass(ViewPassPipelines& pipelines, const ViewPassVariant& variant) {
    const DrawPipeline* pipeline = nullptr;
    return pipelines.get(variant, pipeline);
}

Status recordViewPass(Context& context, const DrawCall& call, const BodyView& view,
                      const ViewPassVariant& variant, std::span<const gpu::Bound> resources) {
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = call.target.viewPasses.get(variant, pipeline); s != Status::ok) return s;
    const PassInfo info = infoOf(variant.pass);
    return recordTriangles(context, call, view, *pipeline, info.name, info.triangles, resources);
}

} // namespace seaglass
