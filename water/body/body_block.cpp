#include "water/body/body_block.h"

#include <glm/geometric.hpp>

#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"

namespace seaglass {

BodyBlock bodyBlock(const Body& body, const BodyView& view) {
    const ViewGeometry& geometry = view.geometry;
    BodyBlock block{};
    block.clipFromRelative = glm::mat4(geometry.clipFromRelative);
    block.pixelFromRelative = glm::mat4(geometry.pixelFromRelative);
    block.relativeFromPixel = glm::mat4(relativeFromScenePixel(geometry));
    block.worldFromBody = glm::mat3x4(body.frame.worldFromBody);
    block.plane = glm::vec4(glm::vec3(body.plane), body.heightOf(geometry.eye));
    block.sight = geometry.parallel ? glm::vec4(glm::vec3(geometry.sight), 0) : glm::vec4(0, 0, 0, 1);
    block.sceneShift = glm::vec2(geometry.sceneShift);
    block.region = glm::ivec4(geometry.regionOrigin, geometry.regionSize);
    block.farDepth = static_cast<float>(geometry.farDepth);
    block.depthSign = geometry.reversedDepth ? 1.0f : -1.0f;
    for (const auto& [part, state] : body.has)
        if (part->fill) part->fill(state.get(), body, view, block);
    return block;
}

Status bindBody(Body& body, const BodyView& view, const BodyBlock& block, Resources& out) {
    gpu::Slice slice;
    if (const Status s = body.context->frame().upload(block, slice); s != Status::ok) return s;
    out.reserve(32);
    out.push_back({bodyBinding, gpu::uniformBuffer(slice)});
    for (const auto& [part, state] : body.has)
        if (part->bind)
            if (const Status s = part->bind(state.get(), body, view, out); s != Status::ok) return s;
    return Status::ok;
}

Status bindBody(Body& body, const BodyView& view, Resources& out) {
    return bindBody(body, view, bodyBlock(body, view), out);
}

} // namespace seaglass
