// The calls of seaglass/water.h: what they are handed is checked, then bodies record one after the other.
#include <memory>

#include "gpu/guard.h"
#include "reflection/interface/drawn_images.h"
#include "seaglass/fields/reflection.h"
#include "water/body/body.h"
#include "water/body/body_desc.h"
#include "water/body/target.h"
#include "water/sea/sea.h"

namespace seaglass {

Status createBody(Context* context, const BodyDesc* desc, Body** out) {
    if (out) *out = nullptr;
    if (const Status s =
            gpu::refuseNull(context, "createBody", {{"context", !context}, {"desc", !desc}, {"out", !out}});
        s != Status::ok)
        return s;
    return gpu::guarded([&] {
        auto body = std::make_unique<Body>();
        if (const Status s = body->create(*context, *desc); s != Status::ok) return s;
        *out = body.release();
        ++context->inUse;
        return Status::ok;
    });
}

namespace {

Status addWaves(Context& context, const BodyDesc& desc, VkExtent2D extent, Estimate& out, bool& hasWaves) {
    SeaError error;
    const std::unique_ptr<Sea, SeaDeleter> sea(createSea(desc.waves, &error));
    if (!sea) return context.device.fail(Status::invalidArgument, "BodyDesc.waves: %s", error.text);
    hasWaves = cascadeCount(*sea) > 0;
    if (!hasWaves) return Status::ok;
    const WavesBackend* backend = chosenBackend(context.device, desc);
    out.bytes += Waves::bytes(context, *sea, backend) +
                 (desc.motion ? Waves::lastBytes(context.device, *sea, backend) : 0);
    if (sea->shore) out.bytes += ShoreMap::bytes(context.device, *sea->shore);
    if (desc.caustics) out.bytesPerView += Caustics::bytes(context.device, desc, extent);
    if (desc.foam && breakingOf(*sea, *desc.foam).count > 0)
        out.bytes += FoamPattern::bytes(context.device) + Foam::bytes(context, *sea, *desc.foam, backend);
    return Status::ok;
}

} // namespace

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
    return gpu::guarded([&] {
        Estimate waves, sum;
        bool hasWaves = false;
        if (desc->waves)
            if (const Status s = addWaves(*context, *desc, extent, waves, hasWaves); s != Status::ok)
                return s;
        if (desc->reflection) {
            const ReflectionDesc reflection = reflectionOf(*desc->reflection, hasWaves);
            if (const Status s = estimate(context, &reflection, extent, &sum, samples); s != Status::ok)
                return s;
        }
        if (desc->refraction) {
            sum.bytesPerSharedView = SingleSampledScene::bytes(context->device, extent, samples.depth);
            sum.dispatchesPerSharedView = SingleSampledScene::dispatches(samples.depth);
        }
        if (desc->bed) {
            if (const Status s = checkDrawn(context->device, desc->bed->drawn, "BedDesc"); s != Status::ok)
                return s;
            sum.dispatchesPerView += Bed::dispatches(*desc->bed);
            sum.bytesPerView += Bed::bytes(context->device, *desc->bed, desc->shading.bedDownscale, extent);
        }
        sum.bytesPerView += waves.bytesPerView;
        sum.bytes += waves.bytes;
        sum.bytes += HostMesh::bytes(context->device, desc->extent);
        *out = sum;
        return Status::ok;
    });
}

void destroyBody(Body* body) {
    destroyHeld(body, "destroyBody");
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
    if (!body->reflector)
        return body->context->device.fail(Status::invalidArgument,
                                          "planarView: the body's reflection is the sky alone");
    return planarView(body->reflector.get(), view, out);
}

Status recordOverlay(VkCommandBuffer commands, Body* body, const ViewDesc* view, const OverlayDesc* desc) {
    if (const Status s =
            gpu::refuseNull(gpu::contextOf(&body, 1), "recordOverlay",
                            {{"commands", !commands}, {"body", !body}, {"view", !view}, {"desc", !desc}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("recordOverlay", "body", *body); s != Status::ok) return s;
    if (!body->reflector)
        return body->context->device.fail(Status::invalidArgument,
                                          "recordOverlay: the body's reflection is the sky alone");
    return recordOverlay(commands, body->reflector.get(), view, desc);
}

Status bedView(Body* body, const ViewDesc* view, PlanarView* out) {
    if (const Status s = gpu::refuseNull(gpu::contextOf(&body, 1), "bedView",
                                         {{"body", !body}, {"view", !view}, {"out", !out}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("bedView", "body", *body); s != Status::ok) return s;
    return gpu::guarded([&] { return body->bedView(*view, *out); });
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
    const auto underwater = [&](UnderwaterPass pass) {
        if (output != SurfaceOutput::shaded) return Status::ok;
        return forEach(bodies, count, [&](Body& body) {
            return body.underwater ? body.drawUnderwater(commands, *target, *view, *lighting, pass)
                                   : Status::ok;
        });
    };
    if (const Status s = underwater(UnderwaterPass::water); s != Status::ok) return s;
    const Status surfaces = forEach(
        bodies, count, [&](Body& body) { return body.draw(commands, *target, *view, *lighting, output); });
    return surfaces == Status::ok ? underwater(UnderwaterPass::waterline) : surfaces;
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
    return gpu::guarded([&] { return body->prepare(*target, view, lighting, output); });
}

Status castCaustics(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view,
                    const LightingDesc* lighting) {
    if (const Status s = refuseUnusable("castCaustics", nullptr, commands, bodies, count,
                                        {{"view", !view}, {"lighting", !lighting}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(gpu::contextOf(bodies, count), "castCaustics");
        s != Status::ok)
        return s;
    return forEach(bodies, count, [&](Body& body) { return body.castCaustics(commands, *view, *lighting); });
}

Status drawCaustics(VkCommandBuffer commands, Target* target, Body* const* bodies, uint32_t count,
                    const ViewDesc* view, const LightingDesc* lighting) {
    if (const Status s = refuseDraw("drawCaustics", commands, target, bodies, count, view, lighting);
        s != Status::ok)
        return s;
    return forEach(bodies, count,
                   [&](Body& body) { return body.drawCaustics(commands, *target, *view, *lighting); });
}

ReflectionImages reflectionImages(const Body* body, uint32_t viewIndex) {
    return body && body->reflector ? reflectionImages(body->reflector.get(), viewIndex) : ReflectionImages{};
}

const Sea* sea(const Body* body) {
    return body ? body->sea.get() : nullptr;
}

} // namespace seaglass
