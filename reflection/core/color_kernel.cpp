#include "reflection/core/color_kernel.h"

#include "gpu/context.h"
#include "gpu/pipeline/constants.h"

namespace seaglass {

namespace {

struct SceneConstants {
#define CONSTANTS "shaders/shared/scene_constants.h"
#include "gpu/pipeline/constants.inl"
};

} // namespace

Status ColorKernel::create(Context& context, std::span<const uint32_t> spirv, const char* what) {
    spirv_ = spirv;
    what_ = what;
    return linear_.create(context.device, spirv, what);
}

Status ColorKernel::of(const Context& context, const Image& sceneColor, const gpu::Kernel*& out) {
    out = isEncoded(sceneColor) ? &encoded_ : &linear_;
    if (!isEncoded(sceneColor) || hasEncoded_) return Status::ok;
    SceneConstants scene;
    scene.sceneIsEncoded = true;
    const Status s = encoded_.create(context.device, spirv_, what_, scene.constants());
    hasEncoded_ = s == Status::ok;
    return s;
}

} // namespace seaglass
