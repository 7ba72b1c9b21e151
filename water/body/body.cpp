#include "water/body/body.h"

#include <cmath>

#include "gpu/view/plane.h"
#include "water/body/body_desc.h"
#include "water/sea/sea_desc.h"
#include "water/spectrum/spectrum.h"

namespace seaglass {

namespace {

/// Whether a bottom would take much of the wind sea's energy that its model leaves there. What a table says
/// was measured over it.
bool isTooHighForItsDepth(const SeaDesc& desc) {
    constexpr double much = 0.1;
    if (desc.spectrum == SpectrumModel::tma || desc.spectrum == SpectrumModel::table) return false;
    if (!(desc.windSpeed > 0) || !(desc.depth > 0) || !std::isfinite(desc.depth)) return false;
    return kitaigorodskii(makeSpectrum(desc).peak, double{desc.depth}) < 1 - much;
}

} // namespace

Status seaOf(const gpu::Device& device, const BodyDesc& desc, SeaPointer& out) {
    out.reset();
    if (!desc.waves) return Status::ok;
    SeaError error;
    SeaPointer made(createSea(desc.waves, &error));
    if (!made) {
        // What is as it should be has failed for want of memory.
        SeaError none;
        const Status status = validate(*desc.waves, none) ? Status::outOfHostMemory : Status::invalidArgument;
        return device.fail(status, "BodyDesc.waves: %s", error.text);
    }
    if (cascadeCount(*made) > 0) out = std::move(made);
    return Status::ok;
}

Status Body::create(Context& owner, const BodyDesc& desc) {
    context = &owner;
    const gpu::Device& device = owner.device;
    if (const FieldError bad = badField(desc)) return device.fail(Status::invalidArgument, "%s", bad.text());
    if (const char* bad = readPlane(desc.plane, plane))
        return device.fail(Status::invalidArgument, "%s", bad);
    frame = BodyFrame::of(glm::dvec3(plane));
    plane = {0, 1, 0, plane.w};
    shading = desc.shading;
    keepsMotion = desc.motion;
    if (const Status s = seaOf(device, desc, sea); s != Status::ok) return s;
    if (sea && isTooHighForItsDepth(*desc.waves))
        device.warn("BodyDesc.waves: SeaDesc.depth of %.3g m slows these waves and leaves them as high as "
                    "over deep water; SpectrumModel::tma lowers them too",
                    double{desc.waves->depth});
    if (const Status s = placing.create(owner, desc, sea.get(), -plane.w); s != Status::ok) return s;
    for (const Part& part : parts()) {
        if (!part.wanted(desc, sea.get())) continue;
        PartOfBody& made = has.emplace_back(PartOfBody{&part, nullptr});
        if (const Status s = part.create(*this, desc, made.state); s != Status::ok) return s;
    }
    return Status::ok;
}

Status Body::simulate(VkCommandBuffer commands, double time) {
    if (!std::isfinite(time))
        return context->device.fail(Status::invalidArgument, "simulate: time is not finite");
    if (!sea) return Status::ok;
    if (simulatedIn == context->frameNumber)
        return context->device.misused("simulate: it was called for the body in this frame before");
    if (drawnIn == context->frameNumber)
        return context->device.misused("simulate: the body was drawn in this frame before");
    simulatedIn = context->frameNumber;
    simulatedTime = time;
    for (const auto& [part, state] : has)
        if (part->simulate)
            if (const Status s = part->simulate(state.get(), *this, commands, time); s != Status::ok)
                return s;
    return Status::ok;
}

Status Body::reflect(VkCommandBuffer commands, SceneOfCall& scene) {
    for (const auto& [part, state] : has)
        if (part->reflect)
            if (const Status s = part->reflect(state.get(), *this, commands, scene); s != Status::ok)
                return s;
    return Status::ok;
}

} // namespace seaglass
