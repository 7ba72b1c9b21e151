// What flat water shows of the reflection that was computed for it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/gpu/rig/sea_rig.h"
#include "tests/gpu/rig/traced_scene.h"

namespace {

using namespace seaglass;
using namespace tests;

/// Before the boxes of a harbour.
Camera boxCamera() {
    Camera camera = seaCamera();
    camera.eye = {-1, 2.2, 9};
    camera.target = {-0.5, 1.2, 0};
    return camera;
}

/// The boxes over flat water, and what the reflection image knows of each pixel.
struct Mirrored {
    std::vector<float> color; ///< RGBA, before Fresnel
    std::vector<float> info;
};

class FlatWater : public SeaTest {
  protected:
    Body* mirroring(const ReflectionDesc& reflection) {
        BodyDesc desc;
        desc.reflection = &reflection;
        return makeBody(desc);
    }
    Mirrored mirrored(const ReflectionDesc& reflection, const TracedView& traced) {
        Body* body = mirroring(reflection);
        const WaterPicture p =
            picture({body}, boxCamera(), 0, SurfaceOutput::reflection, {traced.color, traced.depth});
        const ReflectionImages images = reflectionImages(body, 0);
        return {p.color, download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
    }
};

TEST_F(FlatWater, ShowsTheTracedReflection) {
    Body* body = mirroring({});
    const Camera camera = boxCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const WaterPicture p =
        picture({body}, camera, 0, SurfaceOutput::reflection, {traced.color, traced.depth});
    std::vector<double> errors;
    size_t skyPixels = 0, skyRight = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        const float* c = &p.color[i * 4];
        if (traced.truth[i] == Truth::recoverable)
            errors.push_back(glm::length(glm::dvec2(c[0], c[1]) * glm::dvec2(traced.width, traced.height) -
                                         traced.source[i]));
        if (traced.truth[i] == Truth::sky) {
            ++skyPixels;
            skyRight += std::abs(c[0] - 1) < 0.02 && std::abs(c[1] - 2) < 0.04 && std::abs(c[2] - 3) < 0.06;
        }
    }
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.6);
    EXPECT_LT(errors[errors.size() * 9 / 10], 3);
    EXPECT_GT(static_cast<double>(skyRight), 0.98 * static_cast<double>(skyPixels));
}

/// What a picture shows, at an offset in a larger one of nothing but sky.
SceneBehind placedIn(const Camera& larger, const TracedView& traced, uint32_t left, uint32_t top) {
    const size_t pixels = size_t{larger.width} * larger.height;
    SceneBehind placed{std::vector<float>(pixels * 4, 9.0f), std::vector<float>(pixels, 0.0f)};
    for (uint32_t y = 0; y < traced.height; ++y) {
        const size_t from = size_t{y} * traced.width, to = size_t{y + top} * larger.width + left;
        std::copy_n(&traced.color[from * 4], size_t{traced.width} * 4, &placed.color[to * 4]);
        std::copy_n(&traced.depth[from], traced.width, &placed.depth[to]);
    }
    return placed;
}

TEST_F(FlatWater, ShowsTheSameReflectionWithinALargerPicture) {
    Camera alone = boxCamera();
    alone.width = 200;
    alone.height = 120;
    Camera larger = alone;
    larger.width = 248;
    larger.height = 144;
    constexpr uint32_t left = 40, top = 16;
    const TracedView traced = Tracer(alone, harbourOfBoxes()).run();
    for (const uint32_t downscale : {1u, 2u}) {
        ReflectionDesc reflection;
        reflection.downscale = downscale;
        Body* body = mirroring(reflection);
        changeView = nullptr;
        const WaterPicture expected =
            picture({body}, alone, 0, SurfaceOutput::reflection, {traced.color, traced.depth});
        changeView = [&](ViewDesc& view) {
            view.viewport = {left, top, 200, 120, 0, 1};
            copyMatrix(projectionMatrix(alone), view.projection);
        };
        const WaterPicture found = picture({mirroring(reflection)}, larger, 0, SurfaceOutput::reflection,
                                           placedIn(larger, traced, left, top));
        size_t water = 0;
        double worst = 0;
        for (uint32_t y = 0; y < alone.height; ++y)
            for (uint32_t x = 0; x < alone.width; ++x) {
                const size_t a = size_t{y} * alone.width + x, b = size_t{y + top} * larger.width + x + left;
                ASSERT_EQ(expected.covered(a), found.covered(b));
                if (!expected.covered(a)) continue;
                ++water;
                for (size_t c = 0; c < 3; ++c)
                    worst = std::max(
                        worst, std::abs(double{expected.color[a * 4 + c]} - double{found.color[b * 4 + c]}));
            }
        EXPECT_GT(water, 10000u);
        EXPECT_LT(worst, 1e-3) << "downscale " << downscale;
    }
}

bool sameColor(const std::vector<float>& a, const std::vector<float>& b, size_t pixel, float tolerance) {
    for (size_t i = pixel * 4; i < pixel * 4 + 3; ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;
    return true;
}

TEST_F(FlatWater, ScatterBlursBeyondTheClearDistanceAlone) {
    const TracedView traced = Tracer(boxCamera(), harbourOfBoxes()).run();
    ReflectionDesc desc;
    const Mirrored sharp = mirrored(desc, traced);
    desc.scatter = 0.2f;
    desc.clearDistance = 2;
    const Mirrored scattered = mirrored(desc, traced);
    desc.blurLevels = 0;
    const Mirrored withoutMips = mirrored(desc, traced);
    size_t near = 0, nearMoved = 0, far = 0, farMoved = 0, movedWithoutMips = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (traced.truth[i] != Truth::recoverable) continue;
        const bool moved = !sameColor(sharp.color, scattered.color, i, 1e-4f);
        movedWithoutMips += !sameColor(sharp.color, withoutMips.color, i, 1e-4f);
        if (sharp.info[i] > 0 && sharp.info[i] < 1.99f) ++near, nearMoved += moved;
        if (sharp.info[i] > 4) ++far, farMoved += moved;
    }
    EXPECT_GT(near, 300u);
    EXPECT_GT(far, 300u);
    EXPECT_EQ(nearMoved, 0u);
    EXPECT_GT(farMoved, far * 9 / 10);
    EXPECT_EQ(movedWithoutMips, 0u);
}

TEST_F(FlatWater, FadesToTheSkyWithDistance) {
    const TracedView traced = Tracer(boxCamera(), harbourOfBoxes()).run();
    ReflectionDesc desc;
    const Mirrored plain = mirrored(desc, traced);
    desc.skyFadeDistance = 6;
    const Mirrored faded = mirrored(desc, traced);
    size_t near = 0, nearSame = 0, far = 0, farSky = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (traced.truth[i] != Truth::recoverable || !(plain.info[i] > 0)) continue;
        if (plain.info[i] < 3) ++near, nearSame += sameColor(plain.color, faded.color, i, 1e-4f);
        if (plain.info[i] >= 6) {
            ++far;
            farSky +=
                std::abs(faded.color[i * 4] - 1) < 0.01f && std::abs(faded.color[i * 4 + 1] - 2) < 0.02f;
        }
    }
    EXPECT_GT(near, 300u);
    EXPECT_GT(far, 100u);
    EXPECT_EQ(nearSame, near);
    EXPECT_EQ(farSky, far);
}

// Texels of a smaller reflection lie under what stands before the water, too, and know nothing.
TEST_F(FlatWater, ASmallerReflectionLetsNoSkyInAlongWhatStandsBeforeIt) {
    const TracedView traced = Tracer(boxCamera(), harbourOfBoxes()).run();
    for (const uint32_t downscale : {2u, 4u}) {
        ReflectionDesc desc;
        desc.downscale = downscale;
        const Mirrored result = mirrored(desc, traced);
        const int reach = static_cast<int>(downscale);
        size_t beside = 0, skyInIt = 0;
        double squares = 0;
        size_t counted = 0;
        for (int y = reach; y < static_cast<int>(traced.height) - reach; ++y)
            for (int x = reach; x < static_cast<int>(traced.width) - reach; ++x) {
                const auto at = [&](int column, int line) {
                    return static_cast<size_t>(line) * traced.width + static_cast<size_t>(column);
                };
                const size_t i = at(x, y);
                if (traced.truth[i] != Truth::recoverable) continue;
                const glm::dvec2 shown = glm::dvec2(result.color[i * 4], result.color[i * 4 + 1]) -
                                         traced.source[i] / glm::dvec2(traced.width, traced.height);
                squares += glm::dot(shown, shown);
                ++counted;
                bool hits = true, stands = false;
                for (int dy = -reach; dy <= reach; ++dy)
                    for (int dx = -reach; dx <= reach; ++dx) {
                        const Truth truth = traced.truth[at(x + dx, y + dy)];
                        hits = hits && truth != Truth::sky && truth != Truth::lost;
                        stands = stands || (truth == Truth::none && traced.depth[at(x + dx, y + dy)] > 0);
                    }
                if (!hits || !stands) continue;
                ++beside;
                // The scene's blue is 1, the sky's 3.
                skyInIt += result.color[i * 4 + 2] > 1.2f;
            }
        const double psnr = 10 * std::log10(2 * static_cast<double>(counted) / squares);
        std::printf("1/%u: PSNR %.2f dB, %zu of %zu beside things are the sky's in part\n", downscale, psnr,
                    skyInIt, beside);
        EXPECT_GT(beside, 300u);
        EXPECT_LE(skyInIt, beside / 25) << downscale;
        EXPECT_GE(psnr, 13.5) << downscale;
    }
}

TEST_F(FlatWater, SaysWhereTheReflectionIsTakenFrom) {
    Body* body = mirroring({});
    const Camera camera = boxCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const SceneBehind behind = {traced.color, traced.depth};
    const WaterPicture colors = picture({body}, camera, 0, SurfaceOutput::reflection, behind);
    const WaterPicture sources = picture({body}, camera, 0, SurfaceOutput::reflectionSource, behind);
    std::vector<double> fromTruth, fromColors;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        const float* const source = &sources.color[i * 4];
        if (source[3] != 2.0f || traced.truth[i] != Truth::recoverable) continue;
        const glm::dvec2 pixel(source[0], source[1]);
        const float* const c = &colors.color[i * 4];
        fromTruth.push_back(glm::length(pixel - traced.source[i]));
        fromColors.push_back(
            glm::length(glm::dvec2(c[0], c[1]) * glm::dvec2(traced.width, traced.height) - pixel));
    }
    ASSERT_GT(fromTruth.size(), 1000u);
    std::ranges::sort(fromTruth);
    std::ranges::sort(fromColors);
    EXPECT_LT(fromTruth[fromTruth.size() / 2], 0.15);
    EXPECT_LT(fromTruth[fromTruth.size() * 9 / 10], 0.5);
    // Colours are those of whole pixels.
    EXPECT_LT(fromColors[fromColors.size() / 2], 0.6);

    const WaterPicture sky = picture({makeBody({})}, camera, 0, SurfaceOutput::reflectionSource, behind);
    for (size_t i = 0; i < traced.truth.size(); ++i)
        if (sky.covered(i)) {
            const float* const source = &sky.color[i * 4];
            ASSERT_TRUE(source[0] == -1.0f && source[1] == -1.0f && source[3] == 1.0f) << i;
        }
}

} // namespace
