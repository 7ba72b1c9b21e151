// Temporal reuse: steadier where pictures are jittered, exact where nothing changes, and never a ghost.
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

ReflectorDesc with(ReflectionTechnique technique, float temporal) {
    ReflectorDesc desc = tests::with(technique);
    desc.reflection.temporal = temporal;
    return desc;
}

Camera smallCamera() {
    Camera camera = testCamera();
    camera.width = 240;
    camera.height = 136;
    return camera;
}

/// Of Halton's sequence to the bases 2 and 3, within half a pixel.
glm::dvec2 halton(uint32_t index) {
    glm::dvec2 at(-0.5);
    for (int axis = 0; axis < 2; ++axis) {
        const uint32_t base = axis == 0 ? 2 : 3;
        double digit = 1;
        for (uint32_t i = index % 16 + 1; i > 0; i /= base) {
            digit /= base;
            at[axis] += digit * (i % base);
        }
    }
    return at;
}

/// A pattern that stays with the world.
glm::vec3 colorOf(const glm::dvec3& world) {
    return glm::vec3(0.5 + 0.4 * glm::sin(world * glm::dvec3(1.4, 1.9, 1.2)));
}

glm::dvec2 middleOf(const Camera& camera, size_t i) {
    return {static_cast<double>(i % camera.width) + 0.5, static_cast<double>(i / camera.width) + 0.5};
}

glm::dvec3 worldAt(const glm::dmat4& inverse, const Camera& camera, size_t i, double depth) {
    const glm::dvec2 size(camera.width, camera.height);
    const glm::dvec4 p = inverse * glm::dvec4(middleOf(camera, i) / size * 2.0 - 1.0, depth, 1);
    return glm::dvec3(p) / p.w;
}

/// The boxes as a game would have them: each place of the world has its colour.
TracedView painted(const Camera& camera, const std::vector<Box>& boxes) {
    TracedView traced = Tracer(camera, boxes).run();
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    for (size_t i = 0; i < traced.depth.size(); ++i) {
        const double depth = double{traced.depth[i]};
        const bool sky = depth == (camera.reversed ? 0 : 1);
        const glm::vec3 color = sky ? glm::vec3(1) : colorOf(worldAt(inverse, camera, i, depth));
        for (int c = 0; c < 3; ++c) traced.color[i * 4 + static_cast<size_t>(c)] = color[c];
    }
    return traced;
}

/// What a pixel mirrors, and how far from the mirror [m]; the sky is infinitely far.
struct Mirrored {
    glm::vec3 color{0};
    double distance = std::numeric_limits<double>::infinity();
};

Mirrored mirroredAt(const Camera& camera, const std::vector<Box>& boxes, const glm::dvec2& pixel) {
    const glm::dvec2 size(camera.width, camera.height);
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    const glm::dvec4 p = inverse * glm::dvec4(pixel / size * 2.0 - 1.0, 0.5, 1);
    const glm::dvec3 ray = glm::normalize(glm::dvec3(p) / p.w - camera.eye);
    const glm::dvec3 on = camera.eye - ray * (camera.eye.y / ray.y);
    const glm::dvec3 up = ray * glm::dvec3(1, -1, 1);
    const double hit = nearestHit(boxes, on, up);
    if (std::isinf(hit)) return {};
    return {colorOf(on + up * hit), hit};
}

/// What is mirrored all over each pixel, premultiplied by how much of it is no sky.
std::vector<glm::dvec4> mirroredOver(const Camera& camera, const std::vector<Box>& boxes,
                                     const TracedView& traced) {
    constexpr uint32_t samples = 16;
    std::vector<glm::dvec4> whole(traced.truth.size(), glm::dvec4(0));
    for (size_t i = 0; i < whole.size(); ++i)
        for (uint32_t s = 0; traced.truth[i] != Truth::none && s < samples; ++s) {
            const Mirrored seen = mirroredAt(camera, boxes, middleOf(camera, i) + halton(s));
            if (std::isfinite(seen.distance)) whole[i] += glm::dvec4(seen.color, 1) / double{samples};
        }
    return whole;
}

double differenceAt(const Reflected& reflected, size_t i, const glm::dvec4& from) {
    double sum = 0;
    for (size_t c = 0; c < 4; ++c)
        sum += std::abs(double{reflected.color[i * 4 + c]} - from[static_cast<int>(c)]);
    return sum / 4;
}

class Temporal : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {
  protected:
    void TearDown() override {
        for (Reflector* const reflector : reflectors_) destroyReflector(reflector);
        ReflectionTest::TearDown();
    }

    Reflector* make(const ReflectorDesc& desc) {
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        return reflectors_.emplace_back(reflector);
    }
    Reflector* make(float temporal) { return make(with(GetParam(), temporal)); }

    Reflected next(Reflector* reflector, const TracedView& traced, ViewDesc view) {
        const SceneOnDevice scene = upload(traced, view);
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
        });
        const ReflectionImages images = reflectionImages(reflector, view.viewIndex);
        return {download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
    }

    static ViewDesc viewOf(const Camera& camera) {
        ViewDesc view = viewDesc(camera);
        view.jitter[0] = camera.jitter.x;
        view.jitter[1] = camera.jitter.y;
        return view;
    }

  private:
    std::vector<Reflector*> reflectors_;
};

void expectSame(const Reflected& one, const Reflected& other, const char* what) {
    EXPECT_EQ(one.info, other.info) << what;
    EXPECT_EQ(one.color, other.color) << what;
}

double rootMeanSquare(const std::vector<double>& values) {
    const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

bool isFinite(const Reflected& reflected) {
    const auto finite = [](float v) { return std::isfinite(v); };
    return std::ranges::all_of(reflected.color, finite) && std::ranges::all_of(reflected.info, finite);
}

TEST_P(Temporal, WithoutItNothingIsMadeOrDispatched) {
    useOwnContext();
    struct Cost {
        size_t pipelines, images, dispatches;
        VkDeviceSize bytes;
    };
    const TracedView traced = painted(smallCamera(), harbourOfBoxes());
    const auto costOf = [&](float temporal) {
        spiedCalls().clear();
        next(make(temporal), traced, viewOf(smallCamera()));
        return Cost{countSpied("CreateComputePipelines"), countSpied("CreateImage"),
                    countSpied("CmdDispatch") + countSpied("CmdDispatchIndirect"), bytesSpied()};
    };
    costOf(0); // makes uniform blocks
    costOf(0);
    const Cost none = costOf(0), some = costOf(0.9f);
    EXPECT_EQ(none.images, 2u);
    EXPECT_EQ(some.pipelines, 2u); // those of the technique are there already
    EXPECT_EQ(some.images, none.images + 4);
    EXPECT_EQ(some.dispatches, none.dispatches + 2 + onGpus(1)); // what nobody looks at
    EXPECT_GT(some.bytes, none.bytes);
    expectEstimateHolds(with(GetParam(), 0), {240, 136});
    expectEstimateHolds(with(GetParam(), 0.9f), {240, 136});
}

TEST_P(Temporal, AFirstFrameAndOneAfterACutAreAsWithout) {
    Camera camera = smallCamera();
    Reflector* const without = make(0.0f);
    Reflector* const reusing = make(0.9f);
    for (int i = 0; i < 6; ++i) {
        camera.eye.x += 0.7; // far enough for histories to tell
        camera.jitter = halton(static_cast<uint32_t>(i));
        const TracedView traced = painted(camera, harbourOfBoxes());
        ViewDesc view = viewOf(camera);
        view.cut = i == 3;
        const Reflected fresh = next(without, traced, view), reused = next(reusing, traced, view);
        if (i == 0 || i == 3)
            expectSame(reused, fresh, i == 0 ? "first" : "cut");
        else
            EXPECT_NE(reused.color, fresh.color) << i;
    }
}

TEST_P(Temporal, WhatStandsStillStaysAsItIsToTheBit) {
    for (Pose& pose : poses()) {
        const bool rolled = pose.camera.rollDegrees == 35;
        pose.camera.width /= rolled ? 1 : 2;
        pose.camera.height /= rolled ? 1 : 2;
        const TracedView traced = painted(pose.camera, harbourOfBoxes());
        ReflectorDesc desc = with(GetParam(), 0.9f);
        desc.reflection.downscale = rolled ? 2 : 1;
        Reflector* const reflector = make(desc);
        const Reflected first = next(reflector, traced, viewOf(pose.camera));
        for (int i = 0; i < 4; ++i)
            expectSame(next(reflector, traced, viewOf(pose.camera)), first, pose.name);
    }
}

TEST_P(Temporal, AfterAChangeItComesToTheSamePicture) {
    const Camera camera = smallCamera();
    TracedView traced = painted(camera, harbourOfBoxes());
    Reflector* const reflector = make(0.9f);
    next(reflector, traced, viewOf(camera));
    for (float& value : traced.color) value *= 1.02f; // the light changes, within what is around
    const Reflected expected = next(make(0.0f), traced, viewOf(camera));
    Reflected reused;
    for (int i = 0; i < 60; ++i) reused = next(reflector, traced, viewOf(camera));
    expectSame(reused, expected, "at last");
}

struct Steadiness {
    double flicker = 0; ///< from frame to frame
    double error = 0;   ///< against the mean of what is mirrored all over a pixel
};

TEST_P(Temporal, JitteredFramesShimmerLess) {
    const std::vector<Box> boxes = harbourOfBoxes();
    Camera camera = smallCamera();
    const TracedView still = Tracer(camera, boxes).run();
    const std::vector<glm::dvec4> whole = mirroredOver(camera, boxes, still);
    const auto steadinessOf = [&](float temporal) {
        ReflectorDesc desc = with(GetParam(), temporal);
        desc.reflection.edgeFade = 0;
        desc.reflection.marchThickness = 0.5f; // sky behind what is thinner stays taken for it, reused or not
        Reflector* const reflector = make(desc);
        Steadiness sum;
        Reflected last;
        size_t compared = 0;
        for (uint32_t n = 0; n < 32; ++n) {
            camera.jitter = halton(n);
            const Reflected now = next(reflector, painted(camera, boxes), viewOf(camera));
            EXPECT_TRUE(isFinite(now));
            for (size_t i = 0; n >= 24 && i < whole.size(); ++i) {
                if (still.truth[i] != Truth::recoverable && still.truth[i] != Truth::sky) continue;
                ++compared;
                glm::dvec4 before;
                for (size_t c = 0; c < 4; ++c) before[static_cast<int>(c)] = double{last.color[i * 4 + c]};
                sum.flicker += differenceAt(now, i, before);
                sum.error += differenceAt(now, i, whole[i]);
            }
            last = now;
        }
        sum.flicker /= static_cast<double>(compared);
        sum.error /= static_cast<double>(compared);
        return sum;
    };
    const Steadiness without = steadinessOf(0), reusing = steadinessOf(0.9f);
    std::printf("flicker %.5f without, %.5f reusing; error %.5f, %.5f\n", without.flicker, reusing.flicker,
                without.error, reusing.error);
    EXPECT_LE(reusing.flicker, 0.25 * without.flicker);
    EXPECT_LE(reusing.error, 0.66 * without.error);
    const std::map<ReflectionTechnique, double> most = {{ReflectionTechnique::sspr, 0.0046},
                                                        {ReflectionTechnique::ssr, 0.0041},
                                                        {ReflectionTechnique::hybrid, 0.0048}};
    EXPECT_LE(reusing.error, most.at(GetParam()));
}

// A camera that drives past: the error against what each pixel mirrors must not grow.
TEST_P(Temporal, MovingCamerasTrailNothing) {
    const std::vector<Box> boxes = harbourOfBoxes();
    struct Motion {
        const char* name;
        glm::dvec3 eye, target;
        double roll;
    };
    for (const Motion& motion :
         {Motion{"sideways", {0.06, 0, 0}, {0.06, 0, 0}, 0}, Motion{"turning", {0, 0, 0}, {0.08, 0.01, 0}, 0},
          Motion{"forward and rolling", {0, -0.01, -0.15}, {0, 0, 0}, 0.5}}) {
        Camera camera = smallCamera();
        const auto unfaded = [&](float temporal) {
            ReflectorDesc desc = with(GetParam(), temporal);
            desc.reflection.edgeFade = 0;
            return make(desc);
        };
        Reflector* const without = unfaded(0);
        Reflector* const reusing = unfaded(0.9f);
        Reflected fresh, reused;
        TracedView traced;
        for (int n = 0; n < 12; ++n) {
            camera.eye += motion.eye;
            camera.target += motion.target;
            camera.rollDegrees += motion.roll;
            traced = painted(camera, boxes);
            fresh = next(without, traced, viewOf(camera));
            reused = next(reusing, traced, viewOf(camera));
        }
        const std::vector<glm::dvec4> whole = mirroredOver(camera, boxes, traced);
        std::vector<double> freshErrors, reusedErrors;
        size_t compared = 0, otherClass = 0;
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            if (traced.truth[i] != Truth::recoverable && traced.truth[i] != Truth::sky) continue;
            ++compared;
            otherClass += reflectionClass(reused.info[i]) != reflectionClass(fresh.info[i]);
            freshErrors.push_back(differenceAt(fresh, i, whole[i]));
            reusedErrors.push_back(differenceAt(reused, i, whole[i]));
        }
        const double freshError = rootMeanSquare(freshErrors), reusedError = rootMeanSquare(reusedErrors);
        std::printf("%-20s error %.5f without, %.5f reusing; %zu of %zu of another class\n", motion.name,
                    freshError, reusedError, otherClass, compared);
        EXPECT_LE(reusedError, freshError) << motion.name;
        EXPECT_LE(otherClass, compared / 100) << motion.name;
    }
}

/// A wall across the picture, of which each pixel that mirrors it is a hit up to the border.
std::vector<Box> wallAhead() {
    return {{{-60, -1, -9}, {60, 60, -8}}};
}

// As the camera moves by parts of pixels, the surroundings of a pixel would allow for a colour a pixel aside.
TEST_P(Temporal, WhatMovesByPartsOfPixelsStaysInPlace) {
    Camera camera = smallCamera();
    camera.width = 160;
    camera.height = 90;
    Reflector* const without = make(0.0f);
    Reflector* const reusing = make(0.9f);
    Reflected fresh, reused;
    TracedView traced;
    for (int n = 0; n < 12; ++n) {
        camera.eye.x += 0.03;
        camera.target.x += 0.03;
        traced = painted(camera, wallAhead());
        fresh = next(without, traced, viewOf(camera));
        reused = next(reusing, traced, viewOf(camera));
    }
    // Against what shows half a pixel aside, and in the same place.
    std::vector<double> off, aside;
    for (size_t i = camera.width + 2; i + 2 < traced.truth.size(); ++i) {
        const size_t x = i % camera.width;
        if (x < 4 || x + 4 >= camera.width) continue;
        bool inside = true;
        for (size_t n = i - 2; n <= i + 2; ++n)
            inside &=
                traced.truth[n] == Truth::recoverable && fresh.info[n] > 0 && fresh.color[n * 4 + 3] == 1.0f;
        if (!inside) continue;
        off.push_back(double{reused.color[i * 4]} - double{fresh.color[i * 4]});
        aside.push_back((double{fresh.color[i * 4 + 4]} - double{fresh.color[i * 4]}) / 2);
    }
    std::printf("%zu pixels off by %.5f, half a pixel by %.5f\n", off.size(), rootMeanSquare(off),
                rootMeanSquare(aside));
    EXPECT_GT(off.size(), 1000u);
    EXPECT_LT(rootMeanSquare(off), 0.3 * rootMeanSquare(aside));
}

// The last row and the last column are as the others.
TEST_P(Temporal, PixelsAtTheBorderRememberToo) {
    for (const double roll : {0.0, 90.0}) {
        Camera camera = smallCamera();
        camera.target.y = camera.eye.y; // so that a column mirrors what it shows
        camera.rollDegrees = roll;
        camera.width = camera.height = 120;
        ReflectorDesc desc = with(GetParam(), 0.9f);
        desc.reflection.edgeFade = 0;
        Reflector* const reflector = make(desc);
        TracedView traced = painted(camera, wallAhead());
        const Reflected first = next(reflector, traced, viewOf(camera));
        for (float& value : traced.color) value *= 1.01f; // within what is around
        const Reflected second = next(reflector, traced, viewOf(camera));
        const auto remember = [&](size_t inside) {
            size_t hits = 0, kept = 0;
            for (size_t n = 0; n < 120; ++n) {
                const size_t i = roll == 0 ? n * 120 + 119 - inside : (119 - inside) * 120 + n;
                if (!(second.info[i] > 0) || traced.truth[i] != Truth::recoverable) continue;
                ++hits;
                // Green differs by more than the light changes from what is above and below.
                const float then = 1.01f * first.color[i * 4 + 1];
                kept += std::abs(second.color[i * 4 + 1] - then) > 0.002f * then;
            }
            EXPECT_GT(hits, 20u) << roll;
            return static_cast<double>(kept) / static_cast<double>(hits);
        };
        const double last = remember(0), before = remember(1);
        std::printf("roll %2.0f: %.3f of the last pixels remember, %.3f of those before\n", roll, last,
                    before);
        EXPECT_GT(before, 0.3);
        EXPECT_NEAR(last, before, 0.2);
    }
}

/// The test's own scene, with a crate that can be taken away or put in the way.
std::vector<Box> harbourWith(const Box& crate) {
    std::vector<Box> boxes = harbourOfBoxes();
    boxes.push_back(crate);
    return boxes;
}

TEST_P(Temporal, WhatIsTakenAwayLeavesNoGhost) {
    const Camera camera = smallCamera();
    const Box crate{{-2.4, 0, -4}, {1.6, 1.1, -3}};
    const TracedView before = painted(camera, harbourWith(crate)), after = painted(camera, harbourOfBoxes());
    Reflector* const reflector = make(0.95f);
    for (int i = 0; i < 8; ++i) next(reflector, before, viewOf(camera));
    const Reflected was = next(make(0.0f), before, viewOf(camera));
    const Reflected fresh = next(make(0.0f), after, viewOf(camera));
    const Reflected reused = next(reflector, after, viewOf(camera));
    size_t changed = 0, ghosts = 0;
    for (size_t i = 0; i < fresh.info.size(); ++i) {
        if (fresh.info[i] == 0 || was.info[i] <= 0 || after.truth[i] == Truth::none) continue;
        // What lies at another distance now.
        if (fresh.info[i] > 0 && std::abs(fresh.info[i] - was.info[i]) < 0.5f * was.info[i]) continue;
        ++changed;
        glm::dvec4 now;
        for (size_t c = 0; c < 4; ++c) now[static_cast<int>(c)] = double{fresh.color[i * 4 + c]};
        ghosts += differenceAt(reused, i, now) > 0.05;
    }
    std::printf("%zu changed, %zu of them show what was\n", changed, ghosts);
    EXPECT_GT(changed, 250u);
    EXPECT_LE(ghosts, changed / 25); // at silhouettes, within what is around
}

/// Floats before the tower up to the sky, so that nothing tells what it hides; and before nothing of its
/// mirror image.
const Box board{{0.3, 2.3, 1}, {1.4, 4.8, 1.2}};

TEST_P(Temporal, WhatIsHiddenIsKeptForAWhileWithLessAndLessConfidence) {
    const Camera camera = smallCamera();
    const TracedView before = painted(camera, harbourOfBoxes());
    const TracedView after = painted(camera, harbourWith(board));
    ReflectorDesc desc = with(GetParam(), 0.8f);
    desc.reflection.edgeFade = 0;
    Reflector* const reflector = make(desc);
    desc.reflection.temporal = 0;
    const Reflected was = next(reflector, before, viewOf(camera));
    const Reflected fresh = next(make(desc), after, viewOf(camera));
    std::vector<size_t> holes;
    for (size_t i = 0; i < fresh.info.size(); ++i)
        if (fresh.info[i] == 0 && was.info[i] > 0 && after.truth[i] != Truth::none) holes.push_back(i);
    EXPECT_GT(holes.size(), 150u);
    for (int n = 1; n <= 20; ++n) {
        const Reflected reused = next(reflector, after, viewOf(camera));
        const double kept = std::pow(0.8, n);
        size_t asKept = 0;
        for (const size_t i : holes) {
            const bool hit = reused.info[i] > 0;
            // Never without confidence.
            EXPECT_EQ(hit, reused.color[i * 4 + 3] > 0);
            EXPECT_FALSE(hit && kept < 1.0 / 32);
            if (!hit) continue;
            EXPECT_NEAR(reused.info[i], was.info[i], 0.02 * was.info[i]);
            bool like = true;
            for (size_t c = 0; c < 4; ++c)
                like = like && std::abs(reused.color[i * 4 + c] - kept * was.color[i * 4 + c]) < 0.02;
            asKept += like;
        }
        EXPECT_GE(asKept, n <= 10 ? holes.size() * 9 / 10 : 0) << n;
    }
}

TEST_P(Temporal, WhatIsHiddenIsKeptWhereItIsWhileTheCameraMoves) {
    ReflectorDesc desc = with(GetParam(), 0.8f);
    desc.reflection.edgeFade = 0;
    Reflector* const reflector = make(desc);
    desc.reflection.temporal = 0;
    Reflector* const without = make(desc);
    Camera camera = smallCamera();
    next(reflector, painted(camera, harbourOfBoxes()), viewOf(camera));
    for (int n = 1; n <= 4; ++n) {
        camera.eye += glm::dvec3(0.1, 0.03, -0.15);
        const TracedView hidden = painted(camera, harbourWith(board));
        const Reflected whole = next(without, painted(camera, harbourOfBoxes()), viewOf(camera));
        const Reflected fresh = next(without, hidden, viewOf(camera));
        const Reflected reused = next(reflector, hidden, viewOf(camera));
        // Hidden undersides are taken for what lies behind them, without the board, too: not to be kept.
        const auto isTrue = [&](size_t i) {
            const double distance = mirroredAt(camera, harbourOfBoxes(), middleOf(camera, i)).distance;
            return std::abs(double{whole.info[i]} - distance) < 0.1 * distance;
        };
        size_t holes = 0, known = 0, inPlace = 0, ofItsColor = 0;
        for (size_t i = 0; i < fresh.info.size(); ++i) {
            if (fresh.info[i] != 0 || !(whole.info[i] > 0) || hidden.truth[i] == Truth::none) continue;
            if (!isTrue(i)) continue;
            ++holes;
            if (!(reused.info[i] > 0)) continue;
            ++known;
            inPlace += std::abs(reused.info[i] - whole.info[i]) < 0.01f * whole.info[i];
            glm::dvec4 kept;
            for (size_t c = 0; c < 4; ++c)
                kept[static_cast<int>(c)] = std::pow(0.8, n) * double{whole.color[i * 4 + c]};
            ofItsColor += differenceAt(reused, i, kept) < 0.05;
        }
        std::printf("%zu holes, %zu known, %zu in place, %zu of their colour\n", holes, known, inPlace,
                    ofItsColor);
        EXPECT_GT(holes, 100u) << n;
        EXPECT_GE(known, holes / 5) << n; // others have been hidden for longer
        EXPECT_GE(inPlace, known * 17 / 20) << n;
        EXPECT_GE(ofItsColor, known * 7 / 10) << n;
    }
}

TEST_P(Temporal, ABrokenPixelIsGoneInTheNextFrame) {
    const Camera camera = smallCamera();
    const TracedView traced = painted(camera, harbourOfBoxes());
    TracedView broken = traced;
    const float values[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            65504.0f};
    for (size_t i = 0; i < broken.color.size(); i += 4 * 37)
        for (size_t c = 0; c < 3; ++c) broken.color[i + c] = values[i / 148 % 3];
    const Reflected clean = next(make(0.0f), traced, viewOf(camera));
    for (const bool first : {true, false}) {
        Reflector* const reflector = make(0.9f);
        if (!first) next(reflector, traced, viewOf(camera));
        const Reflected during = next(reflector, broken, viewOf(camera));
        EXPECT_TRUE(isFinite(during));
        const Reflected after = next(reflector, traced, viewOf(camera));
        EXPECT_TRUE(isFinite(after));
        size_t off = 0;
        for (size_t i = 0; i < clean.color.size(); ++i) off += after.color[i] > 1.0f;
        EXPECT_EQ(off, 0u);
    }
}

TEST_P(Temporal, BeginsAnewWhereItCannotFollow) {
    Camera camera = smallCamera();
    Reflector* const reflector = make(0.9f);
    Reflector* const without = make(0.0f);
    const auto expectFresh = [&](const char* what, bool fresh) {
        const TracedView traced = painted(camera, harbourOfBoxes());
        const Reflected expected = next(without, traced, viewOf(camera));
        const Reflected reused = next(reflector, traced, viewOf(camera));
        EXPECT_EQ(reused.color == expected.color, fresh) << what;
    };
    expectFresh("first", true);
    camera.eye.x += 0.4;
    expectFresh("goes on", false);
    camera.width = 200;
    expectFresh("resized", true);
    camera.eye.x += 0.4;
    expectFresh("goes on", false);
    camera.reversed = false;
    expectFresh("the other depth", true);
    camera.eye.x += 0.4;
    expectFresh("goes on", false);
    camera.eye.y = -camera.eye.y;
    expectFresh("through the plane", true);
}

TEST_P(Temporal, FramesInWhichItIsNotSeenEndIt) {
    Camera camera = smallCamera();
    ReflectorDesc desc = with(GetParam(), 0.9f);
    std::ranges::copy(std::array{-40.0, 0.0, -40.0}, desc.boundsLow);
    std::ranges::copy(std::array{40.0, 0.1, 4.0}, desc.boundsHigh);
    Reflector* const reflector = make(desc);
    next(reflector, painted(camera, harbourOfBoxes()), viewOf(camera));
    Camera away = camera;
    away.target.z = 2 * camera.eye.z;
    next(reflector, painted(away, harbourOfBoxes()), viewOf(away));
    camera.eye.x += 0.4;
    const TracedView traced = painted(camera, harbourOfBoxes());
    desc.reflection.temporal = 0;
    expectSame(next(reflector, traced, viewOf(camera)), next(make(desc), traced, viewOf(camera)),
               "seen again");
}

/// A region may wander in its target, and other views come between.
TEST_P(Temporal, ViewsKeepTheirOwnHistories) {
    Reflector* const alone = make(0.9f);
    Reflector* const shared = make(0.9f);
    Camera camera = smallCamera(), other = smallCamera();
    other.width = 120;
    other.rollDegrees = 20;
    for (uint32_t i = 0; i < 6; ++i) {
        camera.eye.x += 0.1;
        camera.jitter = halton(i);
        other.eye.z -= 0.1;
        const TracedView traced = painted(camera, harbourOfBoxes());
        const Reflected expected = next(alone, traced, viewOf(camera));
        ViewDesc moved = viewOf(camera);
        moved.viewport.x = static_cast<float>(3 * i);
        moved.viewport.y = static_cast<float>(i);
        expectSame(next(shared, framed(traced, 3 * i, i), moved), expected, "among others");
        ViewDesc second = viewOf(other);
        second.viewIndex = 3;
        next(shared, painted(other, harbourOfBoxes()), second);
    }
}

TEST_P(Temporal, BadInputIsNamed) {
    const auto refused = [&](float temporal) {
        const ReflectorDesc desc = with(GetParam(), temporal);
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::invalidArgument);
        return message();
    };
    for (const float temporal : {-0.1f, 0.96f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_NE(refused(temporal).find("ReflectionDesc.temporal"), std::string::npos) << message();
    Reflector* reflector = make(0.5f);
    for (const double jitter : {17.0, -17.0, std::numeric_limits<double>::quiet_NaN()}) {
        ViewDesc view = viewOf(smallCamera());
        const SceneOnDevice scene = upload(painted(smallCamera(), {}), view);
        view.jitter[1] = jitter;
        frame([&](VkCommandBuffer commands) {
            spiedCalls().clear();
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::invalidArgument);
            EXPECT_TRUE(spiedCalls().empty());
        });
        EXPECT_NE(message().find("ViewDesc.jitter"), std::string::npos) << message();
    }
}

INSTANTIATE_TEST_SUITE_P(, Temporal,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid),
                         nameOf);

} // namespace
