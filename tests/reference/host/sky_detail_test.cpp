// Clouds ragged between the texels of a sky's picture: finer than those, as bright in the mean, and only
// where a frame asks for it and shows it.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/host.h"
#include "tests/program/run.h"

namespace {

using namespace demos;

/// Lat-long, Radiance HDR, of `rows` and twice as many columns: clouds down to a row, dark below.
std::string skyOf(int rows, int clouds) {
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(rows) + " +X " +
                       std::to_string(2 * rows) + "\n";
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x) {
            file += std::string(3, static_cast<char>(y < clouds ? 200 : 50));
            file += static_cast<char>(128); // exponent: 200 stands for 0.78
        }
    return file;
}

class SkyDetail : public testing::Test {
  protected:
    SkyDetail() {
        HostDesc desc;
        desc.validation = true;
        host_ = Host::create(desc, error_);
        EXPECT_TRUE(host_) << error_.text;
        scene_.sky.file = testing::TempDir() + "sky_detail.hdr";
        scene_.sun.irradiance = {0, 0, 0};
        CameraDesc& camera = scene_.cameras.emplace_back();
        camera.positionM = {0, 2, 0};
        camera.targetM = {-10, 2 + 10 * std::tan(std::numbers::pi / 6), 0};
        camera.verticalFovDeg = 20;
    }
    ~SkyDetail() override { EXPECT_EQ(host_->validationMessages(), 0u); }

    void load(int rows, int clouds, double detail = 1) {
        tests::writeAll(scene_.sky.file, skyOf(rows, clouds));
        scene_.sky.detail = detail;
        ASSERT_TRUE(host_->load(scene_, error_)) << error_.text;
    }
    std::vector<float> draw(bool detailed = true) {
        FrameDesc frame{width_, height_, scene_.cameras[0]};
        frame.skyDetail = detailed;
        const std::optional<Picture> picture = host_->render(frame, error_);
        EXPECT_TRUE(picture) << error_.text;
        return picture ? picture->rgba : std::vector<float>(size_t{width_} * height_ * 4);
    }

    uint32_t width_ = 240, height_ = 80;
    Scene scene_;
    Error error_;
    std::unique_ptr<Host> host_;
};

double meanOf(const std::vector<float>& rgba) {
    double sum = 0;
    for (size_t i = 0; i < rgba.size(); i += 4) sum += static_cast<double>(rgba[i]);
    return 4 * sum / static_cast<double>(rgba.size());
}

/// How far down clouds reach in each column [pixels], by what lies between their radiance and the dark's.
std::vector<double> edgeOf(const std::vector<float>& rgba, uint32_t width) {
    constexpr double bright = 200.0 / 256, dark = 50.0 / 256;
    std::vector<double> edge(width);
    for (size_t i = 0; i < rgba.size(); i += 4)
        edge[i / 4 % width] += (static_cast<double>(rgba[i]) - dark) / (bright - dark);
    return edge;
}

TEST_F(SkyDetail, RagsCloudsBetweenTexelsAndKeepsTheMean) {
    constexpr double texel = 80 / 20.0 * (180.0 / 128); // [pixels]
    load(128, 43);
    const std::vector<float> ragged = draw(), plain = draw(false);
    const std::vector<double> edge = edgeOf(ragged, width_), straight = edgeOf(plain, width_);
    double squares = 0, sum = 0;
    int turns = 0;
    for (size_t x = 0; x < width_; ++x) {
        sum += edge[x] - straight[x];
        squares += std::pow(edge[x] - straight[x], 2);
        if (x > 1) turns += (edge[x] - edge[x - 1]) * (edge[x - 1] - edge[x - 2]) < 0;
    }
    const double rms = std::sqrt(squares / width_) / texel, mean = sum / width_ / texel;
    std::printf("edge %.2f texels off, %.2f in the mean, turns %d times in %.1f texels\n", rms, mean, turns,
                width_ / texel);
    EXPECT_GT(rms, 0.15);
    EXPECT_LT(rms, 0.8) << "shapes that the file has are kept";
    EXPECT_LT(std::abs(mean), 0.25);
    EXPECT_GT(turns, 0.5 * width_ / texel) << "which of its own an edge cannot, that has a texel's width";
    EXPECT_NEAR(meanOf(ragged) / meanOf(plain), 1, 0.05);
}

TEST_F(SkyDetail, LeavesAnEvenSkyAsItIs) {
    load(32, 32);
    EXPECT_EQ(draw(), draw(false));
}

TEST_F(SkyDetail, EndsWherePixelsAreWiderThanTexels) {
    width_ = height_;
    scene_.cameras[0].verticalFovDeg = 90;
    load(512, 176);
    EXPECT_EQ(draw(), draw(false));
}

TEST_F(SkyDetail, IsNoneUnlessTheSceneAndTheFrameSaySo) {
    load(32, 11, 0);
    const std::vector<float> none = draw();
    EXPECT_EQ(none, draw(false));
    load(32, 11);
    EXPECT_EQ(none, draw(false));
    EXPECT_NE(none, draw());
}

} // namespace
