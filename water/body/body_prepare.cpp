// The pipelines that a body will ask a target for, made ahead of its first draw.
#include <cstdint>

#include "gpu/view/encoding.h"
#include "water/body/body.h"
#include "water/body/target.h"

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

Status Body::prepare(Target& target, const ViewDesc* view, const LightingDesc* lighting,
                     SurfaceOutput output) const {
    LightingDesc usual;
    // Asked for nothing but whether it is there.
    usual.skyCube = reinterpret_cast<VkImageView>(uintptr_t{1});
    PrepareCall call = {target, view, lighting ? *lighting : usual, output};
    // Of scene and target alike, unless a view says otherwise.
    call.sceneIsEncoded = view ? isEncoded(view->sceneColor) : target.desc.encoding == Encoding::srgb;
    for (const auto& [part, state] : has)
        if (part->prepare)
            if (const Status s = part->prepare(state.get(), *this, call); s != Status::ok) return s;
    return Status::ok;
}

} // namespace seaglass
