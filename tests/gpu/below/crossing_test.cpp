// An eye that passes the calm plane amid waves: what it sees is mirrored by where the waves are, not that
// plane.
#include <cmath>
#include <optional>
#include <tuple>

#include <glm/gtc/packing.hpp>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/reflection_rig.h"
#include "tests/gpu/rig/water_rig.h"
#include "water/body/body.h"
#include "water/reflection/mirrored_level.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double place[2] = {3, 7}; ///< of the eye
constexpr float wallRadiance = 3;

/// How far along a ray from the eye's place the wall stands, or less than 0.
double toWall(double height, const glm::dvec3& ray) {
    const double along = ray.z < 0 ? -12 / ray.z : -1;
    return std::abs(along * ray.x) < 5 && height + along * ray.y < 4 ? along : -1;
}

class CrossingTest : public WaterTest {
  protected:
    CrossingTest() {
        for (float& channel : lighting.skyIrradiance) channel = 2;
        desc_.refraction = &refraction_;
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
        desc_.reflection = &reflection_;
    }

    double wavesAt(const Body& body, double time) const {
        HeightSample sample;
        sampleHeights(*seaglass::sea(&body), time, place, 1, &sample);
        return double{sample.height};
    }

    /// When the waves at the eye are so high.
    double timeOf(const Body& body, double low, double high) const {
        for (double time = 0; time < 200; time += 0.25)
            if (const double height = wavesAt(body, time); height >= low && height <= high) return time;
        ADD_FAILURE() << "no wave of " << low << " to " << high << " m";
        return 0;
    }

    WaterPicture at(Body* body, double height, double time) {
        Camera camera;
        camera.eye = {place[0], height, place[1]};
        camera.target = {place[0], height - 0.5, -10};
        camera.width = width_;
        camera.height = width_ * 9 / 16;
        const ViewDesc view = viewDesc(camera);
        PlanarView wanted;
        std::optional<DrawnBuffers> mirrored;
        if (reflection_.technique == ReflectionTechnique::planar) {
            // Once more for the buffers, which take a submission of their own.
            frame([&](VkCommandBuffer commands) {
                EXPECT_EQ(simulate(commands, &body, 1, time), Status::ok) << message();
                EXPECT_EQ(planarView(body, &view, &wanted), Status::ok) << message();
            });
            mirrored.emplace(wallIn(wanted, projectionMatrix(camera)));
            beforeReflection = [&](VkCommandBuffer commands) {
                EXPECT_EQ(planarView(body, &view, &wanted), Status::ok) << message();
                recordDrawing(commands, wanted, *mirrored);
            };
        }
        WaterPicture drawn = picture({body}, camera, time, SurfaceOutput::shaded,
                                     drawnOver(camera, nothingBehind(camera), wallRadiance,
                                               [&](const glm::dvec3& ray) { return toWall(height, ray); }));
        beforeReflection = nullptr;
        return drawn;
    }

    SeaDesc sea_ = breeze();
    ReflectionDesc reflection_;
    RefractionDesc refraction_{{0.4f, 0.15f, 0.05f}, {0.01f, 0.02f, 0.03f}, 1};
    UnderwaterDesc underwater_;
    BodyDesc desc_;
    uint32_t width_ = 160;

  private:
    /// As the mirrored camera sees the wall, clipped by its depth as a rasterizer clips.
    static Drawn wallIn(const PlanarView& view, const glm::dmat4& hostProjection) {
        Drawn out;
        const glm::dmat4 clip = matrix(view.projection) * matrix(view.view);
        const glm::dmat4 inverse = glm::inverse(hostProjection * matrix(view.view));
        const auto eye = glm::dvec3(glm::inverse(matrix(view.view))[3]);
        for (uint32_t y = 0; y < view.extent.height; ++y)
            for (uint32_t x = 0; x < view.extent.width; ++x) {
                const glm::dvec4 p = inverse * glm::dvec4((x + 0.5) / view.extent.width * 2 - 1,
                                                          (y + 0.5) / view.extent.height * 2 - 1, 0.5, 1);
                const glm::dvec3 ray = glm::normalize(glm::dvec3(p) / p.w - eye);
                const double along = toWall(eye.y, ray);
                const glm::dvec4 hit = clip * glm::dvec4(eye + along * ray, 1);
                const bool shown = along > 0 && hit.w > 0 && hit.z >= 0 && hit.z <= hit.w;
                out.depth.push_back(shown ? static_cast<float>(hit.z / hit.w) : view.clearDepth);
                out.color.push_back(shown ? glm::packHalf4x16(glm::vec4(wallRadiance)) : 0);
            }
        return out;
    }
};

// Below the calm plane in a trough as over a crest: the plane that is mirrored in lies a little below an eye
// in the air, and above one in the water.
TEST_F(CrossingTest, TheMirrorLiesOnTheWavesSideOfTheEye) {
    const UnderwaterDesc underwater;
    desc_.underwater = &underwater;
    Body* const body = makeBody(desc_);
    for (const double time : {timeOf(*body, -9, -0.1), timeOf(*body, 0.1, 9)}) {
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(simulate(commands, &body, 1, time), Status::ok) << message();
        });
        for (const double over : {-0.3, -0.03, 0.03, 0.3}) {
            Camera camera;
            camera.eye = {place[0], wavesAt(*body, time) + over, place[1]};
            camera.target = camera.eye - glm::dvec3(0, 0.2, 1);
            ViewGeometry view;
            ASSERT_STREQ(readCamera(viewDesc(camera), view).text(), "");
            std::optional<EyeOverWaves> last;
            const double under = camera.eye.y - mirroredLevel(*body, view, last).raised;
            EXPECT_GT(over > 0 ? under : -under, 0.099) << over << " over the waves at " << time << " s";
        }
    }
}

class Crossing : public CrossingTest, public testing::WithParamInterface<ReflectionTechnique> {
  protected:
    Crossing() { reflection_.technique = GetParam(); }

    /// Share of pixels that differ by over 2 % of the wall's radiance.
    static double apart(const WaterPicture& a, const WaterPicture& b) {
        size_t off = 0;
        for (size_t i = 0; i < a.color.size(); i += 4) off += std::abs(a.color[i] - b.color[i]) > 0.06f;
        return static_cast<double>(off) / static_cast<double>(a.color.size() / 4);
    }
};

TEST_P(Crossing, TheCalmPlaneIsNoBorder) {
    for (const bool mayDive : {false, true}) {
        desc_.underwater = mayDive ? &underwater_ : nullptr;
        Body* const body = makeBody(desc_);
        for (const double side : {-1.0, 1.0}) {
            if (side > 0 && !mayDive) continue;
            const double time = side < 0 ? timeOf(*body, -0.6, -0.3) : timeOf(*body, 0.3, 0.6);
            const double jump = apart(at(body, 1e-6, time), at(body, -1e-6, time));
            const double step = apart(at(body, 2e-3, time), at(body, 3e-3, time));
            std::printf("%s, %s: %.4f of the pixels, %.4f by a step beside it\n",
                        mayDive ? "underwater" : "surface alone", side < 0 ? "trough" : "crest", jump, step);
            EXPECT_LE(jump, 0.002);
        }
    }
}

// By 5 mm: as far as the waterline itself moves.
TEST_P(Crossing, TheReflectionGoesAndComesWithTheWaves) {
    desc_.underwater = &underwater_;
    Body* const body = makeBody(desc_);
    const double time = timeOf(*body, -0.6, -0.3);
    const double waves = wavesAt(*body, time);
    std::vector<double> steps;
    WaterPicture last = at(body, waves + 0.15, time);
    for (int i = 1; i <= 60; ++i) {
        WaterPicture next = at(body, waves + 0.15 - 0.005 * i, time);
        steps.push_back(apart(last, next));
        last = std::move(next);
    }
    double worst = 0;
    for (size_t i = 2; i + 2 < steps.size(); ++i) {
        double around[] = {steps[i - 2], steps[i - 1], steps[i + 1], steps[i + 2]};
        std::ranges::sort(around);
        worst = std::max(worst, steps[i] - 1.5 * 0.5 * (around[1] + around[2]));
    }
    std::printf("at most %.4f of the pixels beyond 1.5 times the steps beside\n", worst);
    EXPECT_LE(worst, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Crossing,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid, ReflectionTechnique::planar),
                         nameOf);

struct Steps {
    ReflectionTechnique technique;
    float wind; ///< [m/s]
};

/// An eye that rises by a millimetre from picture to picture.
class CrossingInSteps : public CrossingTest, public testing::WithParamInterface<Steps> {
  protected:
    static constexpr uint32_t coarse = 96; ///< pixels across
    static constexpr int beside = 4;       ///< steps before one, and behind it, that it is compared with

    CrossingInSteps() {
        reflection_.technique = GetParam().technique;
        sea_.windSpeed = GetParam().wind;
        desc_.underwater = &underwater_;
        width_ = coarse;
    }

    /// Of the wall's radiance, in the mean over all pixels.
    static double apart(const WaterPicture& a, const WaterPicture& b) {
        double sum = 0;
        for (size_t i = 0; i < a.color.size(); ++i)
            if (i % 4 != 3)
                sum += std::min(std::abs(double{a.color[i]} - double{b.color[i]}), double{wallRadiance});
        return sum / static_cast<double>(a.color.size() / 4 * 3) / double{wallRadiance};
    }

    /// What each of `count` steps from `low` on changes.
    std::vector<double> changes(Body* body, double time, double low, double step, int count) {
        std::vector<double> steps;
        WaterPicture last = at(body, low, time);
        for (int i = 1; i <= count; ++i) {
            WaterPicture next = at(body, low + step * i, time);
            steps.push_back(apart(last, next));
            last = std::move(next);
        }
        return steps;
    }

    /// By how much a step exceeds 1.5 times the median of those beside it.
    static double excessOf(const std::vector<double>& steps, int i) {
        const int count = static_cast<int>(steps.size());
        std::vector<double> around;
        for (int k = std::max(i - beside, 0); k <= std::min(i + beside, count - 1); ++k)
            if (k != i) around.push_back(steps[static_cast<size_t>(k)]);
        std::ranges::nth_element(around, around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2));
        return steps[static_cast<size_t>(i)] - 1.5 * around[around.size() / 2];
    }

    /// Steps from `low` on: none stands out of those beside it. A quick change is none that stands out of
    /// steps of a tenth. The wall's upper edge moves by a row of pixels at once, every 0.2 m: less in a
    /// picture of smaller ones. A jump is one whatever the steps and the pixels.
    void expectNoJump(Body* body, double time, double low, int count, double step = 1e-3) {
        constexpr double anyway = 1e-3; // as much as a few pixels at outlines
        constexpr double finest = 1e-4;
        const std::vector<double> steps = changes(body, time, low, step, count);
        for (int i = 0; i < count; ++i) {
            const double excess = excessOf(steps, i), from = low + step * i;
            if (excess > anyway && step > finest) {
                expectNoJump(body, time, from - step, 30, finest);
            } else if (excess > anyway && width_ == coarse) {
                std::printf("%.5f from %.4f m on, %u pixels wide\n", excess, from, width_);
                width_ = 4 * coarse;
                expectNoJump(body, time, from - 6 * step, 13, step);
                width_ = coarse;
            } else {
                EXPECT_LE(excess, anyway) << "from " << from << " m on, at " << time << " s";
            }
            if (excess > worst_) worst_ = excess, worstAt_ = from, worstStep_ = step;
        }
    }

    void TearDown() override {
        std::printf("%.0f m/s: at most %.5f beyond 1.5 times the steps beside, of %.4f m, from %.4f m on\n",
                    double{sea_.windSpeed}, worst_, worstStep_, worstAt_);
        CrossingTest::TearDown();
    }

  private:
    double worst_ = 0, worstAt_ = 0, worstStep_ = 0;
};

// The waves' own height, where the reflection comes and goes beside them, and the calm plane.
TEST_P(CrossingInSteps, JumpNowhereThatAnythingChanges) {
    Body* const body = makeBody(desc_);
    const double waves = wavesAt(*body, 10);
    for (const double height : {waves - 0.1, waves, waves + 0.1, 0.0, 0.1})
        expectNoJump(body, 10, height - 6.5e-3, 13);
}

TEST_P(CrossingInSteps, JumpNowhereWithinTwoMetres) {
    expectNoJump(makeBody(desc_), 10, -2, 4000);
}

std::vector<Steps> everyStep() {
    std::vector<Steps> all;
    for (const auto technique : {ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                 ReflectionTechnique::hybrid, ReflectionTechnique::planar})
        for (const float wind : {3.0f, 8.0f, 15.0f}) all.push_back({technique, wind});
    return all;
}

INSTANTIATE_TEST_SUITE_P(, CrossingInSteps, testing::ValuesIn(everyStep()), [](const auto& info) {
    return std::string(reflectionTechniques[static_cast<size_t>(info.param.technique)]) +
           std::to_string(static_cast<int>(info.param.wind));
});

} // namespace
