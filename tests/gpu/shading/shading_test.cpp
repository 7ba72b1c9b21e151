// Surfaces are found first and shaded once: that pixels show the mean of what finer ones do, in every place
// and by every feature, and what calls in another order are told.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// Of all that a body may point at.
struct Described {
    SeaDesc sea = breeze();
    FoamDesc foam;
    UnderwaterDesc underwater;
    RefractionDesc refraction;
    ReflectionDesc reflection;
    ShoreDesc shore;
    std::vector<float> bed;
    std::vector<double> points;
    std::vector<uint32_t> indices;
    BodyDesc body;
};

struct Look {
    const char* name;
    void (*change)(Described&, Camera&, LightingDesc&);
    /// Shares of what the pictures differ by in the mean, and of pixels that differ by half.
    double mean = 0.09, many = 0.035;
    SurfaceOutput output = SurfaceOutput::shaded;
    double least = 0.02; ///< what is less differs by shares of this
    bool wades = false;  ///< the eye stands on the water, and looks level
};

void PrintTo(const Look& look, std::ostream* out) {
    *out << look.name;
}

void withWaves(Described& d) {
    d.body.waves = &d.sea;
    d.body.wavesBackend = fftwWaves();
}

void mirrors(Described& d, Camera&, LightingDesc&) {
    withWaves(d);
    d.body.refraction = &d.refraction;
    d.body.reflection = &d.reflection;
}

void mayDive(Described& d) {
    d.body.refraction = &d.refraction;
    d.body.reflection = &d.reflection;
    d.body.underwater = &d.underwater;
}

/// Of an eye that wades: some waves before it stand above it, and some below.
void atTheWaterline(Described& d, Camera&, LightingDesc&) {
    withWaves(d);
    mayDive(d);
}

void ofWaves(Described& d, Camera&, LightingDesc&) {
    withWaves(d);
}

class Shading : public WaterTest {
  protected:
    static Camera camera() {
        Camera camera;
        camera.eye = {3, 4, 7};
        camera.target = {3, 2, -13};
        camera.width = 192;
        camera.height = 108;
        return camera;
    }

    void lowSun() {
        shineFrom(glm::normalize(glm::dvec3(0.3, 0.15, -0.94)), 5);
        std::ranges::fill(lighting.skyIrradiance, 3.0f);
    }

    WaterPicture taken(Body* body, const Camera& camera, const SceneBehind& behind = {},
                       SurfaceOutput output = SurfaceOutput::shaded, double time = 5) {
        return picture({body}, camera, time, output, behind);
    }

    Body* wavyBody() {
        withWaves(kept_);
        return makeBody(kept_.body);
    }

  private:
    Described kept_;
};

/// Of the same water in both: how the first differs from the mean of the other's pixels, so many to one of it
/// each way.
struct Difference {
    size_t places = 0; ///< pixels whose middles one alone covers
    size_t covered = 0;
    double mean = 0; ///< of colours, as shares
    double many = 0; ///< share of pixels
};

constexpr uint32_t finer = 3;

Difference differenceOf(const WaterPicture& coarse, const WaterPicture& fine, double least) {
    Difference d;
    for (uint32_t y = 0; y < coarse.height; ++y)
        for (uint32_t x = 0; x < coarse.width; ++x) {
            const size_t i = size_t{y} * coarse.width + x;
            double sums[3] = {};
            bool whole = coarse.covered(i);
            for (uint32_t k = 0; k < finer * finer; ++k) {
                const size_t j = size_t{finer * y + k / finer} * fine.width + finer * x + k % finer;
                whole = whole && fine.covered(j);
                for (size_t c = 0; c < 3; ++c) sums[c] += double{fine.color[4 * j + c]} / (finer * finer);
            }
            const size_t middle = size_t{finer * y + finer / 2} * fine.width + finer * x + finer / 2;
            d.places += coarse.covered(i) != fine.covered(middle);
            if (!whole) continue;
            ++d.covered;
            double most = 0;
            for (size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(double{coarse.color[4 * i + c]} - sums[c]) /
                                          std::max(std::abs(sums[c]), least));
            EXPECT_TRUE(std::isfinite(most)) << "pixel " << i;
            d.mean += std::min(most, 1.0);
            d.many += most > 0.5;
        }
    d.mean /= static_cast<double>(std::max<size_t>(d.covered, 1));
    d.many /= static_cast<double>(std::max<size_t>(d.covered, 1));
    return d;
}

double heightUnder(const Body& body, const Camera& camera) {
    if (!sea(&body)) return 0;
    const double place[2] = {camera.eye.x, camera.eye.z};
    HeightSample sample;
    sampleHeights(*sea(&body), 5, place, 1, &sample);
    return double{sample.height};
}

class ShadedLooks : public Shading, public testing::WithParamInterface<Look> {};

TEST_P(ShadedLooks, AsTheMeanOfFinerPixels) {
    Described d;
    Camera c = camera();
    c.width /= 2, c.height /= 2;
    lowSun();
    GetParam().change(d, c, lighting);
    if (!c.reversed) useDepth(false);
    const SurfaceOutput output = GetParam().output;
    Body* const body = makeBody(d.body);
    if (GetParam().wades) c.target.y = c.eye.y = heightUnder(*body, c) + 0.004;
    // A bed that lies before no water, which this host would draw all the same.
    const auto shown = [&] {
        return taken(body, c, planeBelow(c, GetParam().wades ? -12 : -4, 0.3f), output);
    };
    const WaterPicture coarse = shown();
    // And the same bits from the same input.
    const WaterPicture again = shown();
    EXPECT_EQ(std::memcmp(again.color.data(), coarse.color.data(), again.color.size() * sizeof(float)), 0);
    c.width *= finer, c.height *= finer;
    const Difference differs = differenceOf(coarse, shown(), GetParam().least);
    std::printf("%zu of %zu elsewhere; by %.4f, %.4f of them by half\n", differs.places, differs.covered,
                differs.mean, differs.many);
    EXPECT_GT(differs.covered, coarse.depth.size() / 8);
    EXPECT_LE(differs.places, coarse.depth.size() / 200);
    EXPECT_LE(differs.mean, GetParam().mean);
    EXPECT_LE(differs.many, GetParam().many);
}

const Look looks[] = {
    {"Waves", ofWaves},
    {"ForwardDepth",
     [](Described& d, Camera& c, LightingDesc&) {
         withWaves(d);
         c.reversed = false;
     }},
    {"Foam",
     [](Described& d, Camera&, LightingDesc&) {
         withWaves(d);
         d.sea.windSpeed = 14;
         d.body.foam = &d.foam;
     }},
    {"FineSlopes",
     [](Described& d, Camera&, LightingDesc&) {
         withWaves(d);
         setQuality(Quality::highest, &d.body, &d.reflection);
     }},
    {"Mirrors",
     [](Described& d, Camera&, LightingDesc&) {
         withWaves(d);
         d.refraction.scattering = 0.1f;
         d.body.refraction = &d.refraction;
         d.body.reflection = &d.reflection;
     }},
    {"Globe",
     [](Described& d, Camera& c, LightingDesc&) {
         withWaves(d);
         d.body.extent.planetRadius = 6.371e6;
         c.eye.y = 40;
         c.target.y = 20;
     }},
    {"Outline",
     [](Described& d, Camera&, LightingDesc&) {
         withWaves(d);
         d.body.extent.shape = ExtentShape::rectangle;
         d.body.extent.size[0] = d.body.extent.size[1] = 60;
     }},
    {"HostMesh",
     [](Described& d, Camera&, LightingDesc&) {
         d.points = {-30, -30, 30, -30, 30, 30, -30, 30};
         d.indices = {0, 1, 2, 0, 2, 3};
         d.body.extent.shape = ExtentShape::mesh;
         d.body.extent.points = d.points.data();
         d.body.extent.pointCount = 4;
         d.body.extent.indices = d.indices.data();
         d.body.extent.indexCount = 6;
     },
     0.01, 0.01},
    {"Shore",
     [](Described& d, Camera& c, LightingDesc&) {
         withWaves(d);
         d.bed.assign(size_t{64} * 64, 0);
         for (size_t i = 0; i < d.bed.size(); ++i) d.bed[i] = -6 + 0.15f * static_cast<float>(i / 64);
         d.shore.bed = d.bed.data();
         d.shore.samples[0] = d.shore.samples[1] = 64;
         d.shore.origin[0] = d.shore.origin[1] = -32;
         d.sea.shore = &d.shore;
         d.body.refraction = &d.refraction;
         c.eye = {0, 5, -20};
         // The horizon lies between the middles of two rows: at 0 it is 0.007 pixels from one, and drivers
         // place vertices on grids of up to 1/16 pixel.
         c.target = {0, -0.2, 0};
     },
     0.04, 0.01},
    {"Parallel",
     [](Described& d, Camera& c, LightingDesc&) {
         withWaves(d);
         c.parallelHeight = 12;
         c.far = 200;
         c.target = {3, -2, -3};
     },
     0.12},
    {"Tilted",
     [](Described& d, Camera&, LightingDesc&) {
         withWaves(d);
         d.body.plane[0] = 0.1;
     }},
    {"FromBelow",
     [](Described& d, Camera& c, LightingDesc&) {
         withWaves(d);
         mayDive(d);
         c.eye.y = -3;
         c.target.y = 0;
     },
     0.03, 0.01},
    {"StillFromBelow",
     [](Described& d, Camera& c, LightingDesc&) {
         mayDive(d);
         c.eye.y = -2;
         c.target.y = 0;
     },
     0.01, 0.01},
    {"Waterline", atTheWaterline, 0.015, 0.01, SurfaceOutput::shaded, 0.02, true},
    {"Mirrored", mirrors, 0.02, 0.01, SurfaceOutput::reflection},
    {"MirroredAtTheWaterline", atTheWaterline, 0.03, 0.01, SurfaceOutput::reflection, 0.02, true},
    {"ClassOfWhatIsMirrored", mirrors, 0.4, 0.4, SurfaceOutput::reflectionClass},
    {"ClassAtTheWaterline", atTheWaterline, 0.01, 0.01, SurfaceOutput::reflectionClass, 0.02, true},
    {"Height", ofWaves, 0.05, 0.02, SurfaceOutput::height, 0.5},
    {"Normal", ofWaves, 0.0385, 0.01, SurfaceOutput::normal, 0.5},
    {"FoamAlone",
     [](Described& d, Camera&, LightingDesc&) {
         withWaves(d);
         d.sea.windSpeed = 14;
         d.body.foam = &d.foam;
     },
     0.02, 0.01, SurfaceOutput::foam, 0.5},
    {"SourceOfWhatIsMirrored", mirrors, 0.02, 0.01, SurfaceOutput::reflectionSource},
    {"Slopes", ofWaves, 0.078, 0.01, SurfaceOutput::slopes, 0.25},
};

INSTANTIATE_TEST_SUITE_P(Every, ShadedLooks, testing::ValuesIn(looks),
                         [](const auto& each) { return std::string(each.param.name); });

TEST_F(Shading, StandsBehindWhatTheHostHasBeforeIt) {
    lowSun();
    Described d;
    withWaves(d);
    d.body.refraction = &d.refraction;
    const Camera c = camera();
    // A wall from 12 metres on, left of the middle.
    const SceneBehind behind = drawnOver(c, planeBelow(c, -4, 0.3f), 7.0f, [&](const glm::dvec3& ray) {
        return ray.x < 0 && ray.z < 0 ? -12 / ray.z : -1.0;
    });
    const WaterPicture by = taken(makeBody(d.body), c), placed = taken(makeBody(d.body), c, behind);
    // The tests' host clears its depth: all that the scene lies before is left out as the surface is found.
    size_t wall = 0, wrong = 0;
    for (uint32_t y = 0; y < c.height; ++y)
        for (uint32_t x = 0; x < c.width; ++x) {
            const size_t i = size_t{y} * c.width + x;
            const bool hidden = by.covered(i) && behind.depth[i] > 1.01f * by.depth[i];
            wall += hidden;
            wrong += by.covered(i) && placed.covered(i) == hidden &&
                     std::abs(behind.depth[i] / by.depth[i] - 1) > 0.01f;
        }
    EXPECT_GT(wall, 1000u);
    EXPECT_EQ(wrong, 0u);
}

TEST_F(Shading, OfARegionIsThatOfAViewOfItsOwn) {
    lowSun();
    Body* body = wavyBody();
    Camera c = camera();
    const WaterPicture whole = taken(body, c);
    // Larger views before leave larger images, which hold what they showed.
    Camera larger = c;
    larger.width += 64;
    larger.height += 40;
    taken(body, larger);
    changeView = [&](ViewDesc& view) {
        view.viewport.x = 26;
        view.viewport.y = 14;
        view.viewport.width = static_cast<float>(c.width);
        view.viewport.height = static_cast<float>(c.height);
        view.viewIndex = 0;
        std::copy_n(viewDesc(c).projection, 16, view.projection);
    };
    const WaterPicture part = taken(body, larger);
    changeView = nullptr;
    size_t differ = 0;
    for (uint32_t y = 0; y < c.height; ++y)
        for (uint32_t x = 0; x < c.width; ++x) {
            const size_t i = size_t{y} * c.width + x, j = size_t{y + 14} * larger.width + x + 26;
            bool same = whole.covered(i) == part.covered(j);
            for (size_t k = 0; k < 3 && same && whole.covered(i); ++k)
                same = std::abs(whole.color[4 * i + k] - part.color[4 * j + k]) <=
                       0.02f * std::abs(whole.color[4 * i + k]);
            differ += !same;
        }
    EXPECT_LE(differ, size_t{c.width} * c.height / 500);
}

TEST_F(Shading, NothingIsDrawnWhereNothingShows) {
    Body* body = wavyBody();
    Camera c = camera();
    c.target = c.eye + glm::dvec3(0, 1, -0.5);
    const WaterPicture p = taken(body, c);
    for (size_t i = 0; i < p.depth.size(); ++i) ASSERT_FALSE(p.covered(i)) << i;
}

TEST_F(Shading, WhatComesFirstIsNamed) {
    Body* body = wavyBody();
    const Camera c = camera();
    const auto expectMisuse = [&](const char* words) {
        drawing = [&, words](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            EXPECT_MISUSE(draw(commands, target, &body, 1, &view, &lighting), words, message());
            return Status::ok;
        };
        const WaterPicture p = picture({body}, c);
        for (size_t i = 0; i < p.depth.size(); ++i) ASSERT_FALSE(p.covered(i)) << words;
    };
    expectMisuse("draw: shade\\(\\) was not called for the body and this view, with this output, in this "
                 "frame before");
    const auto shadeWith = [&](const std::function<void(ViewDesc&, LightingDesc&)>& change) {
        beforeDrawing = [&, change](VkCommandBuffer commands, const ViewDesc& view) {
            ViewDesc other = view;
            LightingDesc light = lighting;
            change(other, light);
            return shade(commands, &body, 1, &other, &light);
        };
    };
    shadeWith([](ViewDesc& view, LightingDesc&) { view.viewIndex = 1; });
    expectMisuse("shade\\(\\) was not called for the body and this view");
    beforeDrawing = [&](VkCommandBuffer commands, const ViewDesc& view) {
        return shade(commands, &body, 1, &view, &lighting, SurfaceOutput::slopes);
    };
    expectMisuse("with this output, in this frame");
    const char* const changed = "draw: the view or the lighting has changed since shade\\(\\)";
    shadeWith([](ViewDesc&, LightingDesc& light) { light.sunIrradiance[1] = 3; });
    expectMisuse(changed);
    shadeWith([](ViewDesc&, LightingDesc& light) { light.skyCube = VK_NULL_HANDLE; });
    expectMisuse(changed);
    shadeWith([](ViewDesc& view, LightingDesc&) { view.view[12] += 0.1; });
    expectMisuse(changed);
    // What was shaded in the frame before is old.
    shadeWith([](ViewDesc&, LightingDesc&) {});
    drawing = nullptr;
    picture({body}, c);
    beforeDrawing = nullptr;
    expectMisuse("shade\\(\\) was not called for the body and this view, with this output, in this frame");
}

/// Two frames of an eye that moves, of which the second begins at a corner of its own: how far still water
/// has come.
TEST_F(Shading, OfMotionIsOfTheRegionAndOfSamplesTheirMean) {
    Described d;
    d.body.extent.shape = ExtentShape::rectangle;
    d.body.extent.size[0] = d.body.extent.size[1] = 60;
    const Camera c = camera();
    Camera next = c;
    next.eye += glm::dvec3(0.2, -0.1, -0.3);
    const glm::dvec2 corner(16, 8), size(c.width, c.height);
    for (const VkSampleCountFlagBits samples : {VK_SAMPLE_COUNT_1_BIT, VK_SAMPLE_COUNT_4_BIT}) {
        useSamples(samples);
        Body* const body = makeBody(d.body);
        taken(body, c, {}, SurfaceOutput::motion);
        changeView = [&](ViewDesc& view) {
            view.viewport.x = static_cast<float>(corner.x);
            view.viewport.y = static_cast<float>(corner.y);
            view.viewport.width -= view.viewport.x;
            view.viewport.height -= view.viewport.y;
        };
        const WaterPicture p = taken(body, next, {}, SurfaceOutput::motion, 5.1);
        changeView = nullptr;
        const glm::dmat4 before = projectionMatrix(c) * viewMatrix(c);
        const glm::dmat4 worldFromClip = glm::inverse(projectionMatrix(next) * viewMatrix(next));
        size_t covered = 0;
        double greatest = 0, worst = 0;
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                if (p.color[4 * i + 3] != 1) continue; // mixed with what was cleared, along the edge
                const glm::dvec2 here = glm::dvec2(x + 0.5, y + 0.5) - corner;
                const glm::dvec4 there =
                    worldFromClip * glm::dvec4(here / (size - corner) * 2.0 - 1.0, double{p.depth[i]}, 1);
                const glm::dvec4 was = before * glm::dvec4(glm::dvec3(there) / there.w, 1);
                const glm::dvec2 expected = here - (glm::dvec2(was) / was.w * 0.5 + 0.5) * size;
                const glm::dvec2 moved(p.color[4 * i], p.color[4 * i + 1]);
                ++covered;
                greatest = std::max(greatest, glm::length(expected));
                worst = std::max(worst, glm::length(moved - expected));
            }
        EXPECT_GT(covered, p.depth.size() / 8);
        EXPECT_GT(greatest, 1);
        std::printf("motion up to %.2f pixels, off by %.4f at most\n", greatest, worst);
        EXPECT_LT(worst, samples == VK_SAMPLE_COUNT_1_BIT ? 0.05 : 0.5);
    }
}

/// Each is shaded for itself, and is there until the frame ends.
TEST_F(Shading, OutputsOfAFrameStandBesideEachOther) {
    lowSun();
    Body* body = wavyBody();
    const WaterPicture heights = taken(body, camera(), {}, SurfaceOutput::height);
    const WaterPicture light = taken(body, camera());
    beforeDrawing = [&](VkCommandBuffer commands, const ViewDesc& view) {
        const Status first = shade(commands, &body, 1, &view, &lighting, SurfaceOutput::height);
        return first == Status::ok ? shade(commands, &body, 1, &view, &lighting) : first;
    };
    const auto drawnOf = [&](SurfaceOutput output) {
        drawing = [&, output](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            return draw(commands, target, &body, 1, &view, &lighting, output);
        };
        return picture({body}, camera(), 5);
    };
    const WaterPicture height = drawnOf(SurfaceOutput::height), lit = drawnOf(SurfaceOutput::shaded);
    const auto same = [](const WaterPicture& a, const WaterPicture& b) {
        return std::memcmp(a.color.data(), b.color.data(), a.color.size() * sizeof(float)) == 0;
    };
    EXPECT_TRUE(same(heights, height));
    EXPECT_TRUE(same(light, lit));
    EXPECT_FALSE(same(heights, lit));
}

/// By how the camera is rolled.
class ShadingInSamples : public Shading, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Rolled, ShadingInSamples, testing::Values(0, 90));

TEST_P(ShadingInSamples, BesideTheMiddleTakeANeighboursColour) {
    lowSun();
    Described d;
    withWaves(d);
    d.body.extent.shape = ExtentShape::rectangle;
    d.body.extent.size[0] = d.body.extent.size[1] = 60;
    Camera c = camera();
    c.rollDegrees = GetParam();
    Body* const body = makeBody(d.body);
    const WaterPicture middles = taken(body, c);
    constexpr uint32_t parts = 4;
    Camera finely = c;
    finely.width *= parts, finely.height *= parts;
    const WaterPicture fine = taken(body, finely);
    useSamples(VK_SAMPLE_COUNT_4_BIT);
    const WaterPicture resolved = taken(body, c);
    // What samples are covered shows in the alpha: 1, mixed with what was cleared.
    size_t edges = 0, wrong = 0, beyond = 0;
    for (int y = 1; y + 1 < static_cast<int>(c.height); ++y)
        for (int x = 1; x + 1 < static_cast<int>(c.width); ++x) {
            const size_t i = size_t(y) * c.width + size_t(x);
            const double share = (double{resolved.color[4 * i + 3]} - double{WaterPicture::untouched}) /
                                 (1 - double{WaterPicture::untouched});
            double expected = 0;
            for (uint32_t k = 0; k < parts * parts; ++k)
                expected += fine.covered((parts * size_t(y) + k / parts) * fine.width + parts * size_t(x) +
                                         k % parts) /
                            double{parts * parts};
            double least = 1e9, most = -1e9;
            for (int k = 0; k < 9; ++k) {
                const size_t j = size_t(y + k / 3 - 1) * c.width + size_t(x + k % 3 - 1);
                if (!middles.covered(j)) continue;
                least = std::min(least, double{middles.color[4 * j + 1]});
                most = std::max(most, double{middles.color[4 * j + 1]});
            }
            edges += expected > 0 && expected < 1;
            wrong += std::abs(share - expected) > 0.3;
            if (share < 0.001 || share > 0.999) continue;
            const double water =
                (double{resolved.color[4 * i + 1]} - (1 - share) * double{WaterPicture::untouched}) / share;
            beyond += water < least - 0.02 || water > most + 0.02;
        }
    std::printf("%zu edges, %zu of another share, %zu of another colour\n", edges, wrong, beyond);
    EXPECT_GT(edges, 30u);
    // Of quarters that are covered one more or less is much: so coarse a grid moves edges past samples.
    EXPECT_LE(static_cast<double>(wrong), static_cast<double>(edges) * limitOnGrid(1.0 / 8, 1.0 / 6));
    EXPECT_EQ(beyond, 0u);
}

// Ponds narrower than a tile, whose water lies in any part of it.
TEST_F(Shading, HoldsEachPixelThatIsCovered) {
    Described d;
    d.body.extent.shape = ExtentShape::rectangle;
    d.body.extent.size[0] = 0.4;
    d.body.extent.size[1] = 6;
    Camera c = camera();
    c.eye = {0, 10, 8};
    c.target = {0, 0, 0};
    size_t covered = 0, dark = 0;
    for (int i = 0; i < 8; ++i) {
        d.body.extent.center[0] = 0.3 * i;
        const WaterPicture p = taken(makeBody(d.body), c);
        for (size_t j = 0; j < p.depth.size(); ++j) {
            if (!p.covered(j)) continue;
            ++covered;
            dark += p.color[4 * j + 1] < 1e-3f ? 1 : 0;
        }
    }
    std::printf("%zu of %zu pixels are dark\n", dark, covered);
    EXPECT_GT(covered, 1000u);
    EXPECT_EQ(dark, 0u);
}

// Where a crest hides what lies behind it, either is seen as finely as right beside that edge.
TEST_F(Shading, WhatACrestHidesBlursNothingOfIt) {
    Described d;
    withWaves(d);
    d.sea.windSpeed = 10;
    Body* const body = makeBody(d.body);
    Camera c = camera();
    c.eye.y = 1.5;
    c.target.y = 1;
    double widened = 0;
    size_t edges = 0;
    for (const double time : {5.0, 9.0, 13.0}) {
        const WaterPicture p = taken(body, c, {}, SurfaceOutput::slopes, time);
        const auto nearness = [&](uint32_t x, uint32_t y) {
            return double{p.depth[size_t{y} * c.width + x]};
        };
        const auto variance = [&](uint32_t x, uint32_t y) {
            const float* const texel = &p.color[(size_t{y} * c.width + x) * 4];
            return double{texel[2]} + double{texel[3]};
        };
        for (uint32_t y = 1; y + 2 < c.height; ++y)
            for (uint32_t x = 0; x < c.width; ++x) {
                bool covered = true;
                for (uint32_t i = y - 1; i <= y + 2; ++i) covered &= p.covered(size_t{i} * c.width + x);
                // The crest's last row is y + 1.
                if (!covered || nearness(x, y + 1) < 1.5 * nearness(x, y) || nearness(x, y + 1) < c.near / 20)
                    continue;
                ++edges;
                widened += std::log(variance(x, y + 1) / variance(x, y + 2));
            }
    }
    widened /= static_cast<double>(edges);
    std::printf("%zu edges, variance that is not seen there e^%.3f of that beside them\n", edges, widened);
    EXPECT_GT(edges, 30u);
    EXPECT_LT(widened, 0.1);
}

TEST_F(Shading, OfAHostThatLeavesDepthAloneIsTheNearest) {
    lowSun();
    Body* body = wavyBody();
    const WaterPicture tested = taken(body, camera());
    leaveDepth();
    const WaterPicture left = taken(body, camera());
    EXPECT_EQ(std::memcmp(tested.color.data(), left.color.data(), tested.color.size() * sizeof(float)), 0);
}

TEST_F(Shading, IsMadeAheadByPrepare) {
    lowSun();
    Described d;
    withWaves(d);
    mayDive(d);
    d.body.motion = true;
    Body* body = makeBody(d.body);
    for (const SurfaceOutput output : {SurfaceOutput::shaded, SurfaceOutput::normal, SurfaceOutput::motion}) {
        drawing = [&](VkCommandBuffer, Target* target, const ViewDesc& view) {
            return prepare(target, body, &view, &lighting, output);
        };
        picture({body}, camera());
        drawing = nullptr;
        spiedCalls().clear();
        for (const double height : {4.0, 0.1, -3.0}) {
            Camera c = camera();
            c.eye.y = height;
            taken(body, c, {}, output);
        }
        EXPECT_EQ(countSpied("CreateGraphicsPipelines") + countSpied("CreateComputePipelines"), 0u)
            << static_cast<int>(output);
    }
}

TEST_F(Shading, ItsImagesAreEstimated) {
    const BodyDesc desc;
    Estimate estimated;
    ASSERT_EQ(estimate(context(), &desc, {640, 360}, &estimated), Status::ok);
    const uint64_t pixels = uint64_t{640} * 360;
    EXPECT_GE(estimated.bytesPerView, 16 * pixels);
    EXPECT_LE(estimated.bytesPerView, 17 * pixels);
}

} // namespace
