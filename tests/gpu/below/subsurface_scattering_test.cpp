// Light through crests: where it shines and where it cannot, and that it is gone where it is not asked for.
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/surface_constant.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class SubsurfaceScattering : public WaterTest {
  protected:
    SubsurfaceScattering() {
        sea_.windSpeed = 14;
        sea_.fetch = 100e3f;
        sea_.samples = 128;
        camera_.eye = {0, 5, 0};
        camera_.target = {0, 3, -20};
        for (int i = 0; i < 3; ++i) lighting.skyIrradiance[i] = 1;
    }
    /// In front of the eye where `ahead`, else at its back.
    void lowSun(bool ahead) { shineFrom({0, std::sin(0.2), std::cos(0.2) * (ahead ? -1 : 1)}, 5); }
    Body* scattering(float perMetre) {
        refraction_.scattering = perMetre;
        BodyDesc desc;
        desc.waves = &sea_;
        desc.wavesBackend = fftwWaves();
        desc.refraction = &refraction_;
        return makeBody(desc);
    }
    /// What scattering adds, over water higher than a deviation of the waves, and over what is as far below.
    struct Gain {
        double crests[3] = {}, troughs[3] = {};
    };
    Gain gain(float perMetre) {
        Body* const with = scattering(perMetre);
        Body* const without = scattering(0);
        const double deviation = significantWaveHeight(*sea(with)) / 4;
        const WaterPicture lit = picture({with}, camera_, 5), dark = picture({without}, camera_, 5),
                           height = picture({with}, camera_, 5, SurfaceOutput::height);
        Gain sum;
        size_t crests = 0, troughs = 0;
        for (size_t i = 0; i < lit.color.size() / 4; ++i) {
            if (!lit.covered(i)) continue;
            const double h = double{height.color[i * 4]};
            const bool crest = h > deviation, trough = h < -1.05 * deviation;
            crests += crest;
            troughs += trough;
            for (size_t c = 0; c < 3; ++c) {
                const double more = double{lit.color[i * 4 + c]} - double{dark.color[i * 4 + c]};
                if (crest) sum.crests[c] += more;
                if (trough) sum.troughs[c] += more;
            }
        }
        EXPECT_GT(crests, 500u);
        EXPECT_GT(troughs, 500u);
        for (double& channel : sum.crests) channel /= static_cast<double>(crests);
        for (double& channel : sum.troughs) channel /= static_cast<double>(troughs);
        return sum;
    }

    SeaDesc sea_;
    Camera camera_;
    RefractionDesc refraction_{{0.355f, 0.0906f, 0.193f}, {0.0049f, 0.0054f, 0.0067f}, 1};
};

TEST_F(SubsurfaceScattering, ShinesInCrestsBeforeTheSun) {
    lowSun(true);
    const Gain facing = gain(0.25f);
    lowSun(false);
    const Gain away = gain(0.25f);
    std::printf("crests towards the sun %.5f %.5f %.5f, away from it %.5f %.5f %.5f\n", facing.crests[0],
                facing.crests[1], facing.crests[2], away.crests[0], away.crests[1], away.crests[2]);
    EXPECT_GT(facing.crests[1], 1.5 * away.crests[1]);
    // What water absorbs least is left.
    EXPECT_GT(facing.crests[1], facing.crests[2]);
    EXPECT_GT(facing.crests[2], facing.crests[0]);
    EXPECT_GT(facing.crests[0], 0);
    for (const double channel : facing.troughs) EXPECT_EQ(channel, 0);
}

// On the sun's way into the crest as well as on the way to the eye.
TEST_F(SubsurfaceScattering, IsAbsorbedOnBothItsWays) {
    lowSun(true);
    refraction_ = {{0.001f, 0.5f, 2.0f}, {0, 0, 0}, 1};
    const Gain found = gain(0.25f);
    const double some = found.crests[1] / found.crests[0], most = found.crests[2] / found.crests[0];
    std::printf("%.3f and %.3f of what clear water sends\n", some, most);
    EXPECT_LT(some, 0.33);
    EXPECT_LT(most, 0.07);
}

TEST_F(SubsurfaceScattering, GrowsWithWhatScattersIt) {
    lowSun(true);
    const double little = gain(0.02f).crests[1], more = gain(0.08f).crests[1], most = gain(50).crests[1];
    // The little is 0.00008 of light that is held in halves, whose steps are ten times that: drivers round it
    // otherwise.
    EXPECT_NEAR(more / little, 4, limitOnDriver(0.2, 0.5));
    EXPECT_LT(most, 50 / 0.02 * little);
}

TEST_F(SubsurfaceScattering, CostsNothingWhereItIsNotAskedFor) {
    useOwnContext();
    const auto constantOf = [&](Body* body) {
        spiedCalls().clear();
        picture({body}, camera_, 5);
        for (const SpiedCall& call : spiedCalls())
            if (call.name == "CreateComputePipelines" && call.constants.size() == surfaceConstants)
                return call.constants[surfaceConstant("hasSubsurfaceScattering")];
        return ~0u;
    };
    EXPECT_EQ(constantOf(scattering(0)), 0u);
    EXPECT_EQ(constantOf(scattering(0.25f)), 1u);
    sea_.windSpeed = 0; // flat: no crests
    Body* const flat = scattering(0.25f);
    EXPECT_EQ(constantOf(flat), 0u);
    Estimate with, without;
    BodyDesc desc;
    RefractionDesc refraction;
    desc.refraction = &refraction;
    EXPECT_EQ(estimate(context(), &desc, {64, 64}, &without), Status::ok);
    refraction.scattering = 1;
    EXPECT_EQ(estimate(context(), &desc, {64, 64}, &with), Status::ok);
    EXPECT_EQ(with.bytes, without.bytes);
}

TEST_F(SubsurfaceScattering, BadFieldsAreNamed) {
    for (const float bad : {-1.0f, 101.0f, std::nanf("")}) {
        refraction_.scattering = bad;
        BodyDesc desc;
        desc.refraction = &refraction_;
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument);
        EXPECT_NE(message().find("RefractionDesc.scattering"), std::string::npos) << message();
    }
}

} // namespace
