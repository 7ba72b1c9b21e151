#include "water/shore/shore_part.h"

#include <numbers>

#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"

namespace seaglass {

bool ShorePart::wanted(const BodyDesc&, const Sea* sea) {
    return sea && sea->shore;
}

Status ShorePart::addCost(const AskedBody& asked, Estimate& sum) {
    sum.bytes += ShoreMap::bytes(asked.context.device, *asked.sea->shore);
    return Status::ok;
}

Status ShorePart::create(Body& body, const BodyDesc& desc) {
    if (desc.foam) decayTime = double{desc.foam->decayTime};
    return map.create(*body.context, *body.sea->shore);
}

Status ShorePart::simulate(Body& body, VkCommandBuffer commands, double time) {
    map.record(body.context->device, commands, *body.sea->shore, time, decayTime);
    return Status::ok;
}

void ShorePart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    const Shore& shore = *body.sea->shore;
    const glm::dvec3& eye = view.geometry.eye;
    const ShoreSignal& signal = map.signal();
    const double spacing = shore.spacing();
    const glm::dvec2 samples(shore.samples()[0], shore.samples()[1]);
    const glm::dvec2 fromFirst =
        (glm::dvec2(eye.x, eye.z) - glm::dvec2(shore.origin()[0], shore.origin()[1])) / spacing;
    block.shorePlace = glm::vec4((fromFirst + 0.5) / samples, 1.0 / (samples * spacing));
    block.shoreSignal = {signal.rowsPerSecond, signal.offset, signal.count, spacing};
    block.shoreForm = {shore.peak() / (2 * std::numbers::pi), shore.carried(), map.last().offset,
                       signal.foamFades};
}

void ShorePart::vary(const Body&, const SurfaceDraw&, SurfaceVariant& variant) const {
    variant.hasShore = true;
}

Status ShorePart::uploadRows(Context& context, bool move) {
    if (rowsOf == context.frameNumber && (rowsMove || !move)) return Status::ok;
    const auto& now = map.signal().rows;
    const Status s = move ? context.frame().uploadInRow(rows, now, map.last().rows)
                          : context.frame().uploadInRow(rows, now);
    if (s != Status::ok) return s;
    rowsOf = context.frameNumber;
    rowsMove = move;
    return Status::ok;
}

Status ShorePart::bind(Body& body, const BodyView& view, Resources& out) {
    Context& context = *body.context;
    if (const Status s = uploadRows(context, view.surface && view.surface->isMotion()); s != Status::ok)
        return s;
    out.push_back({shoreMapBinding, gpu::sampledImage(context.samplers.trilinearClamp(), map.view())});
    out.push_back({shoreSignalBinding, rows});
    return Status::ok;
}

Part shorePart() {
    return partFrom<ShorePart>();
}

} // namespace seaglass
