#include "reflection/reflector.h"

#include <cstring>

#include "gpu/guard.h"
#include "reflection/blur.h"
#include "reflection/mirror.h"

namespace seaglass {

Status ReflectedView::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    region = extent;
    if (const Status s = sspr.create(device, extent, desc); s != Status::ok) return s;
    return images.create(device, scaledDown(extent, desc.downscale), desc.blurLevels);
}

Estimate estimateOf(const ReflectionDesc& desc, VkExtent2D extent) {
    Estimate estimate;
    if (desc.technique == ReflectionTechnique::sky) return estimate;
    estimate.bytesPerView = OwnedReflection::bytes(scaledDown(extent, desc.downscale), desc.blurLevels) +
                            SsprScratch::bytes(extent, desc);
    estimate.dispatchesPerView = ssprDispatches;
    return estimate;
}

const char* badField(const ReflectionDesc& desc) {
    if (desc.technique != ReflectionTechnique::sky && desc.technique != ReflectionTechnique::sspr)
        return "ReflectionDesc.technique is none of ReflectionTechnique";
    if (desc.downscale != 1 && desc.downscale != 2 && desc.downscale != 4 && desc.downscale != 8)
        return "ReflectionDesc.downscale is out of range, expected 1, 2, 4 or 8";
    if (!(desc.edgeFade >= 0 && desc.edgeFade <= 0.5f))
        return "ReflectionDesc.edgeFade is out of range, expected 0 to 0.5";
    if (!(desc.distortion >= 0 && desc.distortion <= 1))
        return "ReflectionDesc.distortion is out of range, expected 0 to 1";
    if (desc.blurLevels > 6) return "ReflectionDesc.blurLevels is out of range, expected 0 to 6";
    return nullptr;
}

Status Reflector::create(Context& owner, const ReflectorDesc& description) {
    context = &owner;
    desc = description.reflection;
    if (const char* bad = readPlane(description.plane, plane))
        return owner.device.fail(Status::invalidArgument, "ReflectorDesc: %s", bad);
    if (const char* bad = badField(desc)) return owner.device.fail(Status::invalidArgument, "%s", bad);
    if (desc.technique == ReflectionTechnique::sspr) return sspr.create(owner, desc);
    return Status::ok;
}

Status Reflector::prepare(ReflectedView& view, VkExtent2D extent) {
    if (view.region.width == extent.width && view.region.height == extent.height) return Status::ok;
    ReflectedView fresh;
    if (const Status s = fresh.create(context->device, extent, desc); s != Status::ok) return s;
    context->frame().retire(std::exchange(view, std::move(fresh)));
    return Status::ok;
}

Status Reflector::record(VkCommandBuffer commands, const ViewDesc& view) {
    if (desc.technique == ReflectionTechnique::sky) return Status::ok;
    ViewGeometry geometry;
    if (const char* bad = readView(view, geometry))
        return context->device.fail(Status::invalidArgument, "reflect: %s", bad);
    ReflectedView& reflected = views[view.viewIndex];
    if (const Status s = prepare(reflected, {static_cast<uint32_t>(geometry.regionSize.x),
                                             static_cast<uint32_t>(geometry.regionSize.y)});
        s != Status::ok)
        return s;

    const MirrorUniforms uniforms = mirrorUniforms(geometry, plane, desc);
    gpu::Slice slice;
    if (const Status s = context->frame().allocate(sizeof uniforms, slice); s != Status::ok) return s;
    std::memcpy(slice.data, &uniforms, sizeof uniforms);
    const ReflectPass pass{*context, commands, view, geometry, desc, slice};
    if (const Status s = recordSspr(pass, sspr, reflected.sspr, reflected.images); s != Status::ok) return s;
    recordBlur(*context, commands, reflected.images.color);
    return Status::ok;
}

ReflectionImages Reflector::images(uint32_t viewIndex) const {
    return viewIndex < maxViews ? views[viewIndex].images.handles() : ReflectionImages{};
}

Status createReflector(Context* context, const ReflectorDesc* desc, Reflector** out) {
    if (!context || !desc || !out) return Status::invalidArgument;
    *out = nullptr;
    return gpu::guarded([&] {
        auto reflector = std::make_unique<Reflector>();
        if (const Status s = reflector->create(*context, *desc); s != Status::ok) return s;
        *out = reflector.release();
        return Status::ok;
    });
}

Status estimate(Context* context, const ReflectionDesc* desc, VkExtent2D extent, Estimate* out) {
    if (!context || !desc || !out) return Status::invalidArgument;
    *out = {};
    if (const char* bad = badField(*desc)) return context->device.fail(Status::invalidArgument, "%s", bad);
    if (extent.width == 0 || extent.height == 0)
        return context->device.fail(Status::invalidArgument, "estimate: the extent is empty");
    *out = estimateOf(*desc, extent);
    return Status::ok;
}

void destroyReflector(Reflector* reflector) {
    if (!reflector) return;
    reflector->context->frame().retire(std::unique_ptr<Reflector>(reflector));
}

Status reflect(VkCommandBuffer commands, Reflector* const* reflectors, uint32_t count, const ViewDesc* view) {
    if (!commands || (count && !reflectors) || !view) return Status::invalidArgument;
    return gpu::guarded([&] {
        for (uint32_t i = 0; i < count; ++i) {
            if (!reflectors[i]) return Status::invalidArgument;
            if (const Status s = reflectors[i]->record(commands, *view); s != Status::ok) return s;
        }
        return Status::ok;
    });
}

ReflectionImages reflectionImages(const Reflector* reflector, uint32_t viewIndex) {
    return reflector ? reflector->images(viewIndex) : ReflectionImages{};
}

} // namespace seaglass
