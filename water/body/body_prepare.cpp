// The pipelines that a body will ask a target for, made ahead of its first draw.
#include <cstdint>

#include "gpu/view/encoding.h"
#include "water/below/underwater_part.h"
#include "water/body/body.h"
#include "water/body/target.h"
#include "water/deferred/deferred_part.h"

namespace seaglass {

SurfaceDraw drawnAhead(const PrepareCall& call) {
    return {.output = call.output,
            .seesScene = !call.view || hasScene(*call.view),
            .sceneIsEncoded = call.sceneIsEncoded,
            .manySamples = call.view && isMultisampled(*call.view),
            .isAhead = true,
            .view = call.view,
            .lighting = &call.lighting};
}

Status Body::prepareSurface(const PrepareCall& call) const {
    if (find<DeferredPart>()) return Status::ok; // which prepares its own
    SurfaceDraw drawn = drawnAhead(call);
    const auto prepared = [&](SidesSeen sides) {
        drawn.sides = sides;
        const DrawPipeline* pipeline = nullptr;
        return call.target.pipelines.get(surfaceVariant(drawn), pipeline);
    };
    if (const Status s = prepared(SidesSeen::above); s != Status::ok) return s;
    if (!find<UnderwaterPart>() || drawn.isMotion()) return Status::ok;
    if (const Status s = prepared(SidesSeen::below); s != Status::ok) return s;
    return prepared(SidesSeen::either);
}

Status Body::prepare(Target& target, const ViewDesc* view, const LightingDesc* lighting,
                     SurfaceOutput output) const {
    LightingDesc usual;
    // Asked for nothing but whether it is there.
    usual.skyCube = reinterpret_cast<VkImageView>(uintptr_t{1});
    PrepareCall call = {target, view, lighting ? *lighting : usual, output};
    // Of scene and target alike, unless a view says otherwise.
    call.sceneIsEncoded = view ? isEncoded(view->sceneColor) : target.desc.encoding == Encoding::srgb;
    if (const Status s = prepareSurface(call); s != Status::ok) return s;
    for (const auto& [part, state] : has)
        if (part->prepare)
            if (const Status s = part->prepare(state.get(), *this, call); s != Status::ok) return s;
    return Status::ok;
}

} // namespace seaglass
