// An eye in the water: what the reference says of it has a closed form over still water, and the host agrees.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "host/host.h"
#include "metrics/compare.h"
#include "reference/reference.h"

namespace {

using namespace demos;

Image view(const Picture& picture) {
    return {picture.width, picture.height, picture.rgba};
}

CameraDesc cameraOf(const Scene& scene, const std::string& name) {
    return *std::ranges::find(scene.cameras, name, &CameraDesc::name);
}

class UnderwaterHost : public testing::Test {
  protected:
    void SetUp() override {
        Error error;
        const auto scene = loadScene(std::string(SEAGLASS_SCENES) + "/harbour.toml", {}, error);
        ASSERT_TRUE(scene) << error.text;
        scene_ = *scene;
        HostDesc desc;
        desc.validation = true;
        host_ = Host::create(desc, error);
        ASSERT_TRUE(host_) << error.text;
    }
    Picture render(const CameraDesc& camera) {
        Error error;
        const std::optional<Picture> picture =
            host_->render({width, height, camera, scene_.timeS, Aov::color}, error);
        EXPECT_TRUE(picture) << error.text;
        return *picture;
    }
    Picture trace(const CameraDesc& camera, uint32_t samples) {
        Error error;
        reference::World world;
        reference::Frame frame;
        reference::FrameDesc desc;
        desc.width = width;
        desc.height = height;
        desc.camera = camera;
        desc.timeS = scene_.timeS;
        desc.samples = samples;
        EXPECT_TRUE(reference::loadWorld(scene_, world, error)) << error.text;
        EXPECT_TRUE(reference::prepareFrame(world, desc, frame, error)) << error.text;
        return reference::renderReference(frame, false).color;
    }

    static constexpr uint32_t width = 160, height = 90;
    Scene scene_;
    std::unique_ptr<Host> host_;
};

TEST_F(UnderwaterHost, LooksAsTheReferenceTracesIt) {
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    // The reference lights each face from where light comes from in water; the renderer knows no faces and
    // takes the host's light for that on a level bed, which is too much on walls that face a low sun.
    for (const auto& [name, most] : {std::pair{"below", 0.28}, {"straddle", 0.22}}) {
        const CameraDesc camera = cameraOf(scene_, name);
        const Picture traced = trace(camera, 4), rendered = render(camera);
        const Comparison c = compare(view(traced), view(rendered), PictureKind::linear, {});
        std::printf("%s: HDR-FLIP %.4f\n", name, c.flipMean);
        EXPECT_EQ(c.notFiniteInReference + c.notFiniteInTest, 0u);
        EXPECT_LT(c.flipMean, most) << name;
    }
    EXPECT_EQ(host_->validationMessages(), 0u);
}

TEST_F(UnderwaterHost, CrossingTheSurfaceByMillimetresNeverJumps) {
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    CameraDesc camera = cameraOf(scene_, "straddle");
    std::vector<Picture> pictures;
    constexpr int steps =
        30; // the near plane is some 8 cm high: through all of it in larger steps after these
    for (int i = -steps; i <= steps; ++i) {
        camera.positionM[1] = 0.001 * i;
        camera.targetM[1] = 0.6 + 0.001 * i;
        pictures.push_back(render(camera));
    }
    std::vector<double> changes;
    for (size_t i = 1; i < pictures.size(); ++i)
        changes.push_back(
            compare(view(pictures[i - 1]), view(pictures[i]), PictureKind::linear, {}).flipMean);
    for (size_t i = 2; i + 2 < changes.size(); ++i) {
        const double beside = std::max({changes[i - 2], changes[i - 1], changes[i + 1], changes[i + 2]});
        EXPECT_LT(changes[i], 1.5 * beside + 0.005) << "step to " << static_cast<int>(i) + 1 - steps << " mm";
    }
    std::printf("FLIP of a millimetre: %.4f to %.4f\n", *std::ranges::min_element(changes),
                *std::ranges::max_element(changes));
}

} // namespace
