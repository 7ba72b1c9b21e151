// Water seen by parallel lines of sight, held against rays that are followed one by one, and against an eye
// that is so far away that its lines are as good as parallel.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// Looks at a place from aside, so many degrees down.
Camera fromAside(double degreesDown, double height, const glm::dvec3& target = glm::dvec3(0),
                 double distance = 60) {
    const double down = radians(degreesDown);
    Camera camera;
    camera.target = target;
    camera.eye = target + distance * glm::dvec3(-0.6 * std::cos(down), std::sin(down), 0.8 * std::cos(down));
    camera.parallelHeight = height;
    camera.far = 20 * std::max(height, distance);
    camera.width = 160;
    camera.height = 90;
    return camera;
}

/// Waves of some centimetres.
SeaDesc ripples() {
    SeaDesc sea;
    sea.windSpeed = 3;
    sea.fetch = 300;
    sea.samples = 128;
    sea.cascades = 3;
    return sea;
}

/// A bed of many shades, and a wall that stands on it and out of the water, which all shine by themselves.
struct Basin {
    glm::dvec3 middle{0};
    double bed = -1.5, wall = -3, high = 2;
    struct Met {
        double distance = 0; ///< 0: nothing
        float radiance = 0;
    };

    Met met(const glm::dvec3& from, const glm::dvec3& along) const {
        const glm::dvec3 at = from - middle;
        const double toWall = (wall - at.z) / along.z, toBed = (bed - at.y) / along.y;
        const glm::dvec3 onWall = at + along * toWall, onBed = at + along * toBed;
        if (toWall > 0 && onWall.y > bed && onWall.y < high && std::abs(onWall.x - 0.03) < 3)
            return {toWall, onWall.y > 1 ? 9.0f : 5.0f};
        if (!(toBed > 0)) return {};
        return {toBed, static_cast<float>(3 + std::cos(0.7 * onBed.x) * std::cos(0.7 * onBed.z))};
    }

    SceneBehind seenBy(const Camera& camera) const {
        SceneBehind behind;
        for (uint32_t y = 0; y < camera.height; ++y)
            for (uint32_t x = 0; x < camera.width; ++x) {
                const auto [from, along] = lineThrough(camera, x, y);
                const Met seen = met(from, along);
                const float far = camera.reversed ? 0 : 1;
                behind.depth.push_back(seen.distance > 0 ? depthOf(camera, from + along * seen.distance)
                                                         : far);
                behind.color.insert(behind.color.end(), {seen.radiance, seen.radiance, seen.radiance, 1});
            }
        return behind;
    }

    /// As flat water at y = 0 shows it to one line of sight; `sky` is mirrored where nothing else is.
    double shown(const Line& line, double absorption, double sky) const {
        const glm::dvec3 surface = line.from - line.along * (line.from.y / line.along.y);
        const glm::dvec3 mirrored = line.along * glm::dvec3(1, -1, 1);
        const glm::dvec3 bent = glm::refract(line.along, glm::dvec3(0, 1, 0), 1 / waterIndex);
        const double f = reflectance(-line.along.y);
        const Met above = met(surface, mirrored), below = met(surface, bent);
        const double through = double{below.radiance} * std::exp(-absorption * below.distance);
        return f * (above.distance > 0 ? double{above.radiance} : sky) +
               (1 - f) * through / (waterIndex * waterIndex);
    }
};

class ParallelWater : public WaterTest {
  protected:
    Body* wavyBody(const SeaDesc& sea, MeshDesc mesh = {}) {
        BodyDesc desc = desc_;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.mesh = mesh;
        return makeBody(desc);
    }
    void shine() {
        lighting.toSun[0] = 0.48f;
        lighting.toSun[1] = 0.6f;
        lighting.toSun[2] = -0.64f;
        for (float& channel : lighting.sunIrradiance) channel = 5;
        for (float& channel : lighting.skyIrradiance) channel = 2;
    }

    RefractionDesc refraction_{{0.2f, 0.2f, 0.2f}, {0, 0, 0}, 1};
    ReflectionDesc reflection_;
    BodyDesc desc_;
};

TEST_F(ParallelWater, FlatWaterCoversWhatLinesMeet) {
    Body* body = makeBody(desc_);
    for (const double degreesDown : {90.0, 35.0, 3.0, 0.3})
        for (const double height : {1.0, 200.0, 20e3}) {
            const Camera camera = fromAside(degreesDown, height);
            const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::height);
            size_t wrong = 0;
            for (uint32_t y = 0; y < p.height; ++y)
                for (uint32_t x = 0; x < p.width; ++x) {
                    const Line line = lineThrough(camera, x, y);
                    const double met = -line.from.y / line.along.y, far = camera.far - camera.near;
                    const bool seen = met > 0 && met < far;
                    if (std::min(std::abs(met), std::abs(met - far)) < 0.01 * far) continue;
                    wrong += seen != p.covered(size_t{y} * p.width + x);
                }
            EXPECT_EQ(wrong, 0u) << degreesDown << " degrees down, " << height << " m";
        }
}

TEST_F(ParallelWater, WavesLeaveNoHoles) {
    Body* body = wavyBody(breeze());
    for (const double degreesDown : {90.0, 35.0, 8.0})
        for (const double height : {3.0, 7.1, 60.0, 900.0}) {
            const Camera camera = fromAside(degreesDown, height, {1234.5, 0, -67}, 40 + 10 * height);
            const WaterPicture p = picture({body}, camera, 5, SurfaceOutput::height);
            size_t holes = 0;
            for (size_t i = 0; i < size_t{p.width} * p.height; ++i) holes += !p.covered(i);
            EXPECT_EQ(holes, 0u) << degreesDown << " degrees down, " << height << " m";
        }
}

// Zoomed out by a thousandth, to cells twice as wide, which the vertices have glided to.
TEST_F(ParallelWater, DoesNotPopWhereALevelTakesOver) {
    Body* body = wavyBody(breeze());
    const double takesOver = 0.828 * 128 * 0.25 * 4; // the height of what is seen, for cells of 1 m
    const auto seen = [&](double share) {
        return picture({body}, fromAside(35, takesOver * share, {}, 300), 5, SurfaceOutput::height);
    };
    const WaterPicture nearer = seen(0.9995), farther = seen(1.0005);
    double sum = 0, count = 0;
    for (size_t i = 0; i < nearer.color.size(); i += 4) {
        sum += std::abs(double{nearer.color[i]} - double{farther.color[i]});
        ++count;
    }
    std::printf("moved by %.5f m in the mean\n", sum / count);
    EXPECT_LT(sum / count,
              limitOnGrid(2e-3, 2e-2)); // a snapped vertex moves aside, where waves are higher or lower
}

TEST_F(ParallelWater, StandsWhereHeightQueriesSay) {
    SeaDesc sea = breeze();
    sea.samples = 256;
    Body* body = wavyBody(sea);
    const Camera camera = fromAside(35, 6);
    const double time = 123.4;
    const WaterPicture p = picture({body}, camera, time, SurfaceOutput::height);
    double worst = 0, scale = 0;
    for (uint32_t y = 0; y < p.height; y += 7)
        for (uint32_t x = 0; x < p.width; x += 13) {
            const glm::dvec3 world = worldAt(camera, p, x, y);
            const double point[] = {world.x, world.z};
            HeightSample sample;
            sampleHeights(*seaglass::sea(body), time, point, 1, &sample);
            worst = std::max(worst, std::abs(world.y - double{sample.height}));
            scale = std::max(scale, std::abs(world.y));
        }
    std::printf("worst difference %.4f m, highest wave %.2f m\n", worst, scale);
    EXPECT_LT(worst, 0.06);
    EXPECT_GT(scale, 0.3);
}

struct Look {
    const char* name;
    double degreesDown;
    bool reversed = true;
    glm::dvec3 middle{0};
    ReflectionTechnique technique = ReflectionTechnique::sspr;
    double rollDegrees = 0;
};

class ParallelRays : public ParallelWater, public testing::WithParamInterface<Look> {};

// Every ray through flat water: what it mirrors, what shines through along the ray that it bends, and through
// how much water.
TEST_P(ParallelRays, MeetWhatTheWaterShows) {
    const Look& look = GetParam();
    reflection_.technique = look.technique;
    desc_.refraction = &refraction_;
    desc_.reflection = &reflection_;
    useDepth(look.reversed);
    Camera camera = fromAside(look.degreesDown, 12, look.middle);
    camera.reversed = look.reversed;
    camera.rollDegrees = look.rollDegrees;
    const Basin basin{look.middle};
    const WaterPicture p = picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, basin.seenBy(camera));
    size_t checked = 0, off = 0;
    // Bent rays leave the picture at its borders.
    for (uint32_t y = 12; y + 12 < p.height; ++y)
        for (uint32_t x = 12; x + 12 < p.width; ++x) {
            const size_t i = size_t{y} * p.width + x;
            Line line = lineThrough(camera, x, y);
            const Basin::Met seen = basin.met(line.from, line.along);
            if ((line.from + line.along * seen.distance).y > 0) continue; // the wall, out of the water
            const double expected = basin.shown(line, 0.2, 2);
            off += std::abs(double{p.color[i * 4 + 1]} - expected) > 0.05 * expected;
            ++checked;
        }
    const double share = static_cast<double>(off) / static_cast<double>(checked);
    std::printf("%.4f of %zu pixels are off\n", share, checked);
    EXPECT_GT(checked, 5000u);
    EXPECT_LT(share, 0.04); // next to edges
}
INSTANTIATE_TEST_SUITE_P(, ParallelRays,
                         testing::Values(Look{"Isometric", 35.26}, Look{"Steep", 75}, Look{"Flat", 12},
                                         Look{"StraightDown", 90}, Look{"ForwardDepth", 35.26, false},
                                         Look{"FarFromTheOrigin", 35.26, true, {1e6, 0, -2e6}},
                                         Look{"Ssr", 35.26, true, {}, ReflectionTechnique::ssr},
                                         Look{"Hybrid", 35.26, true, {}, ReflectionTechnique::hybrid},
                                         Look{"Rolled", 35.26, true, {}, ReflectionTechnique::sspr, 35}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Of the pixels that both show water at, the share that differ by more than a fiftieth, or by that of 1.
double apart(const WaterPicture& a, const WaterPicture& b) {
    double off = 0, count = 0;
    for (size_t i = 0; i < a.color.size() / 4; ++i) {
        if (!a.covered(i) || !b.covered(i)) continue;
        const double one = double{a.color[i * 4 + 1]}, other = double{b.color[i * 4 + 1]};
        off += std::abs(one - other) > 0.02 * std::max(std::abs(one), 1.0);
        ++count;
    }
    EXPECT_GT(count, 10000);
    return off / count;
}

// The same picture, waves, light and all, but for edges, and for what perspective is left in it: a thirtieth
// of a pixel at its borders.
TEST_F(ParallelWater, LooksAsThroughANarrowLensFromFarAway) {
    shine();
    desc_.refraction = &refraction_;
    desc_.reflection = &reflection_;
    MeshDesc fine;
    fine.cellsPerLevel = 1024;
    const SeaDesc sea = ripples();
    Body* body = wavyBody(sea, fine);
    const double height = 12, away = 16e3;
    for (const double degreesDown : {35.0, 80.0}) {
        const Camera parallel = fromAside(degreesDown, height);
        Camera narrow = fromAside(degreesDown, 0, {}, away);
        narrow.far = 0;
        narrow.near = 4e3;
        narrow.fovDegrees = 2 / radians(1) * std::atan(height / 2 / away);
        const Basin basin;
        for (const SurfaceOutput output : {SurfaceOutput::normal, SurfaceOutput::slopes,
                                           SurfaceOutput::reflection, SurfaceOutput::shaded}) {
            const WaterPicture p = picture({body}, parallel, 7, output, basin.seenBy(parallel));
            const WaterPicture n = picture({body}, narrow, 7, output, basin.seenBy(narrow));
            const double off = apart(p, n);
            std::printf("%g degrees down, output %d: %.4f of all pixels are apart\n", degreesDown,
                        static_cast<int>(output), off);
            EXPECT_LT(off, 0.01) << degreesDown << ", output " << static_cast<int>(output);
        }
    }
}

// A host's eye may stand anywhere on a line of sight, before its near plane or behind.
TEST_F(ParallelWater, DoesNotDependOnWhereTheEyeStands) {
    shine();
    desc_.refraction = &refraction_;
    desc_.reflection = &reflection_;
    Body* body = wavyBody(breeze());
    const Camera camera = fromAside(35, 12);
    const Basin basin;
    const auto seen = [&](double behind) {
        Camera moved = camera;
        const glm::dvec3 sight = glm::normalize(camera.target - camera.eye);
        moved.eye -= behind * sight;
        moved.target = moved.eye + sight;
        moved.near += behind;
        moved.far += behind;
        return picture({body}, moved, 7, SurfaceOutput::shaded, basin.seenBy(moved));
    };
    const WaterPicture here = seen(0);
    for (const double behind : {-200.0, 300e3}) EXPECT_LT(apart(here, seen(behind)), 0.001) << behind;
}

TEST_F(ParallelWater, LinesThatBeginInTheWaterSeeItBeforeTheBed) {
    const UnderwaterDesc underwater;
    desc_.refraction = &refraction_;
    desc_.underwater = &underwater;
    Camera camera = fromAside(20, 2, {0, -3, 0}, 2);
    camera.near = 0.5;
    const WaterPicture p =
        picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, planeBelow(camera, -4, 4));
    for (uint32_t y = 2; y < p.height; y += 7)
        for (uint32_t x = 2; x < p.width; x += 11) {
            const Line line = lineThrough(camera, x, y);
            const double path = (-4 - line.from.y) / line.along.y;
            const double expected = path > 0 ? 4 * std::exp(-0.2 * path) : 4;
            EXPECT_NEAR(p.color[(size_t{y} * p.width + x) * 4], expected, 5e-3 * expected) << x << ' ' << y;
        }
}

// As of an aquarium, from the side: air above, water below, and each line by where it begins.
TEST_F(ParallelWater, StraddlesByWhereEachLineBegins) {
    const UnderwaterDesc underwater{0};
    desc_.refraction = &refraction_;
    desc_.underwater = &underwater;
    Camera camera = fromAside(0, 4);
    camera.target.y = camera.eye.y = 0.5;
    const WaterPicture p = picture({makeBody(desc_)}, camera);
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x)
            EXPECT_EQ(p.covered(size_t{y} * p.width + x), lineThrough(camera, x, y).from.y < 0)
                << x << ' ' << y;
}

} // namespace
