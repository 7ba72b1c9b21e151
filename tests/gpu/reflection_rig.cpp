#include "tests/gpu/reflection_rig.h"

namespace tests {

using seaglass::Status;

Reflected ReflectionTest::reflectView(const TracedView& traced, seaglass::ViewDesc view,
                                      const seaglass::ReflectorDesc& desc) {
    const demos::Image depth = uploadFloats(traced.width, traced.height, 1, traced.depth);
    const demos::Image color = uploadFloats(traced.width, traced.height, 4, traced.color);
    view.sceneDepth = asSeaglass(depth);
    view.sceneColor = asSeaglass(color);
    seaglass::Reflector* reflector = nullptr;
    EXPECT_EQ(seaglass::createReflector(context(), &desc, &reflector), Status::ok) << message();
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(seaglass::reflect(commands, &reflector, 1, &view), Status::ok) << message();
    });
    const seaglass::ReflectionImages images = seaglass::reflectionImages(reflector, view.viewIndex);
    Reflected result{download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                     download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
    seaglass::destroyReflector(reflector);
    // Both slots come round, so that the reflector is gone before its images are.
    frame([](VkCommandBuffer) {});
    frame([](VkCommandBuffer) {});
    return result;
}

Reflected ReflectionTest::reflectScene(const Camera& camera, const TracedView& traced,
                                       const seaglass::ReflectorDesc& desc) {
    return reflectView(traced, viewDesc(camera), desc);
}

} // namespace tests
