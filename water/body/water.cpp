// The calls of seaglass/water.h: what they are handed is checked, then bodies record one after the other.
#include "gpu/guard.h"
#include "reflection/interface/fields/reflection.h"
#include "water/below/bed_part.h"
#include "water/below/caustics_part.h"
#include "water/body/body.h"
#include "water/body/body_desc.h"
#include "water/body/target.h"
#include "water/reflection/reflection_part.h"
#include "water/shading/shading_part.h"

namespace seaglass {

Status createBody(Context* context, const BodyDesc* desc, Body** out) {
    return gpu::createHeld("createBody", context, desc, out,
                           [&](Body& body) { return body.create(*context, *desc); });
}

Status estimate(Context* context, const BodyDesc* desc, VkExtent2D extent, Estimate* out,
                SceneSamples samples) {
    if (const Status s =
            gpu::refuseNull(context, "estimate", {{"context", !context}, {"desc", !desc}, {"out", !out}});
        s != Status::ok)
        return s;
    *out = {};
    if (const FieldError bad = badField(*desc))
        return context->device.fail(Status::invalidArgument, "%s", bad.text());
    if (const FieldError bad = badField(sceneSampleFields, &samples))
        return context->device.fail(Status::invalidArgument, "estimate: %s", bad.text());
    if (const Status s = gpu::refuseExtent(*context, extent); s != Status::ok) return s;
    return gpu::guarded([&] {
        SeaPointer sea;
        if (const Status s = seaOf(context->device, *desc, sea); s != Status::ok) return s;
        const AskedBody asked = {*context, *desc, sea.get(), extent, samples};
        Estimate sum;
        for (const Part& part : parts())
            if (part.addCost && part.wanted(*desc, sea.get()))
                if (const Status s = part.addCost(asked, sum); s != Status::ok) return s;
        *out = sum;
        return Status::ok;
    });
}

void destroyBody(Body* body) {
    gpu::destroyHeld("destroyBody", body);
}

Status setExclusionVolumes(Body* body, const ExclusionVolume* volumes, uint32_t count) {
    if (!body) return Status::invalidArgument;
    return gpu::guarded([&] {
        if (const char* bad = readExclusionVolumes(volumes, count, body->exclusionVolumes))
            return body->context->device.fail(Status::invalidArgument, "%s", bad);
        for (ExclusionPlanes& volume : body->exclusionVolumes) volume = body->frame.fromWorld(volume);
        return Status::ok;
    });
}

namespace {

template<typename Each>
Status forEach(Body* const* bodies, uint32_t count, Each&& each) {
    return gpu::guarded([&] {
        for (uint32_t i = 0; i < count; ++i)
            if (const Status s = each(*bodies[i]); s != Status::ok) return s;
        return Status::ok;
    });
}

/// What calls that record for bodies are handed. `context`: where there may be one and no body.
Status refuseUnusable(const char* call, const Context* context, VkCommandBuffer commands, Body* const* bodies,
                      uint32_t count, std::initializer_list<gpu::Argument> more) {
    if (!context) context = gpu::contextOf(bodies, count);
    if (const Status s =
            gpu::refuseNull(context, call, {{"commands", !commands}, {"bodies", count && !bodies}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseNull(context, call, more); s != Status::ok) return s;
    return gpu::refuseUnusable(call, "bodies", bodies, count);
}

/// A call that one part records, outside any render pass. `record` is for bodies that have it.
template<class PartOf, typename... More>
Status recordParts(const char* call, VkCommandBuffer commands, Body* const* bodies, uint32_t count,
                   const ViewDesc* view, const LightingDesc* lighting,
                   Status (PartOf::*record)(Body&, VkCommandBuffer, const ViewDesc&, const LightingDesc&,
                                            More...),
                   More... more) {
    if (const Status s = refuseUnusable(call, nullptr, commands, bodies, count,
                                        {{"view", !view}, {"lighting", !lighting}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(gpu::contextOf(bodies, count), call); s != Status::ok)
        return s;
    return forEach(bodies, count, [&](Body& body) {
        PartOf* part = body.find<PartOf>();
        return part ? (part->*record)(body, commands, *view, *lighting, more...) : Status::ok;
    });
}

/// What calls that draw are handed.
Status refuseDraw(const char* call, VkCommandBuffer commands, const Target* target, Body* const* bodies,
                  uint32_t count, const ViewDesc* view, const LightingDesc* lighting) {
    if (const Status s = refuseUnusable(call, target ? target->context : nullptr, commands, bodies, count,
                                        {{"target", !target}, {"view", !view}, {"lighting", !lighting}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed(call, "target", *target); s != Status::ok) return s;
    const gpu::Device& device = target->context->device;
    for (uint32_t i = 0; i < count; ++i)
        if (bodies[i]->context != target->context)
            return device.fail(Status::invalidArgument,
                               "%s: bodies[%u] and the target are of different contexts", call, i);
    const uint32_t mask = target->desc.viewMask;
    if (mask && !(view->viewIndex < maxViews && (mask >> view->viewIndex & 1u)))
        return device.fail(Status::invalidArgument,
                           "%s: ViewDesc.viewIndex is %u, which is none of "
                           "TargetDesc.viewMask",
                           call, view->viewIndex);
    return gpu::refuseOutsideFrame(target->context, call);
}

/// A host's number may be any. Without a body nobody hears of it.
Status refuseOutput(const char* call, const Context* context, SurfaceOutput output) {
    constexpr auto last = static_cast<uint32_t>(SurfaceOutput::motion);
    const auto number = static_cast<uint32_t>(output);
    if (number <= last || !context) return Status::ok;
    return context->device.fail(Status::invalidArgument, "%s: output is %u, expected 0 to %u", call, number,
                                last);
}

} // namespace

Status simulate(VkCommandBuffer commands, Body* const* bodies, uint32_t count, double time) {
    if (const Status s = refuseUnusable("simulate", nullptr, commands, bodies, count, {}); s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(gpu::contextOf(bodies, count), "simulate"); s != Status::ok)
        return s;
    return forEach(bodies, count, [&](Body& body) { return body.simulate(commands, time); });
}

Status planarView(Body* body, const ViewDesc* view, PlanarView* out) {
    if (const Status s = gpu::refuseNull(gpu::contextOf(&body, 1), "planarView",
                                         {{"body", !body}, {"view", !view}, {"out", !out}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("planarView", "body", *body); s != Status::ok) return s;
    ReflectionPart* reflection = body->find<ReflectionPart>();
    if (!reflection)
        return body->context->device.fail(Status::invalidArgument,
                                          "planarView: the body's reflection is the sky alone");
    reflection->aim(*body, *view);
    return planarView(reflection->reflector.get(), view, out);
}

Status recordOverlay(VkCommandBuffer commands, Body* body, const ViewDesc* view, const OverlayDesc* desc) {
    if (const Status s =
            gpu::refuseNull(gpu::contextOf(&body, 1), "recordOverlay",
                            {{"commands", !commands}, {"body", !body}, {"view", !view}, {"desc", !desc}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("recordOverlay", "body", *body); s != Status::ok) return s;
    const ReflectionPart* reflection = body->find<ReflectionPart>();
    if (!reflection)
        return body->context->device.fail(Status::invalidArgument,
                                          "recordOverlay: the body's reflection is the sky alone");
    return recordOverlay(commands, reflection->reflector.get(), view, desc);
}

Status bedView(Body* body, const ViewDesc* view, PlanarView* out) {
    if (const Status s = gpu::refuseNull(gpu::contextOf(&body, 1), "bedView",
                                         {{"body", !body}, {"view", !view}, {"out", !out}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("bedView", "body", *body); s != Status::ok) return s;
    BedPart* bed = body->find<BedPart>();
    if (!bed)
        return body->context->device.fail(Status::invalidArgument, "bedView: the body has no BodyDesc.bed");
    return gpu::guarded([&] { return bed->handOut(*body, *view, *out); });
}

Status reflect(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view) {
    if (const Status s = refuseUnusable("reflect", nullptr, commands, bodies, count, {{"view", !view}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(gpu::contextOf(bodies, count), "reflect"); s != Status::ok)
        return s;
    SceneOfCall scene(*view);
    return forEach(bodies, count, [&](Body& body) { return body.reflect(commands, scene); });
}

Status draw(VkCommandBuffer commands, Target* target, Body* const* bodies, uint32_t count,
            const ViewDesc* view, const LightingDesc* lighting, SurfaceOutput output) {
    if (const Status s = refuseDraw("draw", commands, target, bodies, count, view, lighting); s != Status::ok)
        return s;
    if (const Status s = refuseOutput("draw", target->context, output); s != Status::ok) return s;
    const DrawCall call{commands, *target, *view, *lighting};
    const auto drawParts = [&](DrawMoment moment) {
        if (output != SurfaceOutput::shaded) return Status::ok;
        return forEach(bodies, count, [&](Body& body) { return body.drawParts(call, moment); });
    };
    if (const Status s = drawParts(DrawMoment::beforeSurfaces); s != Status::ok) return s;
    const Status surfaces = forEach(bodies, count, [&](Body& body) { return body.draw(call, output); });
    return surfaces == Status::ok ? drawParts(DrawMoment::afterSurfaces) : surfaces;
}

Status shade(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view,
             const LightingDesc* lighting, SurfaceOutput output) {
    if (const Status s = refuseOutput("shade", gpu::contextOf(bodies, count), output); s != Status::ok)
        return s;
    return recordParts("shade", commands, bodies, count, view, lighting, &ShadingPart::shade, output);
}

Status prepare(Target* target, Body* body, const ViewDesc* view, const LightingDesc* lighting,
               SurfaceOutput output) {
    const Context* context = target ? target->context : gpu::contextOf(&body, 1);
    if (const Status s = gpu::refuseNull(context, "prepare", {{"target", !target}, {"body", !body}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("prepare", "target", *target); s != Status::ok) return s;
    if (const Status s = gpu::refuseDestroyed("prepare", "body", *body); s != Status::ok) return s;
    if (body->context != target->context)
        return context->device.fail(Status::invalidArgument,
                                    "prepare: the body and the target are of different contexts");
    if (const Status s = refuseOutput("prepare", context, output); s != Status::ok) return s;
    return gpu::guarded([&] { return body->prepare(*target, view, lighting, output); });
}

Status castCaustics(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view,
                    const LightingDesc* lighting) {
    return recordParts("castCaustics", commands, bodies, count, view, lighting, &CausticsPart::cast);
}

Status drawCaustics(VkCommandBuffer commands, Target* target, Body* const* bodies, uint32_t count,
                    const ViewDesc* view, const LightingDesc* lighting) {
    if (const Status s = refuseDraw("drawCaustics", commands, target, bodies, count, view, lighting);
        s != Status::ok)
        return s;
    const DrawCall call{commands, *target, *view, *lighting};
    return forEach(bodies, count, [&](Body& body) {
        const CausticsPart* caustics = body.find<CausticsPart>();
        return caustics ? caustics->drawLight(body, call) : Status::ok;
    });
}

ReflectionImages reflectionImages(const Body* body, uint32_t viewIndex) {
    const ReflectionPart* reflection = body ? body->find<ReflectionPart>() : nullptr;
    return reflection ? reflectionImages(reflection->reflector.get(), viewIndex) : ReflectionImages{};
}

const Sea* sea(const Body* body) {
    return body ? body->sea.get() : nullptr;
}

} // namespace seaglass
