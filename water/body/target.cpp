#include "water/body/target.h"

#include "gpu/guard.h"
#include "gpu/view/encoding.h"
#include "gpu/view/limits.h"
#include "water/interface/fields/water.h"

namespace seaglass {

FieldError badField(const TargetDesc& desc) {
    if (desc.colorFormat == VK_FORMAT_UNDEFINED) return "TargetDesc.colorFormat is undefined";
    if (desc.depthFormat == VK_FORMAT_UNDEFINED) return "TargetDesc.depthFormat is undefined";
    if (desc.encoding == Encoding::srgb && appliesSrgb(desc.colorFormat))
        return "TargetDesc.encoding is srgb, which TargetDesc.colorFormat applies by itself";
    return badField(targetFields, &desc);
}

namespace {

static_assert(targetFieldRows[3].high == (1u << maxViews) - 1);

/// What the device cannot draw into, or null.
const char* notDrawable(const gpu::Device& device, const TargetDesc& desc) {
    const auto lacks = [&](VkFormat format, VkFormatFeatureFlags needed) {
        return format != VK_FORMAT_UNDEFINED && (device.optimalFeatures(format) & needed) != needed;
    };
    if (lacks(desc.colorFormat, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT))
        return "TargetDesc.colorFormat is none that this device draws into";
    if (lacks(desc.depthFormat, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
        return "TargetDesc.depthFormat is none that this device draws depth into";
    if (lacks(desc.stencilFormat, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
        return "TargetDesc.stencilFormat is none that this device draws stencil into";
    const VkPhysicalDeviceLimits& limits = device.limits();
    if (!(desc.samples & limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts))
        return "TargetDesc.samples is more than this device draws into";
    return nullptr;
}

void tellUnspecified(Context& context, const TargetDesc& desc) {
    if (desc.encoding != Encoding::unspecified || !isDisplayFormat(desc.colorFormat)) return;
    context.toldOfEncoding = true;
    static_cast<void>(context.device.fail(
        Status::ok, "TargetDesc.colorFormat is UNORM, and taken for linear, expected TargetDesc.encoding to "
                    "be linear, or srgb where it holds what displays take"));
}

} // namespace

bool holdsFloats(VkFormat format) {
    return format == VK_FORMAT_R16G16B16A16_SFLOAT || format == VK_FORMAT_R32G32B32A32_SFLOAT ||
           format == VK_FORMAT_B10G11R11_UFLOAT_PACK32;
}

Status createTarget(Context* context, const TargetDesc* desc, Target** out) {
    return gpu::createHeld("createTarget", context, desc, out, [&](Target& target) {
        if (const FieldError bad = badField(*desc))
            return context->device.fail(Status::invalidArgument, "%s", bad.text());
        if (const char* bad = notDrawable(context->device, *desc))
            return context->device.fail(Status::unsupported, "%s", bad);
        target.context = context;
        target.desc = *desc;
        target.viewPasses.init(context->device, *desc);
        target.placedSamples.init(context->device, *desc);
        target.spray.init(context->device, *desc);
        tellUnspecified(*context, *desc);
        return Status::ok;
    });
}

void destroyTarget(Target* target) {
    gpu::destroyHeld("destroyTarget", target);
}

} // namespace seaglass
