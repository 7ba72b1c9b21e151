// Hollows that the water stays out of: no surface, no fog and no caustics in them, and all as ever outside.
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/surface_constant.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// Upright walls around (x, z), from 2 m below the calm water up.
ExclusionVolume box(double x, double z, double halfX, double halfZ) {
    return {{{2, 0, 0, -2 * (x + halfX)},
             {-1, 0, 0, x - halfX},
             {0, 0, 3, -3 * (z + halfZ)},
             {0, 0, -1, z - halfZ},
             {0, -1, 0, -2}}};
}

class ExclusionVolumes : public WaterTest {
  protected:
    ExclusionVolumes() {
        camera_.eye = {0, 6, 8};
        camera_.target = {0, 0, 0};
        sea_.windSpeed = 4;
        sea_.fetch = 5e3f;
        sea_.samples = 64;
    }
    static bool isIn(const glm::dvec3& p, double x, double z, double halfX, double halfZ, double margin) {
        return std::abs(p.x - x) < halfX + margin && std::abs(p.z - z) < halfZ + margin;
    }
    void expectDry(Body* body, double x, double z, double halfX, double halfZ) {
        const WaterPicture whole = picture({makeBody(desc_)}, camera_, 3, SurfaceOutput::height);
        const WaterPicture p = picture({body}, camera_, 3, SurfaceOutput::height);
        size_t dry = 0, wet = 0;
        for (uint32_t j = 0; j < p.height; ++j)
            for (uint32_t i = 0; i < p.width; ++i) {
                const size_t pixel = size_t{j} * p.width + i;
                if (!whole.covered(pixel)) continue;
                const glm::dvec3 at = worldAt(camera_, whole, i, j);
                if (isIn(at, x, z, halfX, halfZ, -0.01)) {
                    EXPECT_FALSE(p.covered(pixel)) << at.x << ' ' << at.z;
                    ++dry;
                } else if (!isIn(at, x, z, halfX, halfZ, 0.01)) {
                    EXPECT_EQ(p.color[pixel * 4], whole.color[pixel * 4]);
                    ++wet;
                }
            }
        EXPECT_GT(dry, 200u);
        EXPECT_GT(wet, 2000u);
    }

    Camera camera_;
    SeaDesc sea_;
    BodyDesc desc_;
};

TEST_F(ExclusionVolumes, HaveNoSurface) {
    desc_.waves = &sea_;
    desc_.wavesBackend = fftwWaves();
    Body* const body = makeBody(desc_);
    const ExclusionVolume first = box(0.5, 0, 1, 2);
    ASSERT_EQ(setExclusionVolumes(body, &first, 1), Status::ok) << message();
    expectDry(body, 0.5, 0, 1, 2);
    const ExclusionVolume moved = box(-2, 1, 1, 0.8);
    ASSERT_EQ(setExclusionVolumes(body, &moved, 1), Status::ok) << message();
    expectDry(body, -2, 1, 1, 0.8);
}

TEST_F(ExclusionVolumes, AreEightAtMost) {
    Body* const body = makeBody(desc_);
    std::vector<ExclusionVolume> volumes(8, box(300, 300, 1, 1));
    volumes[7] = box(0, 0, 1, 1);
    ASSERT_EQ(setExclusionVolumes(body, volumes.data(), 8), Status::ok) << message();
    expectDry(body, 0, 0, 1, 1);
    volumes.push_back(volumes[0]);
    EXPECT_EQ(setExclusionVolumes(body, volumes.data(), 9), Status::invalidArgument);
    EXPECT_NE(message().find("count"), std::string::npos) << message();
    expectDry(body, 0, 0, 1, 1); // as before
}

TEST_F(ExclusionVolumes, KeepAnEyeInOneDry) {
    const RefractionDesc refraction;
    const UnderwaterDesc underwater;
    desc_.refraction = &refraction;
    desc_.underwater = &underwater;
    Body* const body = makeBody(desc_);
    camera_.eye = {0, -1, 0};
    camera_.target = {1, -1, 0};
    // Down there no surface shows.
    const auto fogged = [&] {
        const WaterPicture p = picture({body}, camera_);
        size_t pixels = 0;
        for (size_t i = p.depth.size() / 2 + p.width; i < p.depth.size(); ++i) pixels += p.covered(i);
        return pixels;
    };
    EXPECT_GT(fogged(), 1000u);
    const ExclusionVolume volume = box(0, 0, 1, 1);
    ASSERT_EQ(setExclusionVolumes(body, &volume, 1), Status::ok);
    EXPECT_EQ(fogged(), 0u);
    camera_.eye.y = -3; // under its bottom
    EXPECT_GT(fogged(), 1000u);
}

TEST_F(ExclusionVolumes, HaveNoCaustics) {
    const RefractionDesc refraction;
    const CausticsDesc caustics;
    desc_.waves = &sea_;
    desc_.wavesBackend = fftwWaves();
    desc_.refraction = &refraction;
    desc_.caustics = &caustics;
    Body* const body = makeBody(desc_);
    lighting.sunIrradiance[1] = 1;
    drawCausticsOf(body);
    const auto changed = [&] {
        const WaterPicture p = picture({body}, camera_, 3, SurfaceOutput::shaded, planeBelow(camera_, -1, 1));
        size_t pixels = 0;
        for (uint32_t j = 0; j < p.height; ++j)
            for (uint32_t i = 0; i < p.width; ++i)
                pixels += p.color[(size_t{j} * p.width + i) * 4 + 1] != WaterPicture::untouched;
        return pixels;
    };
    EXPECT_GT(changed(), 1000u);
    const ExclusionVolume volume = box(0, 0, 500, 500);
    ASSERT_EQ(setExclusionVolumes(body, &volume, 1), Status::ok);
    EXPECT_EQ(changed(), 0u);
}

TEST_F(ExclusionVolumes, CostNothingWhereThereAreNone) {
    Body* const body = makeBody(desc_);
    const auto constant = [&] {
        spiedCalls().clear();
        picture({body}, camera_);
        for (const SpiedCall& call : spiedCalls())
            if (call.name == "CreateGraphicsPipelines")
                return call.constants.at(surfaceConstant("exclusionVolumes"));
        return ~0u;
    };
    EXPECT_EQ(constant(), 0u);
    const ExclusionVolume volume = box(0, 0, 1, 1);
    ASSERT_EQ(setExclusionVolumes(body, &volume, 1), Status::ok);
    EXPECT_EQ(constant(), 1u);
    ASSERT_EQ(setExclusionVolumes(body, nullptr, 0), Status::ok);
    EXPECT_EQ(constant(), ~0u); // the first again
}

// What they cut is a draw of its own, which reads what the other does.
TEST_F(ExclusionVolumes, TakeNoSetOfTheirOwn) {
    struct Calls {
        size_t draws, sets;
    };
    Body* const body = makeBody(desc_);
    const auto calls = [&] {
        picture({body}, camera_);
        spiedCalls().clear();
        picture({body}, camera_);
        return Calls{countSpied("CmdDrawIndexed"), countSpied("AllocateDescriptorSets")};
    };
    const Calls without = calls();
    const ExclusionVolume volume = box(0, 0, 1, 1);
    ASSERT_EQ(setExclusionVolumes(body, &volume, 1), Status::ok) << message();
    const Calls with = calls();
    EXPECT_EQ(with.draws, without.draws + 1);
    EXPECT_EQ(with.sets, without.sets);
}

TEST_F(ExclusionVolumes, BadOnesAreNamed) {
    Body* const body = makeBody(desc_);
    const auto expectRefused = [&](const ExclusionVolume& volume) {
        EXPECT_EQ(setExclusionVolumes(body, &volume, 1), Status::invalidArgument);
        EXPECT_NE(message().find("ExclusionVolume.planes"), std::string::npos) << message();
    };
    expectRefused({});
    ExclusionVolume volume = box(0, 0, 1, 1);
    volume.planes[0][0] = std::nan("");
    expectRefused(volume);
    volume.planes[0][0] = INFINITY;
    expectRefused(volume);
    volume = box(0, 0, 1, 1);
    volume.planes[5][3] = 1; // nothing but a distance
    expectRefused(volume);
    EXPECT_EQ(setExclusionVolumes(body, nullptr, 1), Status::invalidArgument);
    EXPECT_EQ(setExclusionVolumes(nullptr, &volume, 1), Status::invalidArgument);
}

} // namespace
