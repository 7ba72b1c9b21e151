// An eye that passes the calm plane amid waves: what it sees is mirrored by where the waves are, not that
// plane.
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/reflection_rig.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Crossing : public WaterTest, public testing::WithParamInterface<ReflectionTechnique> {
  protected:
    Crossing() {
        for (float& channel : lighting.skyIrradiance) channel = 2;
        desc_.refraction = &refraction_;
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
        reflection_.technique = GetParam();
        desc_.reflection = &reflection_;
    }

    /// When the waves at the eye are so high.
    double timeOf(const Body& body, double low, double high) const {
        constexpr double place[2] = {3, 7};
        for (double time = 0; time < 200; time += 0.25) {
            HeightSample sample;
            sampleHeights(*seaglass::sea(&body), time, place, 1, &sample);
            if (double{sample.height} >= low && double{sample.height} <= high) return time;
        }
        ADD_FAILURE() << "no wave of " << low << " to " << high << " m";
        return 0;
    }

    WaterPicture at(Body* body, double height, double time) {
        Camera camera;
        camera.eye = {3, height, 7};
        camera.target = {3, height - 0.5, -10};
        camera.width = 160;
        camera.height = 90;
        const auto wall = [&](const glm::dvec3& ray) {
            const double along = ray.z < 0 ? -12 / ray.z : -1;
            const double x = along * ray.x, y = height + along * ray.y;
            return std::abs(x) < 5 && y < 4 ? along : -1.0;
        };
        return picture({body}, camera, time, SurfaceOutput::shaded,
                       drawnOver(camera, nothingBehind(camera), 3, wall));
    }

    /// Share of pixels that differ by over 2 % of the wall's radiance.
    static double apart(const WaterPicture& a, const WaterPicture& b) {
        size_t off = 0;
        for (size_t i = 0; i < a.color.size(); i += 4) off += std::abs(a.color[i] - b.color[i]) > 0.06f;
        return static_cast<double>(off) / static_cast<double>(a.color.size() / 4);
    }

    SeaDesc sea_ = breeze();
    ReflectionDesc reflection_;
    RefractionDesc refraction_{{0.4f, 0.15f, 0.05f}, {0.01f, 0.02f, 0.03f}, 1};
    UnderwaterDesc underwater_;
    BodyDesc desc_;
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
    constexpr double place[2] = {3, 7};
    HeightSample sample;
    sampleHeights(*seaglass::sea(body), time, place, 1, &sample);
    std::vector<double> steps;
    WaterPicture last = at(body, double{sample.height} + 0.15, time);
    for (int i = 1; i <= 60; ++i) {
        WaterPicture next = at(body, double{sample.height} + 0.15 - 0.005 * i, time);
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
                                         ReflectionTechnique::hybrid),
                         nameOf);

} // namespace
