// What is done to a reflection afterwards: the pyramid it is blurred from, and its stretch at the picture's
// borders.
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// RGBA, a mip of a reflection's colour each.
struct Mip {
    VkExtent2D extent;
    std::vector<float> rgba;
};

class Blur : public ReflectionTest {
  protected:
    void SetUp() override {
        ReflectionTest::SetUp();
        const ReflectorDesc desc;
        EXPECT_EQ(createReflector(context(), &desc, &reflector_), Status::ok) << message();
    }
    void TearDown() override {
        destroyReflector(reflector_);
        ReflectionTest::TearDown();
    }

    std::vector<Mip> mips(const TracedView& traced, const Camera& camera) {
        ViewDesc view = viewDesc(camera);
        const SceneOnDevice scene = upload(traced, view);
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &reflector_, 1, &view), Status::ok) << message();
        });
        const ReflectionImages images = reflectionImages(reflector_, 0);
        std::vector<Mip> out;
        for (uint32_t mip = 0; mip <= ReflectionDesc{}.blurLevels; ++mip) {
            const VkExtent2D extent = {images.extent.width >> mip, images.extent.height >> mip};
            out.push_back({extent, download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, extent, mip)});
        }
        return out;
    }

  private:
    Reflector* reflector_ = nullptr;
};

double binomialMean(const Mip& finer, uint32_t x, uint32_t y, uint32_t channel) {
    constexpr double weights[] = {0.125, 0.375, 0.375, 0.125};
    double sum = 0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const int column =
                std::clamp(static_cast<int>(2 * x) - 1 + i, 0, static_cast<int>(finer.extent.width) - 1);
            const int line =
                std::clamp(static_cast<int>(2 * y) - 1 + j, 0, static_cast<int>(finer.extent.height) - 1);
            const size_t at =
                (static_cast<size_t>(line) * finer.extent.width + static_cast<size_t>(column)) * 4;
            sum += weights[i] * weights[j] * double{finer.rgba[at + channel]};
        }
    return sum;
}

TEST_F(Blur, EachMipIsTheBinomialMeanOfTheOneBefore) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    const std::vector<Mip> pyramid = mips(traced, testCamera());
    // 480 x 272 halves four times, the last time from 17 rows.
    for (size_t mip = 1; mip < pyramid.size(); ++mip) {
        const Mip& coarser = pyramid[mip];
        double worst = 0, most = 0;
        for (uint32_t y = 0, i = 0; y < coarser.extent.height; ++y)
            for (uint32_t x = 0; x < coarser.extent.width; ++x)
                for (uint32_t channel = 0; channel < 4; ++channel, ++i) {
                    const double expected = binomialMean(pyramid[mip - 1], x, y, channel);
                    worst = std::max(worst, std::abs(double{coarser.rgba[i]} - expected));
                    most = std::max(most, expected);
                }
        EXPECT_GT(most, 0.3) << mip;
        // Linear samplers place a texel to 1/256.
        EXPECT_LE(worst, 0.006) << mip;
    }
}

TEST_F(Blur, AFireflyIsNotBlurredAndIsGoneAFrameLater) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    const std::vector<Mip> sound = mips(traced, testCamera());
    // Colours say which pixel they are.
    size_t mirrored = 0;
    while (sound[0].rgba[mirrored * 4 + 3] < 1) ++mirrored;
    const glm::ivec2 source(sound[0].rgba[mirrored * 4] * static_cast<float>(traced.width),
                            sound[0].rgba[mirrored * 4 + 1] * static_cast<float>(traced.height));
    for (const float value : {65504.0f, 1e30f, -65504.0f, -1e30f, NAN, INFINITY, -INFINITY}) {
        TracedView spoiled = traced;
        const size_t at = static_cast<size_t>(source.y) * traced.width + static_cast<size_t>(source.x);
        for (size_t channel = 0; channel < 3; ++channel) spoiled.color[at * 4 + channel] = value;
        const std::vector<Mip> pyramid = mips(spoiled, testCamera());
        size_t damaged = 0;
        for (size_t mip = 0; mip < pyramid.size(); ++mip)
            for (size_t i = 0; i < pyramid[mip].rgba.size(); i += 4) {
                float off = 0;
                for (size_t channel = 0; channel < 4; ++channel) {
                    EXPECT_TRUE(std::isfinite(pyramid[mip].rgba[i + channel])) << value;
                    off = std::max(off,
                                   std::abs(pyramid[mip].rgba[i + channel] - sound[mip].rgba[i + channel]));
                }
                damaged += off > 1.0f / 255 ? size_t{1} << 2 * mip : 0;
            }
        std::printf("%g: %zu pixels\n", double{value}, damaged);
        EXPECT_LE(damaged, 64u) << value;
        const std::vector<Mip> after = mips(traced, testCamera());
        for (size_t mip = 0; mip < after.size(); ++mip) EXPECT_EQ(after[mip].rgba, sound[mip].rgba);
    }
}

TEST_F(Blur, OffMakesNothing) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    size_t pipelines[2], dispatches[2];
    VkDeviceSize bytes[2];
    frame([](VkCommandBuffer) {});
    for (const uint32_t levels : {0u, 3u}) {
        ReflectorDesc desc;
        desc.reflection.technique = ReflectionTechnique::ssr;
        desc.reflection.blurLevels = levels;
        // The rig's own reflector blurs, and what pipelines it has are shared.
        Context* other = nullptr;
        std::string said;
        const DeviceDesc own = deviceDesc(&said);
        ASSERT_EQ(createContext(&own, &other), Status::ok) << said;
        spiedCalls().clear();
        Reflector* reflector = nullptr;
        ASSERT_EQ(createReflector(other, &desc, &reflector), Status::ok) << said;
        pipelines[levels > 0] = countSpied("CreateComputePipelines");
        destroyReflector(reflector);
        destroyContext(other);
        Estimate estimated;
        ASSERT_EQ(estimate(context(), &desc.reflection, {480, 272}, &estimated), Status::ok);
        dispatches[levels > 0] = estimated.dispatchesPerView;
        bytes[levels > 0] = estimated.bytesPerView;
        expectEstimateHolds(desc, {480, 272});
    }
    // Its cells', its tiles' and its rays'; a GPU's for tiles that nobody looks at.
    EXPECT_EQ(pipelines[0], 3 + onGpus(1));
    EXPECT_EQ(pipelines[1], pipelines[0] + 1);
    EXPECT_EQ(dispatches[0] + 3, dispatches[1]);
    EXPECT_GE(bytes[1] - bytes[0], VkDeviceSize{480} * 272 * 2); // that the first mip takes
}

class Stretch : public ReflectionTest {};

/// Looks down at the foot of a long wall: near the side borders its upper part is mirrored from beyond them.
Camera downwards() {
    Camera camera = testCamera();
    camera.eye = {0, 3.2, 6};
    camera.target = {0, 0.2, 0};
    return camera;
}

std::vector<Box> longWall() {
    return {{{-60, -1, -3}, {60, 1.6, -2}}};
}

ReflectorDesc stretched(float perMetre) {
    ReflectorDesc desc;
    desc.reflection.edgeStretch = perMetre;
    desc.reflection.edgeStretchBand = 0.2f;
    return desc;
}

/// Pixels whose mirrored point is known to lie left or right of the picture.
bool besideThePicture(const TracedView& traced, size_t i) {
    return traced.truth[i] == Truth::lost && (traced.source[i].x < 0 || traced.source[i].x >= traced.width);
}

TEST_F(Stretch, FillsWhatLiesBeyondTheSidesWithWhatLiesInside) {
    const TracedView traced = Tracer(downwards(), longWall()).run();
    const Reflected plain = reflectScene(downwards(), traced);
    const Reflected result = reflectScene(downwards(), traced, stretched(3));
    size_t beside = 0, knownBefore = 0, filled = 0, misled = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (!besideThePicture(traced, i)) continue;
        ++beside;
        knownBefore += plain.info[i] > 0;
        if (!(result.info[i] > 0)) continue;
        ++filled;
        const double confidence = double{result.color[i * 4 + 3]};
        if (confidence < 0.1) continue;
        // From its own side of the picture, and not from farther in than the band.
        const double from = double{result.color[i * 4]} / confidence;
        const bool right = traced.source[i].x > 0;
        misled += right ? from < 0.75 : from > 0.25;
    }
    std::printf("%zu beyond the sides: %zu known, %zu stretched over\n", beside, knownBefore, filled);
    EXPECT_GT(beside, 300u);
    EXPECT_LT(knownBefore, beside / 20);
    EXPECT_GT(filled, beside * 9 / 10);
    EXPECT_EQ(misled, 0u);
}

TEST_F(Stretch, MovesNothingInTheMiddle) {
    const TracedView traced = Tracer(downwards(), longWall()).run();
    const Reflected plain = reflectScene(downwards(), traced);
    const Reflected result = reflectScene(downwards(), traced, stretched(3));
    size_t moved = 0, movedBeside = 0;
    for (uint32_t y = 0; y < traced.height; ++y)
        for (uint32_t x = 0; x < traced.width; ++x) {
            const size_t i = size_t{y} * traced.width + x;
            const bool same = plain.info[i] == result.info[i] && plain.color[i * 4] == result.color[i * 4];
            const bool middle = x >= traced.width / 5 && x < traced.width - traced.width / 5;
            (middle ? moved : movedBeside) += !same;
        }
    EXPECT_EQ(moved, 0u);
    EXPECT_GT(movedBeside, 1000u);
}

// Stretched outwards: what a pixel near the right border shows lies left of what it showed, and more so
// towards it.
TEST_F(Stretch, ShowsWhatLiesFartherInside) {
    const TracedView traced = Tracer(downwards(), longWall()).run();
    const Reflected plain = reflectScene(downwards(), traced);
    const Reflected result = reflectScene(downwards(), traced, stretched(0.5f));
    size_t inside = 0, outside = 0;
    for (uint32_t y = 0; y < traced.height; ++y)
        for (uint32_t x = traced.width * 4 / 5; x < traced.width; ++x) {
            const size_t i = size_t{y} * traced.width + x;
            if (!(plain.info[i] > 0) || plain.color[i * 4 + 3] < 0.9f || result.color[i * 4 + 3] < 0.9f)
                continue;
            inside +=
                result.color[i * 4] / result.color[i * 4 + 3] < plain.color[i * 4] / plain.color[i * 4 + 3];
            outside += result.color[i * 4] / result.color[i * 4 + 3] >
                       plain.color[i * 4] / plain.color[i * 4 + 3] + 1e-3f;
        }
    EXPECT_GT(inside, 300u);
    EXPECT_EQ(outside, 0u);
}

// By the formula of edgeStretch, a pixel apart.
TEST_F(Stretch, TakesEachPixelFromWhereItSays) {
    const Camera camera = downwards();
    const TracedView traced = Tracer(camera, longWall()).run();
    constexpr float asked = 0.5f;
    const double perMetre = double{asked} * -glm::normalize(camera.target - camera.eye).y;
    const Reflected plain = reflectScene(camera, traced),
                    result = reflectScene(camera, traced, stretched(asked));
    const glm::dmat4 worldFromClip = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    const auto band = static_cast<int>(0.2 * traced.width);
    const double middle = 0.5 * traced.width;
    size_t seen = 0, asSaid = 0;
    for (uint32_t y = 0; y < traced.height; ++y)
        for (int index = 0; index < band; ++index) {
            const auto at = [&](int x) { return size_t{y} * traced.width + static_cast<size_t>(x); };
            const glm::dvec4 p = worldFromClip * glm::dvec4(2 * (index + 0.5) / traced.width - 1,
                                                            2 * (y + 0.5) / traced.height - 1, 0.5, 1);
            const double rise = -glm::normalize(glm::dvec3(p) / p.w - camera.eye).y;
            const double nearness = 1 - (index + 0.5) / band, most = band / (middle - band);
            // Where that pixel comes from if it shows what stands as high as what pixel x shows.
            const auto from = [&](int x) {
                const double height = double{plain.info[at(x)]} * rise;
                return static_cast<int>(middle - (middle - index - 0.5) /
                                                     (1 + std::min(height * perMetre, most) * nearness));
            };
            const auto isHit = [&](int x) {
                return plain.info[at(x)] > 0 && plain.color[at(x) * 4 + 3] == 1;
            };
            if (!isHit(index) || !isHit(from(index))) continue;
            const int place = from(from(index));
            if (!isHit(place)) continue;
            if (place == index) continue;
            ++seen;
            asSaid += result.color[at(index) * 4] == plain.color[at(place) * 4];
        }
    std::printf("%zu of %zu pixels from where they should be\n", asSaid, seen);
    EXPECT_GT(seen, 300u);
    EXPECT_GE(asSaid, seen * 9 / 10);
}

TEST_F(Stretch, FollowsTheRollOfTheCamera) {
    Camera rolled = downwards();
    rolled.rollDegrees = 90;
    std::swap(rolled.width, rolled.height);
    rolled.fovDegrees = 80;
    const TracedView traced = Tracer(rolled, longWall()).run();
    const Reflected plain = reflectScene(rolled, traced);
    const Reflected result = reflectScene(rolled, traced, stretched(3));
    size_t beside = 0, before = 0, after = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (traced.truth[i] != Truth::lost || (traced.source[i].y >= 0 && traced.source[i].y < traced.height))
            continue;
        ++beside;
        before += plain.info[i] > 0;
        after += result.info[i] > 0;
    }
    EXPECT_GT(beside, 100u);
    EXPECT_GT(after, before + beside / 2);
}

TEST_F(Stretch, LooksAlongTheWaterUnmoved) {
    Camera level = downwards();
    level.target.y = level.eye.y;
    const TracedView traced = Tracer(level, longWall()).run();
    const Reflected plain = reflectScene(level, traced);
    const Reflected result = reflectScene(level, traced, stretched(3));
    EXPECT_EQ(plain.info, result.info);
    EXPECT_EQ(plain.color, result.color);
}

TEST_F(Stretch, GivesTheSameBitsEachTime) {
    const TracedView traced = Tracer(downwards(), longWall()).run();
    const Reflected first = reflectScene(downwards(), traced, stretched(3));
    for (int i = 0; i < 5; ++i) {
        const Reflected again = reflectScene(downwards(), traced, stretched(3));
        EXPECT_EQ(first.color, again.color);
        EXPECT_EQ(first.info, again.info);
    }
}

TEST_F(Stretch, CostsOneDispatchAndNoMemory) {
    const Estimate off = expectEstimateHolds(stretched(0), {480, 272});
    const Estimate on = expectEstimateHolds(stretched(1), {480, 272});
    EXPECT_EQ(on.dispatchesPerView, off.dispatchesPerView + 1);
    EXPECT_EQ(on.bytesPerView, off.bytesPerView);
}

TEST_F(Stretch, OutOfRangeIsNamed) {
    const auto refused = [&](auto&& spoil) {
        ReflectorDesc desc;
        spoil(desc.reflection);
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::invalidArgument);
        return message();
    };
    const auto names = [](const std::string& text, const char* field) {
        return text.find(field) != std::string::npos;
    };
    EXPECT_TRUE(names(refused([](ReflectionDesc& d) { d.edgeStretch = -1; }), "edgeStretch"));
    EXPECT_TRUE(names(refused([](ReflectionDesc& d) { d.edgeStretchBand = 0; }), "edgeStretchBand"));
    EXPECT_TRUE(names(refused([](ReflectionDesc& d) { d.clearDistance = NAN; }), "clearDistance"));
    EXPECT_TRUE(names(refused([](ReflectionDesc& d) { d.scatter = 2; }), "scatter"));
    EXPECT_TRUE(names(refused([](ReflectionDesc& d) { d.skyFadeDistance = -1; }), "skyFadeDistance"));
    EXPECT_TRUE(names(refused([](ReflectionDesc& d) { d.blurLevels = 7; }), "blurLevels"));
}

class EdgeFade : public ReflectionTest {};

/// From where a mirrored point is seen to the border, going on from the pixel that mirrors it [pixel].
double pixelsToBorder(const TracedView& traced, size_t mirror) {
    const glm::dvec2 pixel(double(mirror % traced.width) + 0.5, double(mirror / traced.width) + 0.5);
    const glm::dvec2 source = traced.source[mirror];
    const glm::dvec2 along = glm::normalize(source - pixel);
    const double x = along.x > 0 ? traced.width - source.x : source.x;
    const double y = along.y > 0 ? traced.height - source.y : source.y;
    return std::min(x / std::max(std::abs(along.x), 1e-9), y / std::max(std::abs(along.y), 1e-9));
}

/// Whether the pixel in which a point is seen shows, in its middle, what lies on the plane or under it:
/// colour is then taken beside the point, where what was met shows.
bool showsBelow(const Camera& camera, const TracedView& traced, const glm::dvec2& source) {
    const glm::dvec2 pixel = glm::floor(source), size(traced.width, traced.height);
    const double depth{traced.depth[static_cast<size_t>(pixel.y * size.x + pixel.x)]};
    const glm::dvec4 world = glm::inverse(projectionMatrix(camera) * viewMatrix(camera)) *
                             glm::dvec4(2.0 * (pixel + 0.5) / size - 1.0, depth, 1);
    return world.y < 0.01 * world.w;
}

TEST_F(EdgeFade, IsASmootherStepOverItsWidthBeforeTheBorder) {
    const Box wall{{-60, -1, -9}, {60, 60, -8}};
    for (const ReflectionTechnique technique : {ReflectionTechnique::sspr, ReflectionTechnique::ssr})
        for (const double roll : {0.0, 35.0, 90.0})
            for (const float edgeFade : {0.3f, 0.5f}) {
                Camera camera = testCamera();
                camera.rollDegrees = roll;
                const TracedView traced = Tracer(camera, {wall}).run();
                ReflectorDesc desc = with(technique);
                desc.reflection.edgeFade = edgeFade;
                const Reflected result = reflectScene(camera, traced, desc);
                const double width = double{edgeFade} * camera.height;
                size_t atBorder = 0, halfway = 0, beyond = 0;
                for (size_t i = 0; i < result.info.size(); ++i) {
                    if (traced.truth[i] != Truth::recoverable || !(result.info[i] > 0)) continue;
                    if (showsBelow(camera, traced, traced.source[i])) continue;
                    const double x = pixelsToBorder(traced, i) / width;
                    const double confidence = double{result.color[i * 4 + 3]};
                    const double t = std::min(x, 1.0);
                    ASSERT_NEAR(confidence, t * t * t * (t * (6 * t - 15) + 10), 0.02)
                        << "rolled " << roll << ", width " << width << ", share of it " << x;
                    if (x < 0.03) {
                        ++atBorder;
                        EXPECT_LT(confidence, 0.001);
                    } else if (std::abs(x - 0.5) < 0.02) {
                        ++halfway;
                        EXPECT_NEAR(confidence, 0.5, 0.05);
                    } else if (x > 1) {
                        ++beyond;
                        EXPECT_GT(confidence, 0.999);
                    }
                }
                EXPECT_GT(atBorder, 50u) << roll << ", " << width;
                EXPECT_GT(halfway, 50u) << roll << ", " << width;
                EXPECT_GT(beyond, 1000u) << roll << ", " << width;
            }
}

/// From where a mirrored point is seen to the nearest border [pixel].
double pixelsToNearestBorder(const TracedView& traced, size_t mirror) {
    const glm::dvec2 source = traced.source[mirror];
    return std::min({source.x, source.y, traced.width - source.x, traced.height - source.y});
}

TEST_F(EdgeFade, MayBeOfAllFourBorders) {
    const Box wall{{-60, -1, -9}, {60, 60, -8}};
    for (const ReflectionTechnique technique : {ReflectionTechnique::sspr, ReflectionTechnique::ssr}) {
        const Camera camera = testCamera();
        const TracedView traced = Tracer(camera, {wall}).run();
        ReflectorDesc desc = with(technique);
        desc.reflection.edgeFade = 0.3f;
        desc.reflection.edgeFadeAround = true;
        const Reflected result = reflectScene(camera, traced, desc);
        const double width = 0.3 * camera.height;
        size_t atSides = 0, inside = 0;
        for (size_t i = 0; i < result.info.size(); ++i) {
            if (traced.truth[i] != Truth::recoverable || !(result.info[i] > 0)) continue;
            const double t = std::min(pixelsToNearestBorder(traced, i) / width, 1.0);
            ASSERT_NEAR(double{result.color[i * 4 + 3]}, t * t * t * (t * (6 * t - 15) + 10), 0.02) << t;
            if (t < 0.5 && pixelsToBorder(traced, i) > width) ++atSides;
            if (t == 1) ++inside;
        }
        EXPECT_GT(atSides, 300u);
        EXPECT_GT(inside, 1000u);
    }
}

TEST_F(EdgeFade, OfNoWidthFadesNothing) {
    const TracedView traced = Tracer(testCamera(), {{{-60, -1, -9}, {60, 60, -8}}}).run();
    ReflectorDesc desc;
    desc.reflection.edgeFade = 0;
    const Reflected result = reflectScene(testCamera(), traced, desc);
    size_t hits = 0;
    for (size_t i = 0; i < result.info.size(); ++i) {
        if (!(result.info[i] > 0)) continue;
        ++hits;
        EXPECT_EQ(result.color[i * 4 + 3], 1);
    }
    EXPECT_GT(hits, 10000u);
}

} // namespace
