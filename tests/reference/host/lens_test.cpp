// The host's lens: light that strays is not lost, frames that are averaged show what more samples would, and
// nothing of it is left in what is measured.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "host/lens/bloom.h"
#include "host/lens/temporal.h"
#include "host/vulkan/rendering.h"
#include "tests/gpu/rig/rig.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"
#include "tests/reference/box_file.h"
#include "tests/reference/rendered_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 96, height = 61;

/// A fence in the sun, before dark water.
Scene fence() {
    Scene scene;
    scene.sky.file = testing::TempDir() + "lens_sky.hdr";
    tests::writeAll(scene.sky.file, tests::sampleSky());
    scene.sky.intensity = 0.05;
    scene.sun.azimuthDeg = 70;
    scene.sun.irradiance = {9, 8, 7};
    std::vector<tests::Box> posts;
    for (int i = -6; i <= 6; ++i)
        posts.push_back({{0.9 * i - 0.08, -1, -0.08}, {0.9 * i + 0.08, 3 + 0.1 * i, 0.08}});
    scene.meshes.push_back({tests::writeBoxes("fence", posts, 0.9)});
    scene.water.emplace();
    CameraDesc& camera = scene.cameras.emplace_back();
    camera.positionM = {0.3, 2.2, 9};
    camera.targetM = {0, 1.2, 0};
    camera.rollDeg = 7;
    return scene;
}

class Lens : public testing::Test {
  protected:
    Lens() {
        HostDesc desc;
        desc.validation = true;
        host_ = Host::create(desc, error_);
        EXPECT_TRUE(host_ && host_->load(scene_, error_)) << error_.text;
        frame_ = {width, height, scene_.cameras[0]};
    }
    ~Lens() override { EXPECT_EQ(host_->validationMessages(), 0u); }

    std::vector<float> draw(const FrameDesc& frame) {
        const std::optional<Picture> picture = host_->render(frame, error_);
        EXPECT_TRUE(picture) << error_.text;
        return picture ? picture->rgba : std::vector<float>(size_t{width} * height * 4);
    }
    /// As the viewer does.
    std::vector<float> averaged(uint32_t frames, double stepS) {
        FrameDesc frame = frame_;
        frame.temporal = true;
        std::vector<float> last;
        for (uint32_t i = 0; i < frames; ++i) {
            frame.follows = i > 0;
            frame.jitterPx = jitterOf(i);
            last = draw(frame);
            if (i + 1 < frames) frame.timeS += stepS;
        }
        frame_.timeS = frame.timeS;
        return last;
    }

    const Scene scene_ = fence();
    Error error_;
    std::unique_ptr<Host> host_;
    FrameDesc frame_;
};

double meanOf(const std::vector<float>& rgba, size_t channel) {
    double sum = 0;
    for (size_t i = channel; i < rgba.size(); i += 4) sum += static_cast<double>(rgba[i]);
    return 4 * sum / static_cast<double>(rgba.size());
}

/// Root of the mean square.
double apart(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::pow(static_cast<double>(a[i] - b[i]), 2);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST_F(Lens, StrayLightIsNotLost) {
    const std::vector<float> bare = draw(frame_);
    frame_.bloom = true;
    const std::vector<float> bloomed = draw(frame_);
    for (size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(meanOf(bloomed, channel) / meanOf(bare, channel), 1, 0.005) << channel;
    double brightest = 0, darkest = 1e9;
    size_t brightAt = 0, darkAt = 0;
    for (size_t i = 1; i < bare.size(); i += 4) {
        const auto value = static_cast<double>(bare[i]);
        if (value > brightest) brightAt = i;
        if (value < darkest) darkAt = i;
        brightest = std::max(brightest, value);
        darkest = std::min(darkest, value);
    }
    std::printf("brightest %.3f to %.3f, darkest %.4f to %.4f\n", brightest,
                static_cast<double>(bloomed[brightAt]), darkest, static_cast<double>(bloomed[darkAt]));
    EXPECT_LT(bloomed[brightAt], bare[brightAt]);
    EXPECT_GT(bloomed[darkAt], bare[darkAt]);
    EXPECT_LT(apart(bloomed, bare), 0.2 * meanOf(bare, 1)) << "it is a small share";
    frame_.bloom = false;
    EXPECT_EQ(draw(frame_), bare) << "nothing of it is left";
}

TEST_F(Lens, FramesOfWhatStandsAverageToManySamples) {
    const std::vector<float> one = draw(frame_), many = averaged(17, 0), after = draw(frame_);
    const std::vector<float> truth = tests::rendered(*host_, scene_, width, height).rgba;
    std::printf("%.4f from the truth, one frame %.4f\n", apart(many, truth), apart(one, truth));
    EXPECT_LT(apart(many, truth), 0.5 * apart(one, truth));
    EXPECT_EQ(after, one) << "nothing of it is left";
}

TEST_F(Lens, WhatMovesLeavesNoTrail) {
    frame_.camera.keyframes = {{2, {3.3, 2.2, 9}, {3, 1.2, 0}, 7}};
    const std::vector<float> moved = averaged(10, 0.1), bare = draw(frame_);
    FrameDesc before = frame_;
    before.timeS -= 0.1;
    const double trail = apart(moved, bare), step = apart(draw(before), bare);
    std::printf("%.4f from the frame alone, which is %.4f from that before\n", trail, step);
    EXPECT_LT(trail, 0.5 * step);
}

// A picture that no scene gives.
constexpr VkExtent2D extent = {64, 36};
constexpr VkOffset2D broken = {21, 17};

void clear(VkCommandBuffer commands, const VkRect2D& where, float light) {
    VkClearAttachment attachment{VK_IMAGE_ASPECT_COLOR_BIT, 0, {}};
    attachment.clearValue.color = {{light, light, light, 1}};
    const VkClearRect rect = {where, 0, 1};
    vkCmdClearAttachments(commands, 1, &attachment, 1, &rect);
}

TEST(Bloom, LeavesWhatIsBrokenWhereItIs) {
    Device& device = tests::device();
    const uint32_t messagesBefore = device.validationMessages();
    Error error;
    FrameTargets targets;
    Bloom bloom;
    ASSERT_TRUE(createFrameTargets(device, extent, targets, error) && bloom.fit(device, targets, error))
        << error.text;
    for (const float light :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        const auto record = [&](VkCommandBuffer commands, Error&) {
            targets.colorToAttachment(commands, VK_IMAGE_LAYOUT_UNDEFINED);
            beginRendering(commands, extent, targets.color.view.get(), VK_ATTACHMENT_LOAD_OP_CLEAR,
                           VK_NULL_HANDLE, VK_ATTACHMENT_LOAD_OP_DONT_CARE, 0);
            clear(commands, {{0, 0}, extent}, 0.5f);
            clear(commands, {broken, {1, 1}}, light);
            vkCmdEndRendering(commands);
            bloom.record(commands, targets);
            targets.copyBack(commands, targets.color);
            return true;
        };
        ASSERT_TRUE(device.run(record, error)) << error.text;
        const Picture picture = readColor(targets);
        for (uint32_t y = 0; y < extent.height; ++y)
            for (uint32_t x = 0; x < extent.width; ++x) {
                if (x == uint32_t(broken.x) && y == uint32_t(broken.y)) continue;
                // What is broken shines on nothing.
                EXPECT_NEAR(picture.rgba[(size_t{y} * extent.width + x) * 4], 0.5, 0.01) << x << ", " << y;
            }
    }
    EXPECT_EQ(device.validationMessages(), messagesBefore);
}

} // namespace
