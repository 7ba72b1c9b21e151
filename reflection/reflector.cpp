#include "reflection/reflector.h"

#include <cstring>

#include "gpu/guard.h"
#include "reflection/blur.h"
#include "reflection/mirror.h"

namespace seaglass {

Status SsprKernels::create(Context& context) {
    if (const Status s = scatter.create(context); s != Status::ok) return s;
    return resolve.create(context);
}

Status SsprImages::create(const gpu::Device& device, VkExtent2D extent, uint32_t blurLevels) {
    const VkDeviceSize bytes = VkDeviceSize{extent.width} * extent.height * sizeof(uint32_t);
    if (bytes > device.limits().maxStorageBufferRange)
        return device.fail(Status::unsupported,
                           "reflect: %u x %u pixels need a storage buffer of %llu bytes, the device has %u",
                           extent.width, extent.height, static_cast<unsigned long long>(bytes),
                           device.limits().maxStorageBufferRange);
    const VkImageUsageFlags usage =
        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (const Status s = keys.create(device, bytes,
                                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                         VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                     "SSPR keys");
        s != Status::ok)
        return s;
    gpu::ImageDesc colorDesc;
    colorDesc.format = VK_FORMAT_R16G16B16A16_SFLOAT;
    colorDesc.extent = extent;
    colorDesc.usage = usage | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    colorDesc.mipLevels = blurMipLevels(extent, blurLevels);
    if (const Status s = color.create(device, colorDesc, "reflection colour"); s != Status::ok) return s;
    return info.create(device, {VK_FORMAT_R32G32_SFLOAT, extent, usage}, "reflection info");
}

const char* badField(const ReflectionDesc& desc) {
    if (desc.technique != ReflectionTechnique::sky && desc.technique != ReflectionTechnique::sspr)
        return "ReflectionDesc.technique is none of ReflectionTechnique";
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
    if (desc.technique == ReflectionTechnique::sspr) return owner.share(kernels);
    return Status::ok;
}

Status Reflector::record(VkCommandBuffer commands, const ViewDesc& view) {
    if (desc.technique == ReflectionTechnique::sky) return Status::ok;
    const gpu::Device& device = context->device;
    ViewGeometry geometry;
    if (const char* bad = readView(view, geometry))
        return device.fail(Status::invalidArgument, "reflect: %s", bad);
    const VkExtent2D extent = {static_cast<uint32_t>(geometry.regionSize.x),
                               static_cast<uint32_t>(geometry.regionSize.y)};

    SsprImages& images = views[view.viewIndex];
    const VkExtent2D current = images.color.desc().extent;
    if (!images.color.view() || current.width != extent.width || current.height != extent.height) {
        SsprImages fresh;
        if (const Status s = fresh.create(device, extent, desc.blurLevels); s != Status::ok) return s;
        context->frame().retire(std::exchange(images, std::move(fresh)));
    }

    const MirrorUniforms uniforms = mirrorUniforms(geometry, plane, desc.edgeFade);
    gpu::Slice slice;
    if (const Status s = context->frame().allocate(sizeof uniforms, slice); s != Status::ok) return s;
    std::memcpy(slice.data, &uniforms, sizeof uniforms);
    if (const Status s =
            recordScatter(*context, kernels->scatter, commands, slice, view.sceneDepth, images.keys, extent);
        s != Status::ok)
        return s;
    if (const Status s = recordResolve(*context, kernels->resolve, commands, slice, view, images.keys,
                                       images.color, images.info);
        s != Status::ok)
        return s;
    recordBlur(*context, commands, images.color);
    return Status::ok;
}

ReflectionImages Reflector::images(uint32_t viewIndex) const {
    if (viewIndex >= maxViews) return {};
    const SsprImages& v = views[viewIndex];
    return {v.color.handle(), v.color.view(), v.info.handle(), v.info.view(), v.color.desc().extent};
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
