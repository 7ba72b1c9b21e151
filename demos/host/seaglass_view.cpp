#include "host/seaglass_view.h"

#include <glm/gtc/type_ptr.hpp>

namespace demos {
namespace {

seaglass::Image sampled(const Image& image) {
    return {image.view.get(), image.format, image.extent, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

} // namespace

seaglass::ViewDesc viewOf(const Camera& camera, const FrameTargets& targets) {
    seaglass::ViewDesc view;
    std::copy_n(glm::value_ptr(camera.view), 16, view.view);
    std::copy_n(glm::value_ptr(camera.projection), 16, view.projection);
    view.viewport = {
        0, 0, static_cast<float>(targets.extent.width), static_cast<float>(targets.extent.height), 0, 1};
    view.sceneColor = sampled(targets.sceneColor);
    view.sceneDepth = sampled(targets.sceneDepth);
    return view;
}

bool reflectionOf(const ReflectionDesc& desc, const char* surface, seaglass::ReflectionDesc& out,
                  Error& error) {
    if (desc.technique == "sspr") {
        out.technique = seaglass::ReflectionTechnique::sspr;
    } else if (desc.technique == "sky") {
        out.technique = seaglass::ReflectionTechnique::sky;
    } else if (desc.technique == "planar") {
        out.technique = seaglass::ReflectionTechnique::planar;
    } else {
        error.text = std::string(surface) + ".reflection.technique is \"" + desc.technique +
                     "\", expected sky, sspr or planar";
        return false;
    }
    out.downscale = desc.downscale;
    out.coarseKeys = desc.coarseKeys;
    out.edgeFade = static_cast<float>(desc.edgeFade);
    out.distortion = static_cast<float>(desc.distortion);
    return true;
}

} // namespace demos
