// Surfaces that are found first and shaded once: that they look as those that are drawn by their fragments,
// in every place and by every feature, and what calls in another order are told.
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
    /// Shares of what the pictures differ by in the mean, and of pixels that differ by a tenth.
    double mean = 0.02, many = 0.04;
    SurfaceOutput output = SurfaceOutput::shaded;
    double least = 0.02; ///< what is less differs by shares of this
    bool wades = false;  ///< the eye stands on the water, and looks level
};

void PrintTo(const Look& look, std::ostream* out) {
    *out << look.name;
}

void lowSun(LightingDesc& lighting) {
    const glm::dvec3 toSun = glm::normalize(glm::dvec3(0.3, 0.15, -0.94));
    for (int i = 0; i < 3; ++i) lighting.toSun[i] = toSun[i];
    std::ranges::fill(lighting.sunIrradiance, 5.0f);
    std::ranges::fill(lighting.skyIrradiance, 3.0f);
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

/// An eye amid the waves, before which some stand above it and some below.
/// Of an eye that wades.
void atTheWaterline(Described& d, Camera&, LightingDesc&) {
    withWaves(d);
    mayDive(d);
}

void ofWaves(Described& d, Camera&, LightingDesc&) {
    withWaves(d);
}

class Deferred : public WaterTest {
  protected:
    static Camera camera() {
        Camera camera;
        camera.eye = {3, 4, 7};
        camera.target = {3, 2, -13};
        camera.width = 192;
        camera.height = 108;
        return camera;
    }

    WaterPicture deferredPicture(Body* body, const Camera& camera, const SceneBehind& behind = {},
                                 SurfaceOutput output = SurfaceOutput::shaded, double time = 5) {
        return picture({body}, camera, time, output, behind);
    }

    Body* deferredBody(Described& d) {
        d.body.shading.deferred = true;
        return makeBody(d.body);
    }

    Body* wavyBody() {
        withWaves(kept_);
        return deferredBody(kept_);
    }

  private:
    Described kept_;
};

/// Of the same water in both: how the second differs from the first.
struct Difference {
    size_t places = 0; ///< pixels that one alone covers, or by another depth
    size_t covered = 0;
    double mean = 0; ///< of colours, as shares
    double many = 0; ///< share of pixels
};

Difference differenceOf(const WaterPicture& drawn, const WaterPicture& placed, double least) {
    Difference d;
    for (size_t i = 0; i < drawn.depth.size(); ++i) {
        const bool differs =
            drawn.covered(i) != placed.covered(i) ||
            std::abs(drawn.depth[i] - placed.depth[i]) > 2e-4f * std::max(drawn.depth[i], 1e-3f);
        d.places += differs;
        if (!drawn.covered(i) || differs) continue;
        ++d.covered;
        double most = 0;
        for (size_t k = 4 * i; k < 4 * i + 3; ++k) {
            const double a{drawn.color[k]}, b{placed.color[k]};
            most = std::max(most, std::abs(a - b) / std::max(std::abs(a), least));
        }
        EXPECT_TRUE(std::isfinite(most)) << "pixel " << i;
        d.mean += std::min(most, 1.0);
        d.many += most > 0.1;
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

class DeferredLooks : public Deferred, public testing::WithParamInterface<Look> {};

TEST_P(DeferredLooks, AsWhatFragmentsDraw) {
    Described d;
    Camera c = camera();
    lowSun(lighting);
    GetParam().change(d, c, lighting);
    if (!c.reversed) useDepth(false);
    const SurfaceOutput output = GetParam().output;
    Body* const drawn = makeBody(d.body);
    if (GetParam().wades) c.target.y = c.eye.y = heightUnder(*drawn, c) + 0.004;
    // A bed that lies before no water, which this host would draw all the same.
    const SceneBehind behind = planeBelow(c, GetParam().wades ? -12 : -4, 0.3f);
    const WaterPicture by = picture({drawn}, c, 5, output, behind);
    const WaterPicture placed = deferredPicture(deferredBody(d), c, behind, output);
    const Difference differs = differenceOf(by, placed, GetParam().least);
    EXPECT_GT(differs.covered, by.depth.size() / 8);
    EXPECT_LE(differs.places, by.depth.size() / 2000);
    EXPECT_LE(differs.mean, GetParam().mean);
    EXPECT_LE(differs.many, GetParam().many);
    // And the same bits from the same input.
    const WaterPicture again = deferredPicture(deferredBody(d), c, behind, output);
    EXPECT_EQ(std::memcmp(again.color.data(), placed.color.data(), again.color.size() * sizeof(float)), 0);
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
     }},
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
         c.target = {0, 0, 0};
     }},
    {"Parallel",
     [](Described& d, Camera& c, LightingDesc&) {
         withWaves(d);
         c.parallelHeight = 12;
         c.far = 200;
         c.target = {3, -2, -3};
     }},
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
     }},
    {"StillFromBelow",
     [](Described& d, Camera& c, LightingDesc&) {
         mayDive(d);
         c.eye.y = -2;
         c.target.y = 0;
     }},
    {"Waterline", atTheWaterline, 0.02, 0.04, SurfaceOutput::shaded, 0.02, true},
    {"Mirrored", mirrors, 0.02, 0.04, SurfaceOutput::reflection},
    {"MirroredAtTheWaterline", atTheWaterline, 0.02, 0.04, SurfaceOutput::reflection, 0.02, true},
    {"ClassOfWhatIsMirrored", mirrors, 0.02, 0.02, SurfaceOutput::reflectionClass},
    {"ClassAtTheWaterline", atTheWaterline, 0.02, 0.02, SurfaceOutput::reflectionClass, 0.02, true},
    {"Height", ofWaves, 0.01, 0.02, SurfaceOutput::height},
    {"Normal", ofWaves, 0.02, 0.04, SurfaceOutput::normal, 0.5},
    {"FoamAlone",
     [](Described& d, Camera&, LightingDesc&) {
         withWaves(d);
         d.sea.windSpeed = 14;
         d.body.foam = &d.foam;
     },
     0.02, 0.04, SurfaceOutput::foam, 0.5},
    {"SourceOfWhatIsMirrored", mirrors, 0.02, 0.04, SurfaceOutput::reflectionSource},
    {"Slopes", ofWaves, 0.02, 0.04, SurfaceOutput::slopes, 0.25},
};

INSTANTIATE_TEST_SUITE_P(Every, DeferredLooks, testing::ValuesIn(looks),
                         [](const auto& each) { return std::string(each.param.name); });

TEST_F(Deferred, StandsBehindWhatTheHostHasBeforeIt) {
    lowSun(lighting);
    Described d;
    withWaves(d);
    d.body.refraction = &d.refraction;
    const Camera c = camera();
    // A wall from 12 metres on, left of the middle.
    const SceneBehind behind = drawnOver(c, planeBelow(c, -4, 0.3f), 7.0f, [&](const glm::dvec3& ray) {
        return ray.x < 0 && ray.z < 0 ? -12 / ray.z : -1.0;
    });
    const WaterPicture by = picture({makeBody(d.body)}, c, 5, SurfaceOutput::shaded, behind);
    const WaterPicture placed = deferredPicture(deferredBody(d), c, behind);
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

TEST_F(Deferred, OfARegionIsThatOfAViewOfItsOwn) {
    lowSun(lighting);
    Body* body = wavyBody();
    Camera c = camera();
    const WaterPicture whole = deferredPicture(body, c);
    // Larger views before leave larger images, which hold what they showed.
    Camera larger = c;
    larger.width += 64;
    larger.height += 40;
    deferredPicture(body, larger);
    changeView = [&](ViewDesc& view) {
        view.viewport.x = 26;
        view.viewport.y = 14;
        view.viewport.width = static_cast<float>(c.width);
        view.viewport.height = static_cast<float>(c.height);
        view.viewIndex = 0;
        std::copy_n(viewDesc(c).projection, 16, view.projection);
    };
    const WaterPicture part = deferredPicture(body, larger);
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

TEST_F(Deferred, NothingIsDrawnWhereNothingShows) {
    Body* body = wavyBody();
    Camera c = camera();
    c.target = c.eye + glm::dvec3(0, 1, -0.5);
    const WaterPicture p = deferredPicture(body, c);
    for (size_t i = 0; i < p.depth.size(); ++i) ASSERT_FALSE(p.covered(i)) << i;
}

TEST_F(Deferred, WhatComesFirstIsNamed) {
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
    expectMisuse(
        "draw: ShadingDesc.deferred is true, and shade\\(\\) was not called for the body and this view");
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

/// Two frames of an eye that moves: how far the second's water has come.
TEST_F(Deferred, HasTheSameMotion) {
    Described d;
    withWaves(d);
    d.body.motion = true;
    d.body.extent.shape = ExtentShape::rectangle;
    d.body.extent.size[0] = d.body.extent.size[1] = 60;
    Camera c = camera();
    Camera next = c;
    next.eye += glm::dvec3(0.2, -0.1, -0.3);
    // The second view begins at a corner of its own.
    const auto inRegion = [](ViewDesc& view) {
        view.viewport.x = 16;
        view.viewport.y = 8;
        view.viewport.width -= 16;
        view.viewport.height -= 8;
    };
    for (const VkSampleCountFlagBits samples : {VK_SAMPLE_COUNT_1_BIT, VK_SAMPLE_COUNT_4_BIT}) {
        useSamples(samples);
        Body* const drawn = makeBody(d.body);
        picture({drawn}, c, 5, SurfaceOutput::motion);
        changeView = inRegion;
        const WaterPicture by = picture({drawn}, next, 5.1, SurfaceOutput::motion);
        changeView = nullptr;
        d.body.shading.deferred = true;
        Body* const placed = makeBody(d.body);
        d.body.shading.deferred = false;
        deferredPicture(placed, c, {}, SurfaceOutput::motion);
        changeView = inRegion;
        const WaterPicture of = deferredPicture(placed, next, {}, SurfaceOutput::motion, 5.1);
        changeView = nullptr;
        size_t covered = 0, differ = 0;
        double greatest = 0;
        for (size_t i = 0; i < by.depth.size(); ++i) {
            const bool both = by.color[4 * i + 3] == 1 && of.color[4 * i + 3] == 1;
            covered += both;
            if (!both) continue;
            const double x{by.color[4 * i]}, y{by.color[4 * i + 1]};
            greatest = std::max(greatest, std::hypot(x, y));
            // Two triangles meet in a pixel, here and there, and either is drawn; of samples their mean.
            differ += std::hypot(x - double{of.color[4 * i]}, y - double{of.color[4 * i + 1]}) >
                      (samples == VK_SAMPLE_COUNT_1_BIT ? 0.02 : 0.1);
        }
        EXPECT_GT(covered, by.depth.size() / 8);
        EXPECT_GT(greatest, 1);
        EXPECT_LE(differ, samples == VK_SAMPLE_COUNT_1_BIT ? covered / 1000 : covered / 20);
    }
}

/// Each is shaded for itself, and is there until the frame ends.
TEST_F(Deferred, OutputsOfAFrameStandBesideEachOther) {
    lowSun(lighting);
    Body* body = wavyBody();
    const WaterPicture heights = deferredPicture(body, camera(), {}, SurfaceOutput::height);
    const WaterPicture light = deferredPicture(body, camera());
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

TEST_F(Deferred, SamplesBesideTheMiddleTakeANeighboursColour) {
    lowSun(lighting);
    useSamples(VK_SAMPLE_COUNT_4_BIT);
    Described d;
    withWaves(d);
    d.body.extent.shape = ExtentShape::rectangle;
    d.body.extent.size[0] = d.body.extent.size[1] = 60;
    const Camera c = camera();
    const WaterPicture by = picture({makeBody(d.body)}, c, 5);
    const WaterPicture placed = deferredPicture(deferredBody(d), c);
    // Resolved, so that what samples are covered shows in the alpha: 1, mixed with what was cleared.
    size_t edges = 0, differ = 0;
    for (size_t i = 0; i < by.depth.size(); ++i) {
        const float a = by.color[4 * i + 3], b = placed.color[4 * i + 3];
        edges += a != 1 && a != WaterPicture::untouched;
        differ += a != b;
    }
    EXPECT_GT(edges, 50u);
    EXPECT_LE(differ, edges / 20);
}

TEST_F(Deferred, OfAHostThatLeavesDepthAloneIsTheNearest) {
    lowSun(lighting);
    Body* body = wavyBody();
    const WaterPicture tested = deferredPicture(body, camera());
    leaveDepth();
    const WaterPicture left = deferredPicture(body, camera());
    EXPECT_EQ(std::memcmp(tested.color.data(), left.color.data(), tested.color.size() * sizeof(float)), 0);
}

TEST_F(Deferred, IsMadeAheadByPrepare) {
    lowSun(lighting);
    Described d;
    withWaves(d);
    mayDive(d);
    d.body.motion = true;
    Body* body = deferredBody(d);
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
            deferredPicture(body, c, {}, output);
        }
        EXPECT_EQ(countSpied("CreateGraphicsPipelines") + countSpied("CreateComputePipelines"), 0u)
            << static_cast<int>(output);
    }
}

TEST_F(Deferred, ItsImagesAreEstimated) {
    Described d;
    Estimate without, with;
    ASSERT_EQ(estimate(context(), &d.body, {640, 360}, &without), Status::ok);
    d.body.shading.deferred = true;
    ASSERT_EQ(estimate(context(), &d.body, {640, 360}, &with), Status::ok);
    const uint64_t pixels = uint64_t{640} * 360;
    EXPECT_GE(with.bytesPerView - without.bytesPerView, 16 * pixels);
    EXPECT_LE(with.bytesPerView - without.bytesPerView, 17 * pixels);
}

} // namespace
