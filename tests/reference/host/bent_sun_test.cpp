// Shadows under water lie where the ray falls that the surface bends: as the reference traces them.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/program/demo_scenes.h"
#include "tests/reference/box_file.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 200, height = 150;

/// Clear, calm water over an even bed, seen from above, in a sun that stands 30 degrees high over +X and a
/// little over +Z.
Scene calmWater(const std::string& name, std::vector<tests::Box> things, double depth = 2) {
    things.push_back({{-20, -depth - 1, -20}, {20, -depth, 20}});
    Scene scene;
    scene.sky.file = tests::demoTexture("harbour_sky.exr");
    scene.sky.intensity = 0.2;
    scene.sun.azimuthDeg = 20;
    scene.sun.elevationDeg = 30;
    scene.sun.irradiance = {10, 10, 10};
    scene.meshes.push_back({tests::writeBoxes(name, things, 0.5)});
    scene.water.emplace().refraction.emplace().type = "pool";
    scene.cameras.emplace_back();
    scene.cameras[0].positionM = {-2, 9, 0.3};
    scene.cameras[0].targetM = {-2, 0, 0};
    return scene;
}

double brightness(const Picture& picture, size_t pixel) {
    return static_cast<double>(picture.rgba[pixel * 4] + picture.rgba[pixel * 4 + 1] +
                               picture.rgba[pixel * 4 + 2]);
}

/// Rows of a picture.
struct Rows {
    size_t from = 0, to = height;
};

/// Pixels that are darker than halfway between a dark and a bright one.
std::vector<bool> shaded(const Picture& picture, const Rows& rows) {
    std::vector<double> values;
    for (size_t i = rows.from * width; i < rows.to * width; ++i) values.push_back(brightness(picture, i));
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    const double halfway = (sorted[sorted.size() / 50] + sorted[sorted.size() * 9 / 10]) / 2;
    std::vector<bool> dark;
    for (const double value : values) dark.push_back(value < halfway);
    return dark;
}

struct Pictures {
    Picture drawn, traced;
};

Picture drawnOf(const Scene& scene) {
    HostDesc desc;
    desc.validation = true;
    Error error;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    EXPECT_TRUE(host) << error.text;
    if (!host) return {width, height, std::vector<float>(size_t{4} * width * height)};
    Picture picture = tests::rendered(*host, scene, width, height);
    EXPECT_EQ(host->validationMessages(), 0u);
    return picture;
}

Picture tracedOf(const Scene& scene, uint32_t samples) {
    return tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, samples}).color;
}

Pictures picturesOf(const Scene& scene) {
    return {drawnOf(scene), tracedOf(scene, 16)};
}

void expectAlike(const Pictures& pictures, const Rows& rows = {}) {
    const std::vector<bool> drawn = shaded(pictures.drawn, rows), traced = shaded(pictures.traced, rows);
    size_t both = 0, either = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
        both += drawn[i] && traced[i];
        either += drawn[i] || traced[i];
    }
    const double alike = static_cast<double>(both) / static_cast<double>(either);
    std::printf("shaded in either %zu, in both %.3f of them\n", either, alike);
    EXPECT_GT(either, 500u);
    EXPECT_GT(alike, 0.93);
}

/// As a share of what is traced.
double brightnessDrawn(const Pictures& pictures) {
    double drawn = 0, traced = 0;
    for (size_t i = 0; i < size_t{width} * height; ++i) {
        drawn += brightness(pictures.drawn, i);
        traced += brightness(pictures.traced, i);
    }
    std::printf("drawn %.4f of what is traced\n", drawn / traced);
    return drawn / traced;
}

const std::vector<tests::Box> board = {{{0.5, 0.6, -1.5}, {2.5, 0.7, 1.5}}};
const std::vector<tests::Box> post = {{{0.6, -2, -0.3}, {1.2, 1.2, 0.3}}};

TEST(BentSun, ShadesTheBedUnderABoard) {
    expectAlike(picturesOf(calmWater("board", board)));
}

TEST(BentSun, KeepsThePostsShadowWhole) {
    expectAlike(picturesOf(calmWater("post", post)));
}

TEST(BentSun, FollowsATiltedSurface) {
    Scene scene = calmWater("tilted", board);
    scene.water->tiltDeg = 14;
    scene.water->tiltTowardsDeg = 250;
    expectAlike(picturesOf(scene));
}

TEST(BentSun, IsTheSameToAnEyeUnderWater) {
    Scene scene = calmWater("below", board);
    scene.water->underwater.emplace();
    scene.cameras[0].positionM = {0, -0.3, 0.3};
    scene.cameras[0].targetM = {-0.5, -2, 0};
    scene.cameras[0].verticalFovDeg = 90;
    expectAlike(picturesOf(scene));
}

TEST(BentSun, ReachesFarWhereItIsLow) {
    Scene scene = calmWater("low", {{{4, 0.6, -1.5}, {8, 0.7, 1.5}}});
    scene.sun.elevationDeg = 7;
    expectAlike(picturesOf(scene));
}

/// Such an eye has the place where the light comes in far behind it.
TEST(BentSun, ShadesWhatADeepEyeLooksDownOn) {
    Scene scene = calmWater("deep", {{{7.7, 0.6, 0.9}, {10.7, 0.7, 6.9}}}, 12);
    scene.water->underwater.emplace();
    scene.cameras[0].positionM = {0, -10.5, 0.1};
    scene.cameras[0].targetM = {0, -12, 0};
    expectAlike(picturesOf(scene));
}

/// Above water such a sun lights a wall seven times as much as the level.
TEST(BentSun, FallsOnWallsAsSteeplyAsInWater) {
    Scene scene = calmWater("wall", {{{-3, -2, -4}, {-2, 1, 4}}});
    scene.sun.elevationDeg = 8;
    scene.water->underwater.emplace();
    scene.cameras[0].positionM = {0.5, -1, 0};
    scene.cameras[0].targetM = {-2, -1, 0};
    scene.cameras[0].verticalFovDeg = 20;
    EXPECT_NEAR(brightnessDrawn(picturesOf(scene)), 1, 0.3); // the sky falls on it as in air
}

/// Whose eye lies as far above the water as the other below it.
TEST(BentSun, IsBentInAMirroredPicture) {
    Scene scene = calmWater("mirrored", board);
    scene.water->underwater.emplace();
    scene.water->reflection.emplace().technique = seaglass::ReflectionTechnique::planar;
    scene.cameras[0].positionM = {4, -0.6, 0};
    scene.cameras[0].targetM = {1.5, 0, 0};
    scene.cameras[0].verticalFovDeg = 20;
    expectAlike(picturesOf(scene));
}

/// Nor where its extent ends. The bed beside the water lies as deep.
TEST(BentSun, IsStraightBesideTheWater) {
    Scene scene = calmWater("beside", {{{0.5, 0.6, -5}, {2.5, 0.7, 5}}});
    ExtentDesc& extent = scene.water->extent.emplace();
    extent.centerM = {0, 5};
    extent.sizeM = {30, 10};
    scene.cameras[0].positionM[0] = scene.cameras[0].targetM[0] = -5;
    const Pictures pictures = picturesOf(scene);
    expectAlike(pictures, {25, height / 2 - 10});
    expectAlike(pictures, {height / 2 + 10, height - 25});
}

using Columns = std::vector<double>;

void addColumns(const Picture& picture, Columns& sums) {
    for (size_t i = 0; i < size_t{width} * height; ++i) sums[i % width] += brightness(picture, i);
}

/// From where a shadow with an upright edge takes a quarter of the light to where it takes three, left of
/// what casts it [pixels]. Of the light without that, which waves make uneven.
size_t edgeWidth(const Columns& shaded, const Columns& lit) {
    const auto darkest = std::ranges::min_element(shaded) - shaded.begin();
    size_t count = 0;
    for (size_t i = 0; i < static_cast<size_t>(darkest); ++i) {
        count += shaded[i] > 0.25 * lit[i] && shaded[i] < 0.75 * lit[i] ? 1 : 0;
    }
    return count;
}

/// Eight metres deep, from two above its bed.
Scene wavyWater(std::vector<tests::Box> things) {
    Scene scene = calmWater("high", std::move(things), 8);
    WavesDesc& waves = scene.water->waves.emplace();
    waves.windMps = 5;
    waves.fetchM = 2000;
    waves.largestPatchM = 40;
    scene.water->underwater.emplace();
    scene.cameras[0].positionM = {0, -6, 0.01};
    scene.cameras[0].targetM = {0, -8, 0};
    return scene;
}

struct Edges {
    Columns drawn = Columns(width, 0.0), traced = Columns(width, 0.0);
};

/// Traced at several times, since at one all rays stray alike by the waves that are longer than the picture
/// is wide.
Edges edgesIn(Scene scene) {
    Edges edges;
    addColumns(drawnOf(scene), edges.drawn);
    for (int time = 0; time < 8; ++time) {
        scene.timeS = 3.7 * time;
        addColumns(tracedOf(scene, 2), edges.traced);
    }
    return edges;
}

/// Waves send the sun's rays astray, the farther the more water lies below what casts.
TEST(BentSun, WavesSoftenTheShadowOfWhatStandsHigh) {
    const Edges bare = edgesIn(wavyWater({}));
    for (const double above : {0.5, 3.0, 7.0}) {
        const double shift = 0.8 * above; // of the shadow, so that its edge is amid the picture
        const Edges edges = edgesIn(wavyWater({{{shift, above - 8, -20}, {shift + 8, above - 7.9, 20}}}));
        const size_t drawn = edgeWidth(edges.drawn, bare.drawn),
                     traced = edgeWidth(edges.traced, bare.traced);
        std::printf("%.1f m above the bed: the edge is %zu pixels wide, traced %zu\n", above, drawn, traced);
        const double share = static_cast<double>(drawn) / static_cast<double>(traced);
        EXPECT_GT(share, 0.6);
        EXPECT_LT(share, 1.7);
    }
}

} // namespace
