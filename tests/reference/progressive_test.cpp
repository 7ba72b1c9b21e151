// A picture that gains its samples one at a time ends as the one that is drawn at once.
#include "demos/tools/reference/progressive.h"

#include "tests/reference/box_world.h"

#include <gtest/gtest.h>

namespace {

using namespace demos;

class Progressive : public testing::Test {
  protected:
    void SetUp() override {
        Error error;
        SunDesc sun;
        sun.elevationDeg = 15;
        ASSERT_TRUE(
            reference::makeLight(tests::evenSky(glm::vec3(0.4f, 0.6f, 0.8f)), {}, sun, world.light, error));
        tests::addMesh("boxes", tests::shiningBoxes(tests::harbourOfBoxes(), glm::vec3(0.1f)), world);
        WaterDesc water;
        water.waves = WavesDesc{};
        water.waves->samples = 64;
        ASSERT_TRUE(reference::setWater(water, world, error)) << error.text;
    }
    void prepare(uint32_t samples, reference::Frame& out) const {
        reference::FrameDesc desc = tests::smallFrame();
        desc.width = 48;
        desc.height = 27;
        desc.samples = samples;
        Error error;
        ASSERT_TRUE(reference::prepareFrame(world, desc, out, error)) << error.text;
    }

    reference::World world;
};

TEST_F(Progressive, EndsWithTheBitsOfThePictureDrawnAtOnce) {
    for (const uint32_t samples : {1u, 3u}) {
        reference::Frame frame;
        ASSERT_NO_FATAL_FAILURE(prepare(samples, frame));
        reference::Progressive picture(frame);
        while (!picture.done()) ASSERT_TRUE(picture.add());
        EXPECT_EQ(picture.samples(), samples);
        EXPECT_TRUE(picture.mean().rgba == reference::renderReference(frame, false).color.rgba) << samples;
    }
}

TEST_F(Progressive, ShowsTheMeanOfWhatItHas) {
    reference::Frame frame;
    ASSERT_NO_FATAL_FAILURE(prepare(2, frame));
    reference::Progressive picture(frame);
    ASSERT_TRUE(picture.add());
    const Picture first = picture.mean();
    ASSERT_TRUE(picture.add());
    const Picture both = picture.mean();
    double ofFirst = 0, ofBoth = 0;
    for (const float value : first.rgba) ofFirst += static_cast<double>(value);
    for (const float value : both.rgba) ofBoth += static_cast<double>(value);
    EXPECT_NEAR(ofFirst / ofBoth, 1, 0.05);
    EXPECT_FALSE(first.rgba == both.rgba);
}

TEST_F(Progressive, StopsWhenItIsTold) {
    reference::Frame frame;
    ASSERT_NO_FATAL_FAILURE(prepare(2, frame));
    reference::Progressive picture(frame);
    EXPECT_FALSE(picture.add([](uint32_t done, uint32_t all) {
        EXPECT_EQ(all, 27u);
        return done < 3;
    }));
    EXPECT_EQ(picture.samples(), 0u);
}

} // namespace
