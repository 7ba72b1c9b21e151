#include "tests/gpu/rig/reflection_rig.h"

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/poses.h"

namespace tests {

using seaglass::Status;

seaglass::ReflectorDesc with(seaglass::ReflectionTechnique technique) {
    seaglass::ReflectorDesc desc;
    desc.reflection.technique = technique;
    return desc;
}

std::string nameOf(const testing::TestParamInfo<seaglass::ReflectionTechnique>& info) {
    if (info.param == seaglass::ReflectionTechnique::sspr) return "Sspr";
    if (info.param == seaglass::ReflectionTechnique::planar) return "Planar";
    return info.param == seaglass::ReflectionTechnique::ssr ? "Ssr" : "Hybrid";
}

TracedView framed(const TracedView& traced, uint32_t left, uint32_t top) {
    TracedView larger;
    larger.width = traced.width + 64;
    larger.height = traced.height + 48;
    // An obstacle wherever the region is overstepped.
    larger.depth.assign(size_t{larger.width} * larger.height, 0.7f);
    larger.color.assign(larger.depth.size() * 4, 9.0f);
    for (uint32_t y = 0; y < traced.height; ++y)
        for (uint32_t x = 0; x < traced.width; ++x) {
            const size_t from = size_t{y} * traced.width + x;
            const size_t to = size_t{y + top} * larger.width + x + left;
            larger.depth[to] = traced.depth[from];
            std::copy_n(traced.color.begin() + static_cast<ptrdiff_t>(from * 4), 4,
                        larger.color.begin() + static_cast<ptrdiff_t>(to * 4));
        }
    return larger;
}

SceneOnDevice ReflectionTest::upload(const TracedView& traced, seaglass::ViewDesc& view) {
    SceneOnDevice scene{uploadFloats(traced.width, traced.height, 1, traced.depth),
                        uploadFloats(traced.width, traced.height, 4, traced.color)};
    view.sceneDepth = asSeaglass(scene.depth);
    view.sceneColor = asSeaglass(scene.color);
    return scene;
}

Reflected ReflectionTest::reflectView(const TracedView& traced, const seaglass::ViewDesc& view,
                                      const seaglass::ReflectorDesc& desc) {
    return reflectTogether(traced, view, {&desc, 1}).front();
}

Reflected ReflectionTest::reflectImages(const seaglass::ViewDesc& view, const seaglass::ReflectorDesc& desc) {
    return reflectTogether(view, {&desc, 1}).front();
}

std::vector<Reflected> ReflectionTest::reflectTogether(const seaglass::ViewDesc& view,
                                                       std::span<const seaglass::ReflectorDesc> descs) {
    std::vector<seaglass::Reflector*> reflectors;
    for (const seaglass::ReflectorDesc& desc : descs)
        EXPECT_EQ(seaglass::createReflector(context(), &desc, &reflectors.emplace_back()), Status::ok)
            << message();
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(
            seaglass::reflect(commands, reflectors.data(), static_cast<uint32_t>(reflectors.size()), &view),
            Status::ok)
            << message();
    });
    std::vector<Reflected> results;
    for (seaglass::Reflector* const reflector : reflectors) {
        const seaglass::ReflectionImages images = seaglass::reflectionImages(reflector, view.viewIndex);
        results.push_back({download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                           download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)});
        seaglass::destroyReflector(reflector);
    }
    // Both slots come round, so that the reflectors are gone before their images are.
    frame([](VkCommandBuffer) {});
    frame([](VkCommandBuffer) {});
    return results;
}

std::vector<Reflected> ReflectionTest::reflectTogether(const TracedView& traced, seaglass::ViewDesc view,
                                                       std::span<const seaglass::ReflectorDesc> descs) {
    const SceneOnDevice scene = upload(traced, view);
    return reflectTogether(view, descs);
}

Reflected ReflectionTest::reflectScene(const Camera& camera, const TracedView& traced,
                                       const seaglass::ReflectorDesc& desc) {
    return reflectView(traced, viewDesc(camera), desc);
}

seaglass::Estimate ReflectionTest::expectEstimateHolds(const seaglass::ReflectorDesc& desc,
                                                       VkExtent2D extent) {
    Camera camera = testCamera();
    camera.width = extent.width;
    camera.height = extent.height;
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    seaglass::ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(traced, view);
    frame([](VkCommandBuffer) {});
    seaglass::Estimate estimated;
    EXPECT_EQ(seaglass::estimate(context(), &desc.reflection, extent, &estimated), Status::ok) << message();
    seaglass::Reflector* reflector = nullptr;
    EXPECT_EQ(seaglass::createReflector(context(), &desc, &reflector), Status::ok) << message();
    // The first frame makes uniform blocks, of which no estimate is made.
    frame([&](VkCommandBuffer commands) {
        view.viewIndex = 1;
        EXPECT_EQ(seaglass::reflect(commands, &reflector, 1, &view), Status::ok) << message();
    });
    frame([](VkCommandBuffer) {});
    spiedCalls().clear();
    frame([&](VkCommandBuffer commands) {
        view.viewIndex = 0;
        EXPECT_EQ(seaglass::reflect(commands, &reflector, 1, &view), Status::ok) << message();
    });
    EXPECT_EQ(bytesSpied(), estimated.bytesPerView);
    EXPECT_EQ(countSpied("CmdDispatch") + countSpied("CmdDispatchIndirect"), estimated.dispatchesPerView);
    seaglass::destroyReflector(reflector);
    frame([](VkCommandBuffer) {});
    frame([](VkCommandBuffer) {});
    return estimated;
}

} // namespace tests
