#include "reflection/core/reflector.h"

#include "gpu/guard.h"
#include "gpu/view/encoding.h"
#include "gpu/view/plane.h"
#include "gpu/view/scene_formats.h"
#include "reflection/core/mirror.h"
#include "reflection/interface/body_reflector.h"
#include "reflection/interface/fields/reflection.h"
#include "reflection/planar/planar.h"
#include "reflection/sspr/tiles.h"

namespace seaglass {

namespace {

/// What is drawn by the host needs no guess.
bool reachesBeyond(const ReflectionDesc& desc) {
    return desc.edgeReach > 0 && techniqueOf(desc.technique).readsScene;
}

/// Of a technique that does not know where its images are looked up.
bool takesAllTiles(const ReflectionDesc& desc) {
    return !techniqueOf(desc.technique).tiles && (desc.temporal > 0 || reachesBeyond(desc));
}

} // namespace

Status ReflectedView::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    region = extent;
    downscale = desc.downscale;
    const VkExtent2D scaled = scaledDown(extent, desc);
    if (const Status s = techniqueOf(desc.technique).createScratch(device, extent, desc, scratch);
        s != Status::ok)
        return s;
    if (desc.temporal > 0)
        if (const Status s = temporal.create(device, scaled, desc); s != Status::ok) return s;
    if (takesAllTiles(desc))
        if (const Status s = createTiles(device, scaled, "all tiles", allTiles); s != Status::ok) return s;
    return images.create(device, scaled, desc.blurLevels, drawnInPlace(desc) && desc.temporal == 0);
}

Estimate estimateOf(const gpu::Device& device, const ReflectionDesc& given, VkExtent2D extent,
                    const SceneSamples& samples) {
    const ReflectionDesc desc = sizedFor(given, extent);
    Estimate estimate;
    const Technique& technique = techniqueOf(desc.technique);
    if (!technique.record) return estimate;
    const VkExtent2D scaled = scaledDown(extent, desc);
    estimate.bytesPerView =
        OwnedReflection::bytes(device, scaled, desc.blurLevels, drawnInPlace(desc) && desc.temporal == 0) +
        technique.bytes(device, extent, desc);
    estimate.dispatchesPerView = technique.dispatches(device, desc);
    if (takesAllTiles(desc)) estimate.bytesPerView += heldByTiles(device, scaled);
    if (technique.readsScene) {
        estimate.bytesPerSharedView = SingleSampledScene::bytes(device, extent, samples.depth);
        estimate.dispatchesPerSharedView = SingleSampledScene::dispatches(samples.depth);
    }
    estimate.dispatchesPerView += blurMipLevels(scaled, desc.blurLevels) - 1;
    if (reachesBeyond(desc)) estimate.dispatchesPerView += edgeReachDispatches;
    if (desc.edgeStretch > 0) estimate.dispatchesPerView += stretchDispatches;
    if (desc.temporal > 0) {
        estimate.bytesPerView += TemporalScratch::bytes(device, scaled, desc);
        estimate.dispatchesPerView += temporalDispatches + unseenTilesDispatches(device);
    }
    return estimate;
}

FieldError badField(const ReflectionDesc& desc) {
    return badField(reflectionFields, &desc);
}

Status check(const gpu::Device& device, const ReflectionDesc& desc) {
    if (const FieldError bad = badField(desc)) return device.fail(Status::invalidArgument, "%s", bad.text());
    if (desc.technique != ReflectionTechnique::planar) return Status::ok;
    return checkDrawn(device, desc.drawn, "ReflectionDesc");
}

Status Reflector::create(Context& owner, const ReflectorDesc& description) {
    context = &owner;
    desc = description.reflection;
    if (const char* bad = readPlane(description.plane, plane))
        return owner.device.fail(Status::invalidArgument, "ReflectorDesc: %s", bad);
    if (const char* bad = readBounds(description.boundsLow, description.boundsHigh, bounds))
        return owner.device.fail(Status::invalidArgument, "ReflectorDesc: %s", bad);
    if (const Status s = check(owner.device, desc); s != Status::ok) return s;
    if (!technique().record) return Status::ok;
    if (const Status s = technique().createKernels(owner, desc, kernels); s != Status::ok) return s;
    if (desc.blurLevels > 0)
        if (const Status s = owner.share(blur); s != Status::ok) return s;
    if (desc.edgeStretch > 0)
        if (const Status s = owner.share(stretch); s != Status::ok) return s;
    if (reachesBeyond(desc))
        if (const Status s = owner.share(edgeReach); s != Status::ok) return s;
    if (desc.temporal > 0)
        if (const Status s = owner.share(temporal); s != Status::ok) return s;
    return Status::ok;
}

Status Reflector::prepare(ReflectedView& view, VkExtent2D extent) {
    if (view.isOf(extent)) return Status::ok;
    ReflectedView fresh;
    if (const Status s = fresh.create(context->device, extent, sizedFor(desc, extent)); s != Status::ok)
        return s;
    context->frame().replace(view, std::move(fresh));
    return Status::ok;
}

Status Reflector::handOut(const ViewDesc& view, PlanarView& out) {
    const gpu::Device& device = context->device;
    if (desc.technique != ReflectionTechnique::planar)
        return device.fail(Status::invalidArgument,
                           "planarView: ReflectionDesc.technique is not ReflectionTechnique::planar");
    ViewGeometry geometry;
    if (const FieldError bad = readCamera(view, geometry))
        return device.fail(Status::invalidArgument, "planarView: %s", bad.text());
    ReflectedView& reflected = views[view.viewIndex];
    out = {};
    out.visible = !isEmpty(pixelsThatMayShow(bounds, geometry));
    if (!out.visible) return Status::ok;
    if (const Status s = prepare(reflected, extentOf(geometry)); s != Status::ok) return s;
    const MirroredCamera camera = mirroredCamera(view, geometry, mirroredPlane());
    PlanarScratch& planar = reflected.scratchOf<PlanarScratch>();
    out = describe(camera, view, geometry, reflected.downscale, planar, reflected.found(desc));
    planar.handedOut = true;
    reflected.reflected = false;
    return Status::ok;
}

Status Reflector::uploadMirror(const ViewDesc& view, const ViewGeometry& geometry, const glm::ivec4& shown,
                               gpu::Slice& out) {
    MirrorBlock uniforms = mirrorBlock(geometry, mirroredPlane(), sizedFor(desc, extentOf(geometry)), shown);
    // A surface with normals of its own stands where the flat plane is not seen.
    if (view.surfaceNormals) uniforms.bent = 1;
    return context->frame().upload(uniforms, out);
}

Status Reflector::record(VkCommandBuffer commands, SceneOfCall& scene) {
    const ViewDesc& view = scene.given;
    if (!technique().record) return Status::ok;
    const bool drawn = !technique().readsScene;
    ViewGeometry geometry;
    if (const FieldError bad = drawn ? readCamera(view, geometry) : readView(view, geometry))
        return context->device.fail(Status::invalidArgument, "reflect: %s", bad.text());
    if (!drawn) tellUnspecified(*context, view.sceneColor);
    ReflectedView& reflected = views[view.viewIndex];
    const glm::ivec4 shown = pixelsThatMayShow(bounds, geometry);
    if (isEmpty(shown)) {
        reflected.temporal.last = {};
        return Status::ok;
    }
    const VkExtent2D extent = extentOf(geometry);
    if (drawn && !(reflected.isOf(extent) && reflected.scratchOf<PlanarScratch>().handedOut))
        return context->device.misused("reflect: planarView() was not called for this view before");
    if (const Status s = prepare(reflected, extent); s != Status::ok) return s;

    gpu::Slice slice;
    if (const Status s = uploadMirror(view, geometry, shown, slice); s != Status::ok) return s;
    const ReflectionDesc sized = sizedFor(desc, extent);
    const glm::dvec4 mirrored = mirroredPlane();
    const ReflectPass pass{*context, commands, scene.read, geometry, sized, slice, mirrored};
    if (!drawn)
        if (const Status s = takeSamples(*context, commands, geometry, singleSamples, scene); s != Status::ok)
            return s;
    reflected.bent = technique().followsNormals && view.surfaceNormals;
    if (const Status s =
            technique().record(pass, kernels.get(), reflected.scratch.get(), reflected.found(desc));
        s != Status::ok)
        return s;
    if (const Status s = recordAfter(pass, reflected); s != Status::ok) return s;
    reflected.reflected = true;
    reflected.frame = context->frameNumber;
    toValues(toMatrix(view.projection) * toMatrix(view.view), reflected.clipFromWorld);
    return Status::ok;
}

Status Reflector::recordAfter(const ReflectPass& pass, ReflectedView& reflected) {
    const OwnedReflection& found = reflected.found(desc);
    const gpu::Buffer& tiles = reflected.tiles(technique());
    if (takesAllTiles(desc)) recordAllSeen(context->device, pass.commands, reflected.allTiles);
    if (edgeReach && !pass.view.surfaceNormals)
        if (const Status s = recordEdgeReach(pass, *edgeReach, tiles, found); s != Status::ok) return s;
    if (stretch)
        if (const Status s = recordStretch(pass, *stretch, found); s != Status::ok) return s;
    if (temporal)
        if (const Status s = recordTemporal(pass, *temporal, tiles, reflected.temporal, reflected.images);
            s != Status::ok)
            return s;
    return recordBlur(*context, pass.commands, blur.get(), reflected.images.color);
}

Status Reflector::drawOverlay(VkCommandBuffer commands, const ViewDesc& view,
                              const OverlayDesc& overlayDesc) {
    ViewGeometry geometry;
    FieldError bad = readView(view, geometry);
    if (!bad) bad = badField(overlayDesc, view);
    if (!bad && showsReflection(overlayDesc.kind)) {
        const ReflectedView& reflected = views[view.viewIndex];
        if (!reflected.reflected || !reflected.isOf(extentOf(geometry)))
            bad = "OverlayDesc.kind shows what reflect() leaves, which was not called for this view before";
    }
    if (bad) return context->device.fail(Status::invalidArgument, "recordOverlay: %s", bad.text());
    if (!overlay)
        if (const Status s = context->share(overlay); s != Status::ok) return s;
    gpu::Slice slice;
    if (const Status s = uploadMirror(view, geometry, pixelsThatMayShow(bounds, geometry), slice);
        s != Status::ok)
        return s;
    SceneOfCall scene(view);
    const ReflectionDesc sized = sizedFor(desc, extentOf(geometry));
    const glm::dvec4 mirrored = mirroredPlane();
    const ReflectPass pass{*context, commands, scene.read, geometry, sized, slice, mirrored};
    if (const Status s = takeSamples(*context, commands, geometry, singleSamples, scene); s != Status::ok)
        return s;
    return recordOverlay(pass, *overlay, images(view.viewIndex), overlayDesc);
}

ReflectionImages Reflector::images(uint32_t viewIndex) const {
    if (viewIndex >= maxViews) return {};
    ReflectionImages images = views[viewIndex].images.handles();
    const ReflectedView& view = views[viewIndex];
    images.bent = view.bent;
    images.downscale = view.downscale;
    images.age = static_cast<uint32_t>(std::min<uint64_t>(context->frameNumber - view.frame, UINT32_MAX));
    std::ranges::copy(view.clipFromWorld, images.clipFromWorld);
    return images;
}

Status createReflector(Context& context, const ReflectorDesc& desc, const glm::dmat3& axes,
                       std::shared_ptr<Reflector>& out) {
    const auto reflector = std::make_shared<Reflector>();
    if (const Status s = reflector->create(context, desc); s != Status::ok) return s;
    reflector->bounds.axes = axes;
    out = reflector;
    return Status::ok;
}

Status createReflector(Context* context, const ReflectorDesc* desc, Reflector** out) {
    return gpu::createHeld("createReflector", context, desc, out,
                           [&](Reflector& reflector) { return reflector.create(*context, *desc); });
}

Status estimate(Context* context, const ReflectionDesc* desc, VkExtent2D extent, Estimate* out,
                SceneSamples samples) {
    if (const Status s =
            gpu::refuseNull(context, "estimate", {{"context", !context}, {"desc", !desc}, {"out", !out}});
        s != Status::ok)
        return s;
    *out = {};
    if (const Status s = check(context->device, *desc); s != Status::ok) return s;
    if (const Status s = gpu::refuseExtent(*context, extent); s != Status::ok) return s;
    if (const FieldError bad = badField(sceneSampleFields, &samples))
        return context->device.fail(Status::invalidArgument, "estimate: %s", bad.text());
    *out = estimateOf(context->device, *desc, extent, samples);
    return Status::ok;
}

void destroyReflector(Reflector* reflector) {
    gpu::destroyHeld("destroyReflector", reflector);
}

Status planarView(Reflector* reflector, const ViewDesc* view, PlanarView* out) {
    if (const Status s = gpu::refuseNull(gpu::contextOf(&reflector, 1), "planarView",
                                         {{"reflector", !reflector}, {"view", !view}, {"out", !out}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("planarView", "reflector", *reflector); s != Status::ok)
        return s;
    return gpu::guarded([&] { return reflector->handOut(*view, *out); });
}

Status reflect(VkCommandBuffer commands, Reflector* const* reflectors, uint32_t count, const ViewDesc* view) {
    if (const Status s =
            gpu::refuseNull(gpu::contextOf(reflectors, count), "reflect",
                            {{"commands", !commands}, {"reflectors", count && !reflectors}, {"view", !view}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseUnusable("reflect", "reflectors", reflectors, count); s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(gpu::contextOf(reflectors, count), "reflect");
        s != Status::ok)
        return s;
    return gpu::guarded([&] {
        if (count > maxReflectors)
            return reflectors[0]->context->device.fail(
                Status::invalidArgument, "reflect: count is %u, expected %u at most", count, maxReflectors);
        SceneOfCall scene(*view);
        for (uint32_t i = 0; i < count; ++i)
            if (const Status s = reflectors[i]->record(commands, scene); s != Status::ok) return s;
        return Status::ok;
    });
}

void raiseMirror(Reflector& reflector, double by) {
    reflector.raised = by;
}

Status reflect(VkCommandBuffer commands, Reflector& reflector, SceneOfCall& scene) {
    return reflector.record(commands, scene);
}

bool readsScene(const ReflectionDesc& desc) {
    return techniqueOf(desc.technique).readsScene;
}

ReflectionImages reflectionImages(const Reflector* reflector, uint32_t viewIndex) {
    return reflector ? reflector->images(viewIndex) : ReflectionImages{};
}

Status recordOverlay(VkCommandBuffer commands, Reflector* reflector, const ViewDesc* view,
                     const OverlayDesc* desc) {
    if (const Status s = gpu::refuseNull(
            gpu::contextOf(&reflector, 1), "recordOverlay",
            {{"commands", !commands}, {"reflector", !reflector}, {"view", !view}, {"desc", !desc}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("recordOverlay", "reflector", *reflector); s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(reflector->context, "recordOverlay"); s != Status::ok)
        return s;
    return gpu::guarded([&] { return reflector->drawOverlay(commands, *view, *desc); });
}

} // namespace seaglass
