// Foam on a rough sea: how much, in what shapes, at what rate, and the same on CPU and GPU.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/sea_rig.h"
#include "tests/unit/sea/statistics.h"
#include "water/body/body.h"
#include "water/foam/foam_part.h"
#include "water/interface/foam_gate.h"
#include "water/interface/warp.h"
#include "water/interface/whitecaps.h"
#include "water/sea/sea.h"

namespace {

using namespace seaglass;
using namespace tests;

class SeaFoam : public SeaTest {
  protected:
    /// Under a wind along no axis.
    Body* foamyBody(WavesOn on = WavesOn::cpu) {
        SeaDesc sea = breeze();
        sea.windSpeed = 15;
        sea.windDirection = 0.6f;
        sea.fetch = 300e3f;
        const FoamDesc foam;
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesOn = on;
        desc.wavesBackend = fftwWaves();
        desc.foam = &foam;
        return makeBody(desc);
    }
    /// Thick foam, drawn out by a gale along x.
    Body* streakyBody(uint32_t slopeSamples = 1) {
        SeaDesc sea = breeze();
        sea.windSpeed = 20;
        sea.windDirection = 0;
        sea.fetch = 500e3f;
        const FoamDesc foam{.bias = 0.03f};
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.foam = &foam;
        desc.shading.slopeSamples = slopeSamples;
        return makeBody(desc);
    }
    static Camera above() {
        Camera camera = seaCamera();
        camera.eye.y = 40;
        camera.target.y = 10;
        return camera;
    }
    static constexpr double foamTime = 60;
    /// What of each pixel is white at that time.
    std::vector<double> white(Body* body, const Camera& camera) {
        const WaterPicture p = picture({body}, camera, foamTime, SurfaceOutput::foam);
        std::vector<double> shares;
        for (size_t i = 0; i < p.color.size(); i += 4) {
            const bool covered = p.covered(i / 4);
            holes_ += !covered;
            shares.push_back(covered ? double{p.color[i]} : 0);
        }
        return shares;
    }
    /// Pixels of all white() so far that no water covers.
    size_t holes() const { return holes_; }
    /// Each pixel as the mean of `finer` times as many each way.
    std::vector<double> whiteOf(Body* body, Camera camera, uint32_t finer) {
        const uint32_t width = camera.width;
        std::vector<double> means(size_t{width} * camera.height);
        camera.width *= finer;
        camera.height *= finer;
        const std::vector<double> fine = white(body, camera);
        for (size_t i = 0; i < fine.size(); ++i)
            means[i / camera.width / finer * width + i % camera.width / finer] += fine[i] / (finer * finer);
        return means;
    }

  private:
    size_t holes_ = 0;
};

TEST_F(SeaFoam, GathersWhereTheSeaIsRough) {
    const auto cover = [&](float wind) {
        SeaDesc desc = breeze();
        desc.windSpeed = wind;
        desc.fetch = 300e3f;
        desc.samples = 128;
        const FoamDesc foam;
        BodyDesc body;
        body.waves = &desc;
        body.wavesBackend = fftwWaves();
        body.foam = &foam;
        Camera camera = seaCamera();
        camera.eye.y = 30;
        camera.target.y = 10;
        const WaterPicture p = picture({makeBody(body)}, camera, 20, SurfaceOutput::foam);
        double sum = 0, count = 0;
        for (size_t i = 0; i < p.color.size() / 4; ++i) {
            if (!p.covered(i)) continue;
            EXPECT_GE(p.color[i * 4], 0);
            EXPECT_LE(p.color[i * 4], 1);
            sum += double{p.color[i * 4]};
            ++count;
        }
        return sum / count;
    };
    const double calm = cover(3);
    const double fresh = cover(10);
    const double gale = cover(20);
    EXPECT_LT(calm, fresh);
    EXPECT_LT(fresh, gale);
    EXPECT_LT(gale, 0.5);
    EXPECT_GT(fresh, 0);
}

/// Share of pixels that are neither white nor dark.
double partly(const std::vector<double>& white) {
    const auto between = [](double share) { return share > 0.05 && share < 0.95; };
    return static_cast<double>(std::ranges::count_if(white, between)) / static_cast<double>(white.size());
}

// A first frame has a lifetime to catch up, and slow frames after it two seconds at most.
TEST_F(SeaFoam, OfAHostThatFallsBehindTakesNoMoreThanEightSteps) {
    Body* body = foamyBody(WavesOn::gpu);
    const auto dispatches = [&](double time) {
        spiedCalls().clear();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(simulate(commands, &body, 1, time), Status::ok) << message();
        });
        return countSpied("CmdDispatch");
    };
    const size_t first = dispatches(100);
    const size_t none = dispatches(100.1), one = dispatches(100.3);
    const size_t aStep = one - none;
    EXPECT_GT(aStep, 2u);
    EXPECT_GT(first, none + 45 * aStep);
    EXPECT_EQ(dispatches(150), first) << "a single gap is made up for";
    for (const double time : {155.0, 161.0, 400.0, 403.0})
        EXPECT_LE(dispatches(time), one + 7 * aStep) << time;
    EXPECT_EQ(dispatches(404), one + 3 * aStep);
}

TEST_F(SeaFoam, IsTheSamePictureWhateverWasDrawnBefore) {
    Camera camera = above();
    camera.width = 96;
    camera.height = 54;
    for (const WavesOn on : {WavesOn::cpu, WavesOn::gpu}) {
        Body* steady = foamyBody(on);
        for (double time = 45; time < 60.6; time += 0.9) picture({steady}, camera, time);
        const WaterPicture after = picture({steady}, camera, 60.61, SurfaceOutput::foam);
        EXPECT_EQ(picture({foamyBody(on)}, camera, 60.61, SurfaceOutput::foam).color, after.color);
        Body* jumped = foamyBody(on);
        picture({jumped}, camera, 1e6);
        EXPECT_EQ(picture({jumped}, camera, 60.61, SurfaceOutput::foam).color, after.color);
        EXPECT_NE(picture({jumped}, camera, 61.61, SurfaceOutput::foam).color, after.color);
    }
}

TEST_F(SeaFoam, IsTheSameOnTheGpuAsOnTheCpu) {
    const auto texels = [&](WavesOn on) {
        Body* body = foamyBody(on);
        for (const double time : {59.0, 59.3, 59.8}) picture({body}, above(), time);
        std::vector<float> all;
        for (uint32_t c = 0; c < body->find<FoamPart>()->foam.cascades(); ++c)
            for (const uint32_t mip : {0u, 1u}) {
                const uint32_t size = 64u >> mip;
                const std::vector<float> layer =
                    download(body->find<FoamPart>()->foam.image(), VK_FORMAT_R16G16B16A16_SFLOAT,
                             {size, size}, mip, c);
                all.insert(all.end(), layer.begin(), layer.end());
            }
        return all;
    };
    const std::vector<float> cpu = texels(WavesOn::cpu), gpu = texels(WavesOn::gpu);
    ASSERT_EQ(cpu.size(), gpu.size());
    double worst = 0, sum = 0;
    for (size_t i = 0; i < cpu.size(); ++i) {
        worst = std::max(worst, std::abs(double{cpu[i]} - double{gpu[i]}));
        sum += double{cpu[i]};
    }
    std::printf("foam on the GPU off the CPU's by %.4f at most\n", worst);
    EXPECT_GT(sum / static_cast<double>(cpu.size()), 0.005);
    EXPECT_LT(worst, 0.02); // half floats, rounded at each step
}

// Broken up near by, a mean from afar, white is the share of the sea that is measured without a picture, be
// it thin or thick.
class SeaFoamFromAbove : public SeaFoam, public testing::WithParamInterface<float> {};

TEST_P(SeaFoamFromAbove, CoversAsMuchFromAnyHeight) {
    const float bias = GetParam();
    SeaDesc desc = breeze();
    desc.windSpeed = 15;
    desc.fetch = 300e3f;
    desc.warp = 0; // one tile stands for all; FoamGate.IsOpenAsOftenAsItSays has the rest
    // A picture shows so little from near by that it takes many to know the sea's mean.
    struct Look {
        double height;
        int places;
    };
    constexpr Look looks[] = {{40, 1200}, {100, 400}, {400, 100}, {4000, 8}};
    const FoamDesc foam{.bias = bias};
    BodyDesc bodyDesc;
    bodyDesc.waves = &desc;
    bodyDesc.wavesBackend = fftwWaves();
    bodyDesc.foam = &foam;
    Body* body = makeBody(bodyDesc);
    double expected = 0;
    ASSERT_TRUE(whitecapCover(*sea(body), *fftwWaves(), foam, foamTime, &expected));
    EXPECT_GT(expected, bias > 0 ? 0.1 : 0.02);
    EXPECT_LT(expected, 0.5);
    const double tile = cascade(*sea(body), 0).patch;
    for (const Look& look : looks) {
        std::vector<double> shown, ofPart, ofSamples;
        for (int place = 0; place < look.places; ++place) {
            Camera camera = seaCamera();
            camera.width = camera.height = 64;
            // Evenly over the largest tile (Roberts 2018).
            const double u = tile * std::fmod(place * 0.7548776662466927, 1);
            const double v = tile * std::fmod(place * 0.5698402909980532, 1);
            camera.eye = {u, look.height, v};
            camera.target = {u + 0.001 * look.height, 0, v};
            const std::vector<double> here = white(body, camera);
            shown.insert(shown.end(), here.begin(), here.end());
            if (place >= 16) continue;
            const std::vector<double> samples = whiteOf(body, camera, 8);
            ofPart.insert(ofPart.end(), here.begin(), here.end());
            ofSamples.insert(ofSamples.end(), samples.begin(), samples.end());
        }
        std::printf("bias %.2f, from %4.0f m: %.4f white, expected %.4f; partly so %.3f of the pixels, and "
                    "%.3f as means of 64 samples\n",
                    static_cast<double>(bias), look.height, meanOf(shown), expected, partly(ofPart),
                    partly(ofSamples));
        EXPECT_NEAR(meanOf(shown) / expected, 1, 0.05) << look.height;
        EXPECT_NEAR(partly(ofPart), partly(ofSamples), 0.2 * partly(ofSamples)) << "a haze, or too hard";
    }
    // Of twenty million pixels: where a level of the mesh meets the next, snapped vertices are no longer on
    // a line.
    EXPECT_LE(static_cast<double>(holes()), limitOnGrid(0, 50));
}
INSTANTIATE_TEST_SUITE_P(, SeaFoamFromAbove, testing::Values(0.0f, 0.06f),
                         [](const auto& info) { return info.param > 0 ? "Thick" : "Thin"; });

// All but what its wet film mirrors, two fifths.
TEST_F(SeaFoam, BlackFoamHidesTheSea) {
    SeaDesc sea = breeze();
    sea.windSpeed = 20;
    sea.fetch = 500e3f;
    const FoamDesc black{.bias = 0.06f, .albedo = 0};
    BodyDesc desc;
    desc.waves = &sea;
    desc.wavesBackend = fftwWaves();
    for (float& channel : lighting.skyIrradiance) channel = 3;
    Body* const bare = makeBody(desc);
    desc.foam = &black;
    Body* const foamy = makeBody(desc);
    Camera camera = above();
    camera.width = 96;
    camera.height = 54;
    const std::vector<double> shares = white(foamy, camera);
    const WaterPicture with = picture({foamy}, camera, foamTime), without = picture({bare}, camera, foamTime);
    double dimmed = 0, brighter = 0;
    size_t count = 0;
    for (size_t i = 0; i < shares.size(); ++i) {
        if (!with.covered(i) || shares[i] < 0.3) continue;
        dimmed += double{with.color[4 * i]} / double{without.color[4 * i]};
        brighter = std::max(brighter, double{with.color[4 * i]} / double{without.color[4 * i]});
        ++count;
    }
    std::printf("%zu pixels of foam, dimmed to %.3f, to %.3f at most\n", count,
                dimmed / static_cast<double>(count), brighter);
    EXPECT_GT(count, 100u);
    EXPECT_LT(dimmed / static_cast<double>(count), 0.9);
    EXPECT_LT(brighter, 1.01);
}

// The pattern repeats every 24 m, across the wind without a bend: from the air its rafts would stand in rows.
TEST_F(SeaFoam, RaftsStandInNoRows) {
    Body* body = streakyBody();
    constexpr size_t rows = 64; // of pixels, to a tile
    Camera camera = seaCamera();
    camera.width = camera.height = 8 * rows;
    const double height = 24.0 * 8 / 2 / std::tan(glm::radians(camera.fovDegrees) / 2);
    camera.eye = {0, height, 0};
    camera.target = {0.001 * height, 0, 0};
    double most = -1, elsewhere = 0;
    for (const bool alongX : {true, false}) {
        const WaterPicture p = picture({body}, camera, 60, SurfaceOutput::foam);
        const auto correlation = [&](size_t lag) {
            double sum = 0, squares = 0, products = 0, count = 0;
            for (size_t y = 0; y < camera.height; ++y)
                for (size_t x = 0; x + lag < camera.width; ++x) {
                    const size_t i = alongX ? y * camera.width + x : x * camera.width + y;
                    const double a = p.color[4 * i], b = p.color[4 * (i + lag * (alongX ? 1 : camera.width))];
                    sum += a + b;
                    squares += a * a + b * b;
                    products += a * b;
                    ++count;
                }
            const double mean = sum / (2 * count);
            return (products / count - mean * mean) / (squares / (2 * count) - mean * mean);
        };
        for (const size_t lag : {rows, 2 * rows, 3 * rows}) most = std::max(most, correlation(lag));
        for (const size_t lag : {rows + rows / 2, 2 * rows + rows / 2})
            elsewhere = std::max(elsewhere, std::abs(correlation(lag)));
    }
    std::printf("correlation a tile apart %.3f, between %.3f\n", most, elsewhere);
    EXPECT_LT(most - elsewhere, 0.1); // thick foam has likeness of its own
}

// From an aeroplane a pixel is twice as long as wide and as large as the rafts: they stay white on dark, not
// a veil.
TEST_F(SeaFoam, IsNoVeilFromTheAir) {
    Camera camera = seaCamera();
    camera.width = 128;
    camera.height = 72;
    camera.fovDegrees = 46;
    camera.eye = {0, 400, 0};
    for (const bool downwind : {false, true})
        for (const uint32_t samples : {1u, 4u}) {
            Body* body = streakyBody(samples);
            camera.target = downwind ? glm::dvec3(600, 100, 0) : glm::dvec3(0, 100, 600);
            std::vector<double> drawn = white(body, camera), mean = whiteOf(body, camera, 4);
            for (std::vector<double>* half : {&drawn, &mean}) // the lower
                half->erase(half->begin(), half->begin() + static_cast<std::ptrdiff_t>(half->size() / 2));
            const double contrast = deviationOf(drawn) / deviationOf(mean);
            std::printf("%s, %u samples: %.3f white, %.3f of 16 samples; contrast %.3f of theirs\n",
                        downwind ? "downwind" : "across the wind", samples, meanOf(drawn), meanOf(mean),
                        contrast);
            EXPECT_GT(contrast, 0.9);
            EXPECT_LT(contrast, 1.1);
        }
}

// Between steps it glides: no picture differs from the one before by more than its share of a step.
TEST_F(SeaFoam, GlidesFromStepToStep) {
    Body* body = foamyBody();
    Camera camera = above();
    camera.width = 96;
    camera.height = 54;
    std::vector<double> changes;
    std::vector<float> last;
    for (int frame = 0; frame < 24; ++frame) {
        const WaterPicture p = picture({body}, camera, 60 + frame / 60.0, SurfaceOutput::foam);
        double change = 0;
        for (size_t i = 0; !last.empty() && i < p.color.size(); i += 4)
            change += std::abs(double{p.color[i]} - double{last[i]});
        if (!last.empty()) changes.push_back(change);
        last = p.color;
    }
    const double largest = *std::ranges::max_element(changes);
    std::ranges::sort(changes);
    EXPECT_GT(changes[changes.size() / 2], 0);
    // All of a step at once would be fifteen times a frame's share.
    EXPECT_LT(largest, 3 * changes[changes.size() / 2]);
}

/// How far what the wind blows along the water at 10 m drifts with it in a second: Wu (1975).
glm::dvec2 driftOf(const SeaDesc& sea) {
    const double speed = 0.035 * double{sea.windSpeed}, direction = sea.windDirection;
    return {speed * std::cos(direction), speed * std::sin(direction)};
}

/// How much higher the surface is than 10 m before and behind along the wind: most where it breaks.
std::vector<double> crestsAt(const Sea& sea, double time, const std::vector<glm::dvec2>& places) {
    const glm::dvec2 off = 10.0 * glm::normalize(driftOf(description(sea)));
    std::vector<double> points;
    for (const glm::dvec2& place : places)
        for (const double side : {0.0, -1.0, 1.0})
            points.insert(points.end(), {place.x + side * off.x, place.y + side * off.y});
    std::vector<HeightSample> samples(points.size() / 2);
    HeightGrid* const grid = createHeightGrid(sea, time);
    sampleHeights(*grid, points.data(), samples.size(), samples.data());
    destroyHeightGrid(grid);
    std::vector<double> crests;
    for (size_t i = 0; i < samples.size(); i += 3)
        crests.push_back(double{samples[i].height} -
                         (double{samples[i + 1].height} + double{samples[i + 2].height}) / 2);
    return crests;
}

// What broke some seconds ago lies where the wind has driven it since, whatever breaks now.
TEST_F(SeaFoam, LiesWhereCrestsHaveBrokenBefore) {
    Body* const body = foamyBody();
    Camera camera = above();
    camera.eye.y = 80;
    camera.target = camera.eye + glm::dvec3(0.01, -1, 0);
    camera.width = camera.height = 64;
    std::vector<double> drawn, highest;
    for (const double time : {60.0, 71.0, 82.0, 93.0}) {
        const WaterPicture p = picture({body}, camera, time, SurfaceOutput::foam);
        std::vector<glm::dvec2> places;
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const glm::dvec3 at = worldAt(camera, p, x, y);
                places.push_back({at.x, at.z});
                drawn.push_back(double{p.color[(size_t{y} * p.width + x) * 4]});
            }
        std::vector<double> most(places.size(), -1e9);
        for (double ago = 1; ago < 5; ago += 1) {
            std::vector<glm::dvec2> then = places;
            for (glm::dvec2& place : then) place -= ago * driftOf(description(*sea(body)));
            const std::vector<double> crests = crestsAt(*sea(body), time - ago, then);
            for (size_t i = 0; i < most.size(); ++i) most[i] = std::max(most[i], crests[i]);
        }
        highest.insert(highest.end(), most.begin(), most.end());
    }
    std::printf("correlation of foam with crests of the last seconds %.3f\n", correlationOf(drawn, highest));
    EXPECT_GT(correlationOf(drawn, highest), 0.09);
}

// As the CPU has the gate, whose corners come and go each in its own time.
TEST_F(SeaFoam, IsThickWhereItsGateIsOpen) {
    Body* const body = streakyBody();
    const Sea& sea = *seaglass::sea(body);
    Camera camera = above();
    camera.eye.y = 800;
    camera.target = camera.eye + glm::dvec3(0.01, -1, 0);
    camera.width = camera.height = 128;
    double open = 0, opens = 0, shut = 0, shuts = 0;
    for (const double time : {60.0, 300.0}) {
        const WaterPicture p = picture({body}, camera, time, SurfaceOutput::foam);
        const FoamGate gate(sea, time);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const glm::dvec3 at = worldAt(camera, p, x, y);
                const WarpShift shift = warpAt(sea.warp, at.x, at.z);
                const double patch = cascade(sea, 0).patch;
                const float share = gate.at((at.x + shift.u) / patch, (at.z + shift.v) / patch);
                const double white = double{p.color[(size_t{y} * p.width + x) * 4]};
                if (share > 0.95f) open += white, ++opens;
                if (share < 0.35f) shut += white, ++shuts;
            }
    }
    std::printf("%.4f white in %.0f pixels where it is open, %.4f in %.0f where it is not\n", open / opens,
                opens, shut / shuts, shuts);
    EXPECT_GT(std::min(opens, shuts), 2000);
    EXPECT_GT(open / opens, 2 * shut / shuts);
}

// It is brightest where it has just broken, and thins from then on: most of it, at any time.
TEST_F(SeaFoam, ThinsAsItAges) {
    for (float& channel : lighting.skyIrradiance) channel = 30;
    Body* const body = streakyBody();
    Camera camera = above();
    camera.eye.y = 20;
    camera.target = camera.eye + glm::dvec3(0.01, -1, 0);
    camera.width = camera.height = 96;
    size_t dimmer = 0, brighter = 0;
    for (const double time : {60.0, 67.0}) {
        std::vector<WaterPicture> masks, seen;
        for (const double at : {time, time + 1}) {
            masks.push_back(picture({body}, camera, at, SurfaceOutput::foam));
            seen.push_back(picture({body}, camera, at));
        }
        for (size_t i = 0; i < masks[0].color.size(); i += 4) {
            if (std::min(masks[0].color[i], masks[1].color[i]) < 0.7f) continue;
            ++(seen[1].color[i] < seen[0].color[i] ? dimmer : brighter);
        }
    }
    std::printf("in a second %zu pixels of foam get dimmer, %zu brighter\n", dimmer, brighter);
    EXPECT_GT(dimmer + brighter, 300u);
    EXPECT_GT(dimmer, 2 * brighter);
}

// Bubbles near the surface are gone first: as a plume gets fainter its light has come through more water.
TEST_F(SeaFoam, FaintPlumesAreTheDeepest) {
    for (float& channel : lighting.skyIrradiance) channel = 10;
    const RefractionDesc refraction{.absorption = {0.2f, 0.05f, 0.02f},
                                    .backscatter = {0.002f, 0.002f, 0.002f}};
    const FoamDesc foam;
    SeaDesc sea = breeze();
    sea.windSpeed = 15;
    sea.fetch = 300e3f;
    BodyDesc desc;
    desc.waves = &sea;
    desc.wavesBackend = fftwWaves();
    desc.refraction = &refraction;
    Body* const bare = makeBody(desc);
    desc.foam = &foam;
    Body* const foamy = makeBody(desc);
    Camera camera = above();
    camera.target = camera.eye + glm::dvec3(0.01, -1, 0);
    camera.width = camera.height = 96;
    const WaterPicture mask = picture({foamy}, camera, foamTime, SurfaceOutput::foam);
    const WaterPicture with = picture({foamy}, camera, foamTime), without = picture({bare}, camera, foamTime);
    struct Plume {
        double light, path;
    };
    std::vector<Plume> plumes;
    for (size_t i = 0; i < mask.color.size(); i += 4) {
        if (mask.color[i] > 1e-4f) continue;
        const auto added = [&](size_t c) { return double{with.color[i + c]} - double{without.color[i + c]}; };
        if (added(0) < 1e-3) continue;
        const double path = std::log(added(2) / added(0)) / (0.2 - 0.02);
        plumes.push_back({added(2) * std::exp(0.022 * path), path});
    }
    std::ranges::sort(plumes, {}, &Plume::light);
    const size_t quarter = plumes.size() / 4;
    double faint = 0, bright = 0;
    for (size_t i = 0; i < quarter; ++i) {
        faint += plumes[i].path / static_cast<double>(quarter);
        bright += plumes[plumes.size() - 1 - i].path / static_cast<double>(quarter);
    }
    std::printf("of %zu pixels with plumes light comes %.2f m through water from the brightest, %.2f from "
                "the faintest\n",
                plumes.size(), bright, faint);
    EXPECT_GT(plumes.size(), 400u);
    EXPECT_GT(faint, bright + 0.5);
}

TEST_F(SeaFoam, UploadsAtItsOwnRate) {
    Body* body = foamyBody();
    picture({body}, above(), 60);
    const auto uploads = [&](double time) {
        spiedCalls().clear();
        picture({body}, above(), time);
        return countSpied("CmdCopyBufferToImage");
    };
    const size_t without = uploads(60.01);
    EXPECT_EQ(uploads(60.2), without);
    EXPECT_EQ(uploads(60.26), without + 1);
    EXPECT_EQ(uploads(60.27), without);
}

TEST_F(SeaFoam, DispatchesAtItsOwnRate) {
    Body* body = foamyBody(WavesOn::gpu);
    picture({body}, above(), 60);
    const auto dispatches = [&](double time) {
        spiedCalls().clear();
        picture({body}, above(), time);
        return countSpied("CmdDispatch");
    };
    const size_t wavesAlone = dispatches(60.01);
    EXPECT_EQ(dispatches(60.2), wavesAlone);
    const size_t without = wavesAlone + onGpus(2); // foam's mips
    EXPECT_EQ(dispatches(60.26), without + 3);     // the waves once more, and a step
    EXPECT_EQ(dispatches(60.8), without + 6);
    EXPECT_LE(dispatches(1e6),
              without + 3 * static_cast<size_t>(fadingOf({}).foam.steps + fadingOf({}).plume.steps + 2));
}

// It is uploaded once for all of a context.
TEST_F(SeaFoam, BodiesShareTheirPattern) {
    Camera camera = above();
    camera.width = 96;
    camera.height = 54;
    Body* const first = foamyBody(WavesOn::gpu);
    spiedCalls().clear();
    const WaterPicture alone = picture({first}, camera, foamTime, SurfaceOutput::foam);
    const size_t copies = countSpied("CmdCopyBufferToImage");
    Body* const second = foamyBody(WavesOn::gpu);
    EXPECT_EQ(second->find<FoamPart>()->pattern, first->find<FoamPart>()->pattern);
    spiedCalls().clear();
    EXPECT_EQ(picture({second}, camera, foamTime, SurfaceOutput::foam).color, alone.color);
    EXPECT_EQ(countSpied("CmdCopyBufferToImage"), copies - 1);
}

} // namespace
