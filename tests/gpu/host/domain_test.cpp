// docs/domain.md: along each axis of the domain, in equal ratios, a picture in 32-bit floats has no NaN, no
// infinity and no more light than its sky. By day at a few places of each, by night at many.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// What is drawn.
struct Place {
    SeaDesc sea = breeze();
    Camera camera;
    double time = 5;
};

struct Axis {
    const char* name;
    double low, high;
    void (*set)(Place& setup, double value);
};

constexpr Axis axes[] = {
    {"time", 1e-3, 1e9, [](Place& s, double v) { s.time = v; }},
    {"wind", 1e-2, 100, [](Place& s, double v) { s.sea.windSpeed = static_cast<float>(v); }},
    {"fetch", 1, 1e6, [](Place& s, double v) { s.sea.fetch = static_cast<float>(v); }},
    {"depth", 1e-6, 1e30, [](Place& s, double v) { s.sea.depth = static_cast<float>(v); }},
    {"patch", 1, 1e4, [](Place& s, double v) { s.sea.largestPatch = static_cast<float>(v); }},
    {"choppiness", 1e-3, 10, [](Place& s, double v) { s.sea.choppiness = static_cast<float>(v); }},
    {"origin", 1, 1e7,
     [](Place& s, double v) {
         s.camera.eye += glm::dvec3(v, 0, -v);
         s.camera.target += glm::dvec3(v, 0, -v);
     }},
    {"above", 1e-3, 1e5, [](Place& s, double v) { s.camera.eye.y = v; }},
    {"below", 1e-3, 1e3, [](Place& s, double v) { s.camera.eye.y = -v; }},
    {"near", 1e-6, 10, [](Place& s, double v) { s.camera.near = v; }},
    {"far", 100, 1e9, [](Place& s, double v) { s.camera.far = v; }},
    {"view", 1, 179, [](Place& s, double v) { s.camera.fovDegrees = v; }},
};

/// Which place of which axis, as SEAGLASS_DOMAIN="wind 100" names one alone.
struct Case {
    std::string axis;
    double value = 0;
    bool operator==(const Case&) const = default;
};

std::string again(const Case& of) {
    std::ostringstream text;
    text.precision(17);
    text << "SEAGLASS_DOMAIN='" << of.axis << " " << of.value
         << "' build/release/bin/water_gpu_tests --gtest_filter=Domain.IsFiniteAtEachPlace";
    return text.str();
}

class Domain : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        if (const char* const asked = std::getenv("SEAGLASS_DOMAIN"))
            std::istringstream(asked) >> only_.axis >> only_.value;
    }

    /// The brightest pixel as a share of the sky, and what is wrong, if anything.
    void draw(const Case& at, const Place& setup) {
        SCOPED_TRACE(again(at));
        FoamDesc foam;
        foam.decayTime = 0.1f; // a short history
        const ReflectionDesc reflection;
        const RefractionDesc refraction;
        BodyDesc desc;
        desc.waves = &setup.sea;
        desc.wavesBackend = fftwWaves();
        desc.foam = &foam;
        desc.reflection = &reflection;
        desc.refraction = &refraction;
        Body* const body = makeBody(desc);
        const WaterPicture p =
            picture({body}, setup.camera, setup.time, SurfaceOutput::shaded, nothingBehind(setup.camera));
        size_t notFinite = 0;
        double brightest = 0;
        for (size_t pixel = 0; pixel < p.depth.size(); ++pixel) {
            bool finite = std::isfinite(p.depth[pixel]);
            // The sky's radiance is 1, 2, 3.
            for (size_t c = 0; c < 3; ++c) {
                const float value = p.color[4 * pixel + c];
                finite = finite && std::isfinite(value);
                if (p.covered(pixel))
                    brightest = std::max(brightest, double{value} / static_cast<double>(c + 1));
            }
            notFinite += !finite;
        }
        EXPECT_EQ(notFinite, 0u) << "pixels of " << p.depth.size();
        EXPECT_LE(brightest, 1.001) << "of the sky's radiance";
        ++pictures_;
        if (!(brightest > worst_)) return;
        worst_ = brightest;
        worstCase_ = at;
    }

    void sweep(int places) {
        for (const Axis& axis : axes)
            for (int i = 0; i < places; ++i) {
                Case at{axis.name, axis.low * std::pow(axis.high / axis.low, i / (places - 1.0))};
                if (!only_.axis.empty() && only_.axis != at.axis) continue;
                if (!only_.axis.empty() && i > 0) break;
                if (!only_.axis.empty()) at = only_;
                Place setup;
                setup.camera.width = 48;
                setup.camera.height = 27;
                axis.set(setup, at.value);
                draw(at, setup);
            }
        std::printf("%d pictures without NaN or infinity; the brightest has %.6f of its sky's radiance: %s\n",
                    pictures_, worst_, again(worstCase_).c_str());
    }

  private:
    Case only_, worstCase_;
    double worst_ = 0;
    int pictures_ = 0;
};

TEST_F(Domain, IsFiniteAtEachEnd) {
    sweep(2);
}

TEST_F(Domain, IsFiniteAtEachPlace) {
    sweep(33);
}

TEST_F(Domain, HasTargetsOfAnySize) {
    const uint32_t widest = std::min(device().properties().limits.maxFramebufferWidth, 16384u);
    const uint32_t sizes[][2] = {{1, 1}, {1, 4096}, {widest, 1}};
    for (const auto& [width, height] : sizes) {
        Place setup;
        setup.camera.width = width;
        setup.camera.height = height;
        draw({std::to_string(width) + "x" + std::to_string(height), 0}, setup);
    }
}

} // namespace
