// A polished floor must look in the reference as the host renders it, wherever the screen can tell.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "host/timing/pass_samples.h"
#include "scene/fields.h"
#include "tests/program/demo_scenes.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 320, height = 180;

struct Both {
    Picture rendered;
    reference::Pictures traced;
};

std::optional<Both> drawBoth(const Scene& scene, const CameraDesc& camera, Aov aov, Error& error) {
    HostDesc desc;
    desc.validation = true;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    if (!host || !host->load(scene, error)) return std::nullopt;
    std::optional<Picture> rendered = host->render({width, height, camera, 0, aov}, error);
    EXPECT_EQ(host->validationMessages(), 0u);
    if (!rendered) return std::nullopt;
    return Both{std::move(*rendered), tests::traced(scene, {width, height, camera}, true)};
}

/// Share of the pixels of these classes that are off by more than a tenth.
double differing(const Both& both, std::initializer_list<reference::TruthClass> classes, size_t least) {
    size_t count = 0, off = 0;
    for (size_t i = 0; i < both.rendered.rgba.size(); i += 4) {
        const auto kind = static_cast<reference::TruthClass>(static_cast<int>(both.traced.truth.rgba[i]));
        if (std::find(classes.begin(), classes.end(), kind) == classes.end()) continue;
        ++count;
        bool wide = false;
        for (size_t c = i; c < i + 3; ++c) {
            const auto a = static_cast<double>(both.rendered.rgba[c]),
                       b = static_cast<double>(both.traced.color.rgba[c]);
            wide |= std::abs(a - b) > 0.1 * std::max(a, b) + 0.01;
        }
        off += wide ? 1 : 0;
    }
    EXPECT_GT(count, least);
    return static_cast<double>(off) / static_cast<double>(count);
}

std::optional<Scene> court(Error& error) {
    return loadScene(tests::demoScene("floor"), {}, error);
}

TEST(FloorOfTheHost, LooksAsTraced) {
    Error error;
    const std::optional<Scene> scene = court(error);
    ASSERT_TRUE(scene) << error.text;
    const std::optional<Both> both = drawBoth(*scene, scene->cameras.front(), Aov::color, error);
    ASSERT_TRUE(both) << error.text;
    // Edges of shadows and of what is mirrored.
    EXPECT_LT(differing(*both, {reference::TruthClass::recoverable}, 5000), 0.3);
    EXPECT_LT(differing(*both, {reference::TruthClass::sky}, 3000), 0.05);
}

TEST(FloorOfTheHost, LooksAsTracedWhenDrawnTwice) {
    Error error;
    std::optional<Scene> scene = court(error);
    ASSERT_TRUE(scene) << error.text;
    scene->floor->reflection->technique = seaglass::ReflectionTechnique::planar;
    const std::optional<Both> both = drawBoth(*scene, scene->cameras.front(), Aov::color, error);
    ASSERT_TRUE(both) << error.text;
    EXPECT_LT(differing(*both, {reference::TruthClass::recoverable}, 5000), 0.15);
    EXPECT_LT(differing(*both, {reference::TruthClass::sky}, 3000), 0.05);
}

TEST(FloorOfTheHost, IsLookedUpInSmallerReflectionsWhereItIs) {
    Error error;
    std::optional<Scene> scene = court(error);
    ASSERT_TRUE(scene) << error.text;
    scene->floor->reflection->downscale = 2;
    const std::optional<Both> both = drawBoth(*scene, scene->cameras.front(), Aov::color, error);
    ASSERT_TRUE(both) << error.text;
    EXPECT_LT(differing(*both, {reference::TruthClass::recoverable}, 5000), 0.5);
    EXPECT_LT(differing(*both, {reference::TruthClass::sky}, 3000), 0.1);
}

/// A mirror on the wall shows the far sides of things, which the screen has never seen: where they are
/// mirrored can be right, their light cannot.
TEST(FloorOfTheHost, AMirrorOnAWallShowsThingsWhereTheyAreTraced) {
    Error error;
    std::optional<Scene> scene = court(error);
    ASSERT_TRUE(scene) << error.text;
    scene->floor->pointM = {-9.5, 2, 0};
    scene->floor->normal = {1, 0, 0};
    scene->floor->widthM = 12;
    scene->floor->lengthM = 4;
    CameraDesc camera = scene->cameras.front();
    camera.positionM = {6, 2, 9};
    camera.targetM = {-8, 1.8, -2};
    const std::optional<Both> both = drawBoth(*scene, camera, Aov::reflectionClass, error);
    ASSERT_TRUE(both) << error.text;
    size_t hits = 0, right = 0, recoverable = 0, found = 0;
    for (size_t i = 0; i < both->rendered.rgba.size(); i += 4) {
        const auto kind = static_cast<reference::TruthClass>(static_cast<int>(both->traced.truth.rgba[i]));
        const bool hit = both->rendered.rgba[i + 1] > 0.5f, told = kind == reference::TruthClass::recoverable;
        const bool solid = kind != reference::TruthClass::none && kind != reference::TruthClass::sky;
        hits += hit ? 1 : 0;
        right += hit && solid ? 1 : 0;
        recoverable += told ? 1 : 0;
        found += told && hit ? 1 : 0;
    }
    EXPECT_GT(hits, 500u);
    EXPECT_GT(static_cast<double>(right), 0.97 * static_cast<double>(hits));
    EXPECT_GT(static_cast<double>(found), 0.6 * static_cast<double>(recoverable));
}

/// How far, in pixels, from where they are traced the hits were taken from: median and 95th percentile.
struct Distances {
    double median = 0, p95 = 0;
};
Distances distancesOf(const Both& both, size_t least) {
    std::vector<double> off;
    for (size_t i = 0; i < both.rendered.rgba.size(); i += 4) {
        const float *const found = &both.rendered.rgba[i], *const truth = &both.traced.truth.rgba[i];
        const auto kind = static_cast<reference::TruthClass>(static_cast<int>(truth[0]));
        if (kind != reference::TruthClass::recoverable || found[3] != 2) continue;
        off.push_back(static_cast<double>(std::hypot(found[0] - truth[1], found[1] - truth[2])));
    }
    EXPECT_GT(off.size(), least);
    return {quantile(off, 0.5), quantile(off, 0.95)};
}

TEST(FloorOfTheHost, SaysWhereItsReflectionIsTakenFrom) {
    Error error;
    for (const std::string technique : {"sspr", "planar"})
        for (const uint32_t downscale : {1u, 2u}) {
            std::optional<Scene> scene = court(error);
            ASSERT_TRUE(scene) << error.text;
            scene->floor->reflection->technique = demos::techniqueNamed(technique);
            scene->floor->reflection->downscale = downscale;
            const std::optional<Both> both =
                drawBoth(*scene, scene->cameras[1], Aov::reflectionSource, error);
            ASSERT_TRUE(both) << error.text;
            const Distances off = distancesOf(*both, 5000);
            EXPECT_LT(off.median, downscale == 1 ? 0.1 : 0.2) << technique << downscale;
            EXPECT_LT(off.p95, downscale == 1 ? 1 : 3) << technique << downscale;
        }
}

TEST(FloorOfTheHost, SaysSoOfAMirrorThatLeans) {
    Error error;
    std::optional<Scene> scene = court(error);
    ASSERT_TRUE(scene) << error.text;
    scene->floor->normal = {0.1, 1, 0.05};
    scene->floor->pointM = {0, 0.6, 0};
    scene->floor->reflection->technique = seaglass::ReflectionTechnique::planar;
    const std::optional<Both> both = drawBoth(*scene, scene->cameras.front(), Aov::reflectionSource, error);
    ASSERT_TRUE(both) << error.text;
    const Distances off = distancesOf(*both, 2000);
    EXPECT_LT(off.median, 0.1);
    EXPECT_LT(off.p95, 1);
}

/// A rough floor towards the horizon, where its facets hide each other.
TEST(FloorOfTheHost, IsAsBrightAsTracedAtGrazingAngles) {
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    const std::string sky = testing::TempDir() + "even_sky.hdr";
    tests::writeAll(sky, tests::evenSky());
    for (const double roughness : {0.0, 0.1, 0.3, 0.6, 1.0}) {
        Scene scene;
        scene.sky.file = sky;
        scene.sun.irradiance = {0, 0, 0};
        FloorDesc& floor = scene.floor.emplace();
        floor.widthM = floor.lengthM = 1e4;
        floor.color = {0, 0, 0};
        floor.roughness = roughness;
        CameraDesc camera;
        camera.positionM = {0, 1, 0};
        camera.targetM = {0, -1, -20};
        camera.verticalFovDeg = 5;
        scene.cameras = {camera};
        const Picture rendered = tests::rendered(*host, scene, width / 4, height / 4),
                      traced = tests::traced(scene, {width / 4, height / 4, camera, 0, 64}).color;
        double drawnSum = 0, tracedSum = 0;
        for (size_t i = 1; i < traced.rgba.size(); i += 4) {
            drawnSum += double{rendered.rgba[i]};
            tracedSum += double{traced.rgba[i]};
        }
        std::printf("roughness %g: %.3f of what is traced\n", roughness, drawnSum / tracedSum);
        EXPECT_NEAR(drawnSum / tracedSum, 1, 0.2);
    }
}

} // namespace
