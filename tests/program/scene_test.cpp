#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "demos/tools/scene/camera_choice.h"
#include "demos/tools/scene/fields.h"
#include "demos/tools/scene/offset.h"
#include "demos/tools/scene/scene.h"
#include "demos/tools/scene/water_plane.h"
#include "tests/program/demo_scenes.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using demos::Error;
using demos::Field;
using demos::Scene;

/// The sample, with what is said of the water's colour from line 31 on.
std::string withColour(const std::string& lines) {
    std::string text = tests::sampleScene();
    return text.insert(text.find("\n[water.reflection]"), lines + "\n");
}

/// A folder with the sample scene, to load with changes.
class SceneFile : public testing::Test {
  protected:
    SceneFile() { tests::writeSample(folder_.path()); }

    std::optional<Scene> load(const std::vector<std::string>& overrides = {}) {
        error_ = {};
        return demos::loadScene(file(), overrides, error_);
    }
    std::optional<Scene> loadText(const std::string& text, const std::vector<std::string>& overrides = {}) {
        tests::writeAll(file(), text);
        return load(overrides);
    }
    /// The error, without the folder; empty when it loads.
    std::string problem(const std::string& text, const std::vector<std::string>& overrides = {}) {
        return loadText(text, overrides) ? "" : shortened();
    }
    std::string problemOf(const std::string& assignment) { return load({assignment}) ? "" : shortened(); }

    std::string shortened() const {
        std::string text = error_.text;
        const std::string prefix = folder_.path().string() + "/";
        for (size_t at = text.find(prefix); at != text.npos; at = text.find(prefix))
            text.erase(at, prefix.size());
        return text;
    }
    struct Problem {
        std::string what, with, says;
    };
    /// What is said of the sample with one thing in the place of another.
    void expectProblem(const std::string& what, const std::string& with, const std::string& says) {
        EXPECT_EQ(problem(replaced(what, with)), says);
    }
    void expectProblems(const std::vector<Problem>& problems) {
        for (const auto& [what, with, says] : problems) expectProblem(what, with, says);
    }
    fs::path file() const { return folder_.path() / "scene.toml"; }

    static std::string replaced(const std::string& what, const std::string& with) {
        std::string text = tests::sampleScene();
        const size_t at = text.find(what);
        EXPECT_NE(at, text.npos) << what;
        return text.replace(at, what.size(), with);
    }

    tests::TemporaryFolder folder_;
    Error error_;
};

TEST_F(SceneFile, SampleLoads) {
    const std::optional<Scene> scene = load();
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_EQ(scene->title, "Sample");
    EXPECT_EQ(scene->timeS, 1.5);
    EXPECT_EQ(scene->exposureEv, 0.5);
    EXPECT_EQ(scene->sky.file, folder_.path() / "sky.hdr");
    EXPECT_EQ(scene->sun.irradiance, (demos::Vec3{3, 2, 1}));
    ASSERT_EQ(scene->meshes.size(), 1u);
    EXPECT_EQ(scene->meshes[0].positionM, (demos::Vec3{0, 0.5, -5}));
    ASSERT_TRUE(scene->water && scene->water->waves && scene->water->foam);
    EXPECT_EQ(scene->water->waves->windMps, 6);
    EXPECT_EQ(scene->water->waves->samples, 128u);
    ASSERT_EQ(scene->cameras.size(), 2u);
    EXPECT_EQ(scene->cameras[1].name, "low");
}

TEST_F(SceneFile, FilesAreKeptWithTheirPlaces) {
    const std::optional<Scene> scene = load();
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->sky.where, file().string() + ":6: sky.file");
    EXPECT_EQ(scene->meshes[0].where, file().string() + ":14: mesh.0.file");
}

TEST_F(SceneFile, WavesAreAWindSeaAndSwells) {
    tests::writeAll(folder_.path() / "buoy.csv", "0.1,4\n0.2,1\n");
    const std::string swells =
        "[[water.waves.swells]]\nheight_m = 1.5\n[[water.waves.swells]]\nperiod_s = 9\n";
    const std::optional<Scene> scene =
        loadText(tests::sampleScene() + swells,
                 {"water.waves.spectrum=table", "water.waves.spectrum_table=buoy.csv",
                  "water.waves.depth_m=12", "water.waves.spreading=donelan-banner", "water.waves.beaufort=7",
                  "water.waves.cap_fetch=false", "water.waves.swells.1.towards_deg=30"});
    ASSERT_TRUE(scene) << error_.text;
    const demos::WavesDesc& waves = *scene->water->waves;
    EXPECT_EQ(waves.spectrumTable, folder_.path() / "buoy.csv");
    EXPECT_EQ(waves.depthM, 12);
    EXPECT_EQ(waves.spreading, "donelan-banner");
    EXPECT_EQ(waves.beaufort, 7u);
    EXPECT_FALSE(waves.capFetch);
    ASSERT_EQ(waves.swells.size(), 2u);
    EXPECT_EQ(waves.swells[0].heightM, 1.5);
    EXPECT_EQ(waves.swells[1].towardsDeg, 30);

    EXPECT_EQ(problemOf("water.waves.beaufort=13"),
              "--set water.waves.beaufort=13: water.waves.beaufort is 13, expected a whole number, 0 to 12");
    EXPECT_EQ(
        problemOf("water.waves.swells.0.height_m=31"),
        "--set water.waves.swells.0.height_m=31: water.waves.swells.0.height_m is 31, expected 0 to 30 m");
    EXPECT_NE(problemOf("water.waves.spectrum=table").find("expected water.waves.spectrum_table too"),
              std::string::npos);
    std::string many = tests::sampleScene();
    for (int i = 0; i < 5; ++i) many += "[[water.waves.swells]]\nheight_m = 1\n";
    EXPECT_NE(problem(many).find("water.waves.swells are 5, expected at most 4"), std::string::npos);
}

TEST_F(SceneFile, WaterHasATintOrCoefficients) {
    const std::string tinted = withColour("tint = [0.01, 0.2, 0.15]\nvisibility_m = 6");
    const std::optional<Scene> scene = loadText(tinted);
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_EQ(scene->water->refraction->tint, (demos::Vec3{0.01, 0.2, 0.15}));
    EXPECT_EQ(scene->water->refraction->visibilityM, 6);

    EXPECT_EQ(problem(withColour("tint = [0.01, 0.2, 0.15]")),
              "scene.toml:31: water.refraction.tint is set, expected water.refraction.visibility_m too");
    EXPECT_EQ(problem(withColour("visibility_m = 6")),
              "scene.toml:31: water.refraction.visibility_m is set, expected water.refraction.tint too");
    const std::string both = "tint = [0.1, 0.1, 0.1]\nvisibility_m = 6\n";
    for (const std::string rival :
         {"type = 'pool'", "absorption_per_m = [1, 1, 1]", "backscatter_per_m = [1, 1, 1]"})
        EXPECT_EQ(problem(withColour(both + rival)),
                  "scene.toml:33: water.refraction." + rival.substr(0, rival.find(' ')) +
                      " is set, expected no water.refraction.tint then: a water has one colour");
    EXPECT_EQ(problem(withColour("tint = [0, 0.25, 0.125]\nvisibility_m = 6")),
              "scene.toml:31: water.refraction.tint is [ 0, 0.25, 0.125 ], expected three numbers, each more "
              "than 0, up to 0.33");
    EXPECT_EQ(problem(withColour("tint = [0.1, 0.2, 0.1]\nvisibility_m = 2000")),
              "scene.toml:32: water.refraction.visibility_m is 2000, expected 0.05 to 1000 m");
}

TEST_F(SceneFile, ATintSetByHandTakesThePlaceOfTheFilesColour) {
    const std::vector<std::string> tint = {"water.refraction.tint=[0.01, 0.2, 0.15]",
                                           "water.refraction.visibility_m=6"};
    const std::string named = withColour("type = 'pool'\nabsorption_per_m = [1, 1, 1]");
    const std::optional<Scene> scene = loadText(named, tint);
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_EQ(scene->water->refraction->type, "");
    EXPECT_EQ(scene->water->refraction->visibilityM, 6);

    const std::string tinted = withColour("tint = [0.1, 0.1, 0.1]\nvisibility_m = 6");
    const std::optional<Scene> turbid = loadText(tinted, {"water.refraction.type=turbid"});
    ASSERT_TRUE(turbid) << error_.text;
    EXPECT_EQ(turbid->water->refraction->type, "turbid");
    EXPECT_EQ(turbid->water->refraction->visibilityM, 0);

    EXPECT_EQ(problem(named, {"water.refraction.type=turbid", tint[0], tint[1]}),
              "--set water.refraction.type=turbid: water.refraction.type is set, expected no "
              "water.refraction.tint then: a water has one colour");
}

TEST_F(SceneFile, AbsentTablesAreAbsentFeatures) {
    const std::string least =
        "[sky]\nfile = 'sky.hdr'\n[[camera]]\nname = 'a'\nposition_m = [0, 2, 0]\ntarget_m = [0, 2, -1]\n";
    const std::optional<Scene> dry = loadText(least);
    ASSERT_TRUE(dry) << error_.text;
    EXPECT_FALSE(dry->water);
    const std::optional<Scene> flat = loadText(least + "[water]\n");
    ASSERT_TRUE(flat) << error_.text;
    ASSERT_TRUE(flat->water);
    EXPECT_FALSE(flat->water->waves || flat->water->foam || flat->water->refraction ||
                 flat->water->reflection || flat->water->underwater || flat->water->caustics);
    const std::optional<Scene> within = loadText(least + "[water.underwater]\nmeniscus_m = 0.01\n");
    ASSERT_TRUE(within && within->water && within->water->underwater) << error_.text;
    EXPECT_EQ(within->water->underwater->meniscus, 0.01f);
    const std::optional<Scene> lit = loadText(least + "[water.caustics]\nstrength = 0.5\n");
    ASSERT_TRUE(lit && lit->water && lit->water->caustics) << error_.text;
    EXPECT_EQ(lit->water->caustics->strength, 0.5);
    const std::optional<Scene> plain = loadText(least + "[water.waves]\n");
    ASSERT_TRUE(plain) << error_.text;
    ASSERT_TRUE(plain->water && plain->water->waves);
    EXPECT_EQ(plain->water->waves->windMps, demos::WavesDesc{}.windMps);
}

TEST_F(SceneFile, ARelativeSceneFindsItsFiles) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_.path());
    const std::optional<Scene> scene = demos::loadScene("scene.toml", {}, error_);
    fs::current_path(before);
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_TRUE(scene->sky.file.is_absolute());
    EXPECT_TRUE(scene->file.is_absolute());
}

// ---- What is refused, and how it is said

TEST_F(SceneFile, OutOfRangeNamesFileLineFieldAndRange) {
    expectProblems(
        {{"wind_m_s = 6", "wind_m_s = -3",
          "scene.toml:22: water.waves.wind_m_s is -3, expected 0 to 100 m/s"},
         {"samples = 128", "samples = 48",
          "scene.toml:23: water.waves.samples is 48, expected a power of two, 16 to 2048"},
         {"cells_per_level = 128", "cells_per_level = 40",
          "scene.toml:19: water.cells_per_level is 40, expected a whole number, 128 to 1024"},
         {"technique = \"sspr\"", "technique = \"srr\"",
          "scene.toml:33: water.reflection.technique is 'srr', expected sky, sspr, ssr, hybrid or planar"}});
}

TEST_F(SceneFile, WrongTypesAreRefused) {
    expectProblems(
        {{"wind_m_s = 6", "wind_m_s = '6'",
          "scene.toml:22: water.waves.wind_m_s is '6', expected 0 to 100 m/s"},
         {"samples = 128", "samples = 128.0",
          "scene.toml:23: water.waves.samples is 128.0, expected a power of two, 16 to 2048"},
         {"irradiance = [3, 2, 1]", "irradiance = [3, 2]",
          "scene.toml:11: sun.irradiance is [ 3, 2 ], expected three numbers, each 0 to 1e+06"},
         {"[sun]", "[sun]\nfrom_sky = 1", "scene.toml:9: sun.from_sky is 1, expected true or false"},
         {"title = \"Sample\"", "title = 3", "scene.toml:1: title is 3, expected a text in quotes"}});
    EXPECT_EQ(problem("sky = 3\n" + replaced("[sky]\nfile = \"sky.hdr\"", "")),
              "scene.toml:1: sky is 3, expected a table: [sky]");
    expectProblem("[[mesh]]", "[mesh]",
                  "scene.toml:13: mesh is a table, expected an array of tables: [[mesh]]");
}

TEST_F(SceneFile, UnknownKeysNameTheNearest) {
    expectProblems(
        {{"wind_m_s = 6", "wind_ms = 6",
          "scene.toml:22: water.waves.wind_ms is not a known key, the nearest is water.waves.wind_m_s"},
         {"[water.waves]", "[waves]", "scene.toml:21: waves is not a known key, the nearest is water.waves"},
         {"position_m = [0, 0.5, -5]", "postion_m = [0, 0.5, -5]",
          "scene.toml:15: mesh.0.postion_m is not a known key, the nearest is mesh.position_m"}});
}

TEST_F(SceneFile, FormerKeysAreReadAsWhatTheyAreCalledNow) {
    EXPECT_TRUE(load()->notes.empty());
    const std::string room = "[[water.dry_rooms]]\npoints_m = [[0, 0], [1, 0], [0, 1]]\nbottom_m = -0.5\n";
    const std::optional<Scene> scene =
        loadText(replaced("technique = \"sspr\"", "technique = \"sspr\"\nroof_looks = 5") + room,
                 {"water.slope_looks=4", "water.dry_rooms.0.bottom_m=-2"});
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_EQ(scene->water->reflection->overhangSamples, 5u);
    EXPECT_EQ(scene->water->shading.slopeSamples, 4u);
    ASSERT_EQ(scene->water->exclusionVolumes.size(), 1u);
    EXPECT_EQ(scene->water->exclusionVolumes[0].bottomM, -2);
    ASSERT_EQ(scene->notes.size(), 4u);
    EXPECT_TRUE(scene->notes[0].ends_with("scene.toml:45: water.dry_rooms is called exclusion_volumes now"))
        << scene->notes[0];
    EXPECT_TRUE(scene->notes[1].ends_with("scene.toml:34: water.reflection.roof_looks is called "
                                          "overhang_samples now"))
        << scene->notes[1];
    EXPECT_EQ(scene->notes[2], "--set water.slope_looks=4: water.slope_looks is called slope_samples now");
    EXPECT_EQ(scene->notes[3],
              "--set water.dry_rooms.0.bottom_m=-2: water.dry_rooms is called exclusion_volumes now");
}

TEST_F(SceneFile, KeysThatWentAreNamedAndLeftOut) {
    const auto scene = loadText(replaced("cells_per_level = 128", "cells_per_level = 128\ndeferred = 3"),
                                {"water.deferred=true"});
    ASSERT_TRUE(scene) << error_.text;
    ASSERT_EQ(scene->notes.size(), 2u);
    EXPECT_TRUE(scene->notes[0].ends_with(
        "scene.toml:20: water.deferred is no more: every surface is found first and shaded once"))
        << scene->notes[0];
    EXPECT_EQ(scene->notes[1], "--set water.deferred=true: water.deferred is no more: every surface is found "
                               "first and shaded once");
    EXPECT_NE(
        problem(replaced("distortion = 1", "deferred = true")).find("refraction.deferred is not a known"),
        std::string::npos);
}

TEST_F(SceneFile, FormerKeysAreOnlyThoseOfTheirSections) {
    const auto loaded = loadText(replaced("cells_per_level = 128", "relief = true\nslope_looks = 2"));
    ASSERT_TRUE(loaded) << error_.text;
    EXPECT_TRUE(loaded->water->shading.parallax);
    EXPECT_NE(problem(replaced("distortion = 1", "relief = true"))
                  .find("water.refraction.relief is not a known key"),
              std::string::npos);
    EXPECT_EQ(problem(replaced("cells_per_level = 128", "slope_looks = 2\nslope_samples = 2")),
              "scene.toml:19: water.slope_looks is not a known key, the nearest is water.slope_samples");
}

TEST_F(SceneFile, MissingFieldsAreNamed) {
    expectProblems(
        {{"file = \"tetra.gltf\"\n", "", "scene.toml:13: mesh.0.file is missing, expected a glTF file"},
         {"target_m = [0, 1, -5]", "",
          "scene.toml:35: camera.0.target_m is missing, expected three numbers, each -1e+07 to 1e+07 m"},
         {"[sky]\nfile = \"sky.hdr\"", "", "scene.toml: sky is missing, expected [sky]"}});
    EXPECT_EQ(problem("[sky]\nfile = 'sky.hdr'"), "scene.toml: camera is missing, expected [[camera]]");
    EXPECT_EQ(problem("camera = []\n[sky]\nfile = 'sky.hdr'"),
              "scene.toml:1: camera is [], expected at least one: [[camera]]");
}

TEST_F(SceneFile, AClearSkyNeedsNoFile) {
    const std::string rest = "[[camera]]\nname = 'level'\nposition_m = [0, 2, 0]\ntarget_m = [0, 1, -9]\n";
    const std::optional<Scene> scene = loadText("[sky]\nclear = true\n" + rest);
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_TRUE(scene->sky.file.empty());
    EXPECT_EQ(problem("[sky]\nhaze = 3\n" + rest),
              "scene.toml:1: sky.file is missing, expected a lat-long HDR or EXR file, or sky.clear = true");
}

TEST_F(SceneFile, FilesThatAreNotThereAreNamed) {
    expectProblems(
        {{"sky.hdr", "nope.hdr",
          "scene.toml:6: sky.file is 'nope.hdr', expected a lat-long HDR or EXR file; nope.hdr: no such "
          "file"},
         {"tetra.gltf", "out", "scene.toml:14: mesh.0.file is 'out', expected a glTF file; out: is a folder"},
         {"\"sky.hdr\"", "\"\"", "scene.toml:6: sky.file is '', expected a lat-long HDR or EXR file"}});
}

TEST_F(SceneFile, CamerasMustDifferAndLookSomewhere) {
    expectProblems(
        {{"name = \"low\"", "name = \"level\"",
          "scene.toml:41: camera.1.name is 'level', expected a name that camera.0 does not have"},
         {"target_m = [0, 1, -5]", "target_m = [0, 2, 4]",
          "scene.toml:38: camera.0.target_m is its position_m, expected a point away from the eye"},
         {"name = \"low\"", "name = \"low.er\"",
          "scene.toml:41: camera.1.name is 'low.er', expected a name of letters, digits, _ and -"}});
}

TEST_F(SceneFile, RandomCamerasAreTheSameEveryTimeAndStayOnTheirSide) {
    Error error;
    for (const std::string name : {"harbour", "pool", "ocean", "underwater", "floor"}) {
        const auto scene = demos::loadScene(tests::demoScene(name.c_str()), {}, error);
        ASSERT_TRUE(scene) << error.text;
        const auto height = [&](const demos::CameraDesc& camera) {
            return scene->water ? demos::alongPlane(demos::waterPlane(*scene->water), camera.positionM)[1]
                                : camera.positionM[1] - scene->floor->pointM[1];
        };
        double lowest = 0, highest = 0;
        for (const demos::CameraDesc& camera : scene->cameras) {
            lowest = std::min(lowest, height(camera));
            highest = std::max(highest, height(camera));
        }
        std::vector<demos::CameraDesc> seen;
        for (uint32_t i = 0; i < 200; ++i) {
            const std::string asked = "random:" + std::to_string(i);
            const auto camera = demos::chooseCamera(*scene, asked, error);
            ASSERT_TRUE(camera) << error.text;
            EXPECT_EQ(camera->name, asked);
            EXPECT_EQ(*camera, *demos::chooseCamera(*scene, asked, error));
            EXPECT_EQ(std::count(seen.begin(), seen.end(), *camera), 0) << asked;
            EXPECT_GE(height(*camera), lowest - 1e-9) << name << ' ' << asked;
            EXPECT_LE(height(*camera), 3.2 * highest) << name << ' ' << asked;
            seen.push_back(*camera);
        }
        EXPECT_EQ(lowest < 0,
                  std::any_of(
                      seen.begin(), seen.end(), [&](const auto& camera) { return height(camera) < 0; }))
            << name;
    }
    const auto sample = load();
    ASSERT_TRUE(sample);
    for (const char* const bad : {"random:", "random:-1", "random:1x", "random:4294967296"}) {
        EXPECT_FALSE(demos::chooseCamera(*sample, bad, error)) << bad;
        EXPECT_EQ(error.text, std::string("--camera is '") + bad +
                                  "', expected a number after 'random:', 0 to 4294967295");
    }
}

TEST_F(SceneFile, CamerasShowAnAngleOrAHeight) {
    const std::string parallel = replaced("name = \"low\"", "name = \"low\"\northographic_height_m = 12.5");
    const std::optional<Scene> scene = loadText(parallel);
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_EQ(scene->cameras[0].orthographicHeightM, 0);
    EXPECT_EQ(scene->cameras[1].orthographicHeightM, 12.5);
    const std::string both =
        replaced("name = \"low\"", "name = \"low\"\northographic_height_m = 12.5\nvertical_fov_deg = 40");
    EXPECT_EQ(problem(both), "scene.toml:42: camera.1.orthographic_height_m is set, expected no "
                             "vertical_fov_deg then: a camera shows an angle or a height");
    expectProblem("name = \"low\"", "name = \"low\"\northographic_height_m = 0",
                  "scene.toml:42: camera.1.orthographic_height_m is 0, expected 0.01 to 10000 m");
    EXPECT_EQ(problem(tests::sampleFloorScene(), {"camera.low.orthographic_height_m=5"}),
              "--set camera.low.orthographic_height_m=5: camera.1.orthographic_height_m is set, expected no "
              "[floor], which is seen from an eye");

    // What is set by hand takes the other's place.
    const std::optional<Scene> byAngle = loadText(parallel, {"camera.low.vertical_fov_deg=40"});
    ASSERT_TRUE(byAngle) << error_.text;
    EXPECT_EQ(byAngle->cameras[1].orthographicHeightM, 0);
    const std::string angle = replaced("name = \"low\"", "name = \"low\"\nvertical_fov_deg = 40");
    const std::optional<Scene> byHeight = loadText(angle, {"camera.low.orthographic_height_m=9"});
    ASSERT_TRUE(byHeight) << error_.text;
    EXPECT_EQ(byHeight->cameras[1].orthographicHeightM, 9);
}

TEST_F(SceneFile, AFloorTakesTheWatersPlace) {
    tests::writeAll(folder_.path() / "tiles.png", "not read here");
    std::optional<Scene> scene =
        loadText(tests::sampleFloorScene(), {"floor.texture=tiles.png", "camera.low.offset_m=[100, 20, 3]"});
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_FALSE(scene->water);
    ASSERT_TRUE(scene->floor);
    EXPECT_EQ(scene->floor->widthM, 10);
    EXPECT_EQ(scene->floor->roughness, 0.25);
    EXPECT_EQ(scene->floor->reflectance, demos::FloorDesc{}.reflectance);
    EXPECT_EQ(scene->floor->texture, folder_.path() / "tiles.png");
    const std::optional<demos::SurfaceDesc> surface = demos::surfaceOf(*scene);
    ASSERT_TRUE(surface && std::holds_alternative<demos::FloorDesc>(*surface));
    EXPECT_EQ(std::get<demos::FloorDesc>(*surface).widthM, 10);
    demos::CameraDesc camera = scene->cameras[1];
    demos::applyOffset(*scene, camera);
    EXPECT_EQ(scene->floor->pointM, (demos::Vec3{100, 20, 3}));
}

TEST_F(SceneFile, WhatMirrorsIsWaterIfThereIsSome) {
    const std::optional<Scene> wet = load();
    ASSERT_TRUE(wet) << error_.text;
    const std::optional<demos::SurfaceDesc> surface = demos::surfaceOf(*wet);
    EXPECT_TRUE(surface && std::holds_alternative<demos::WaterDesc>(*surface));
    EXPECT_FALSE(demos::surfaceOf(Scene{}));
}

TEST_F(SceneFile, AnOffsetMovesEverythingThatHasAPlace) {
    std::optional<Scene> scene = load({"camera.low.offset_m=[100, 20, 3]"});
    ASSERT_TRUE(scene) << error_.text;
    demos::CameraDesc camera = scene->cameras[1];
    demos::applyOffset(*scene, camera);
    EXPECT_EQ(scene->meshes[0].positionM, (demos::Vec3{100, 20.5, -2}));
    EXPECT_EQ(scene->water->levelM, 20);
    EXPECT_EQ(camera.positionM, (demos::Vec3{100, 21, 7}));
    EXPECT_EQ(camera.targetM, (demos::Vec3{100, 21, -2}));
    EXPECT_EQ(camera.offsetM, (demos::Vec3{0, 0, 0}));
    EXPECT_EQ(problemOf("camera.low.offset_m=[1e8, 0, 0]"),
              "--set camera.low.offset_m=[1e8, 0, 0]: camera.1.offset_m is [ 100000000.0, 0, 0 ], expected "
              "three numbers, each -1e+07 to 1e+07 m");
}

TEST_F(SceneFile, WaterMayEnd) {
    const std::optional<Scene> endless = load();
    ASSERT_TRUE(endless) << error_.text;
    EXPECT_FALSE(endless->water->extent);
    std::optional<Scene> pool = load({"water.extent.size_m=[25, 10]", "water.extent.yaw_deg=30"});
    ASSERT_TRUE(pool && pool->water->extent) << error_.text;
    EXPECT_EQ(pool->water->extent->sizeM, (demos::Vec2{25, 10}));
    demos::CameraDesc camera;
    camera.offsetM = {100, 20, 3};
    demos::applyOffset(*pool, camera);
    EXPECT_EQ(pool->water->extent->centerM, (demos::Vec2{100, 3}));
    const std::optional<Scene> lake =
        load({"water.extent.shape=polygon", "water.extent.points_m=[[0, 0], [5, 1], [2, 6]]"});
    ASSERT_TRUE(lake && lake->water->extent) << error_.text;
    EXPECT_EQ(lake->water->extent->pointsM, (std::vector<demos::Vec2>{{0, 0}, {5, 1}, {2, 6}}));

    EXPECT_NE(problemOf("water.extent.yaw_deg=30").find("rectangle, expected water.extent.size_m too"),
              std::string::npos);
    EXPECT_NE(problemOf("water.extent.shape=mesh").find("expected water.extent.file too"), std::string::npos);
    EXPECT_EQ(problemOf("water.extent.points_m=[[0, 1], [2]]"),
              "--set water.extent.points_m=[[0, 1], [2]]: water.extent.points_m is [ [ 0, 1 ], [ 2 ] ], "
              "expected pairs of numbers, [[x, z], ...], each -1e+07 to 1e+07 m");
    EXPECT_NE(problemOf("water.extent.size_m=[25]").find("expected two numbers, each 0.01 to 1e+06 m"),
              std::string::npos);
}

TEST_F(SceneFile, WaterMayBeTilted) {
    std::optional<Scene> slope = load(
        {"water.level_m=2", "water.tilt_deg=30", "water.tilt_towards_deg=90", "water.extent.size_m=[4, 9]"});
    ASSERT_TRUE(slope && slope->water->extent) << error_.text;
    const auto [x, y, z, d] = demos::waterPlane(*slope->water);
    EXPECT_NEAR(x, 0, 1e-12);
    EXPECT_NEAR(y, std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(z, 0.5, 1e-12) << "it falls towards +Z";
    EXPECT_NEAR(d, -2 * y, 1e-12);
    // Moved, a point is where it was in the water.
    const demos::Vec3 offset = {100, 20, 3}, point = {7, 5, -4};
    const demos::Vec3 before = demos::alongPlane({x, y, z, d}, point);
    demos::CameraDesc camera;
    camera.offsetM = offset;
    demos::applyOffset(*slope, camera);
    const demos::Vec3 after = demos::alongPlane(demos::waterPlane(*slope->water), {107, 25, -1});
    EXPECT_NEAR(after[0] - slope->water->extent->centerM[0], before[0], 1e-9);
    EXPECT_NEAR(after[1], before[1], 1e-9);
    EXPECT_NEAR(after[2] - slope->water->extent->centerM[1], before[2], 1e-9);
}

TEST_F(SceneFile, TheOpenSeaMayLieOnAPlanet) {
    const std::optional<Scene> sea = load({"water.planet_radius_m=6.371e6"});
    ASSERT_TRUE(sea) << error_.text;
    EXPECT_EQ(sea->water->planetRadiusM, 6.371e6);
    EXPECT_NE(problemOf("water.planet_radius_m=1000").find("expected 0 or 1e+06 to 1e+09 m"),
              std::string::npos);
    EXPECT_FALSE(load({"water.planet_radius_m=6.371e6", "water.extent.size_m=[4, 9]"}));
    EXPECT_NE(error_.text.find("water.planet_radius_m is set, expected no water.extent then"),
              std::string::npos)
        << error_.text;
}

TEST_F(SceneFile, FogIsReadAndBeginsBeforeItEnds) {
    const std::optional<Scene> none = load({});
    ASSERT_TRUE(none) << error_.text;
    EXPECT_FALSE(none->fog);
    const std::optional<Scene> foggy =
        load({"fog.density_per_m=0.02", "fog.shape=height", "fog.over_sky=false"});
    ASSERT_TRUE(foggy) << error_.text;
    ASSERT_TRUE(foggy->fog);
    EXPECT_EQ(foggy->fog->densityPerM, 0.02);
    EXPECT_EQ(foggy->fog->shape, "height");
    EXPECT_FALSE(foggy->fog->overSky);
    EXPECT_NE(
        problemOf("fog.shape=thick").find("expected linear, exponential, exponential-squared or height"),
        std::string::npos)
        << error_.text;
    EXPECT_FALSE(load({"fog.shape=linear", "fog.start_m=1000"}));
    EXPECT_NE(error_.text.find("fog.start_m leaves no way from fog.start_m to fog.end_m"), std::string::npos)
        << error_.text;
    EXPECT_TRUE(load({"fog.shape=height", "fog.start_m=1000"})) << error_.text << ": not read by it";
}

TEST_F(SceneFile, FoamNeedsWaves) {
    std::string text = tests::sampleScene();
    const size_t from = text.find("[water.waves]"), to = text.find("[water.foam]");
    text.erase(from, to - from);
    EXPECT_EQ(problem(text),
              "scene.toml:21: water.foam is set, expected [water.waves] too: foam comes from waves");
}

TEST_F(SceneFile, BrokenFilesAreRefused) {
    EXPECT_NE(problem("[sky\n").find("scene.toml:1: not valid TOML: "), std::string::npos) << error_.text;
    EXPECT_NE(problem("title = 'a'\ntitle = 'b'\n").find("scene.toml:2: not valid TOML: "), std::string::npos)
        << error_.text;
    EXPECT_NE(problem("a = " + std::string(5000, '[')).find("scene.toml:1: not valid TOML: "),
              std::string::npos);
    EXPECT_NE(problem("\xff\xfe\x00").find("not valid TOML"), std::string::npos);
    EXPECT_EQ(problem(std::string((1 << 20) + 1, '\n')),
              "scene.toml: has 1048577 bytes, expected a scene of at most 1 MB");
    std::string key = "a";
    for (int i = 0; i < 15; ++i) key += ".a";
    EXPECT_NE(problem(key + " = 1\n").find("a is not a known key"), std::string::npos);
    for (int i = 0; i < 300000; ++i) key += ".a";
    const std::string tooMany = "scene.toml: has a key of over 16 parts, expected a scene (TOML)";
    for (const std::string& text : {key + " = 1\n", "[" + key + "]\n", "a = {" + key + " = 1}\n",
                                    "a = {x = \"\"\" \" \"\"\", " + key + " = 1}\n"})
        EXPECT_EQ(problem(text), tooMany) << text.substr(0, 40);
    EXPECT_NE(problem("# ....................\na = '....................'\n").find("a is not"),
              std::string::npos);
    EXPECT_EQ(problemOf("title={" + key.substr(0, 100000) + "=1}").find("--set title="), 0u);
    std::string cameras = tests::sampleScene();
    for (int i = 0; i < 257; ++i) cameras += "[[camera]]\n";
    EXPECT_NE(problem(cameras).find(": camera has 259 tables, expected at most 256"), std::string::npos)
        << error_.text;
    EXPECT_FALSE(demos::loadScene(folder_.path() / "nope.toml", {}, error_));
    EXPECT_EQ(shortened(), "nope.toml: no such file, expected a scene (TOML)");
    EXPECT_FALSE(demos::loadScene(folder_.path() / "out", {}, error_));
    EXPECT_EQ(shortened(), "out: is a folder, expected a scene (TOML)");
}

TEST_F(SceneFile, EveryTruncationLoadsOrSaysWhyOnOneLine) {
    const std::string whole = tests::sampleScene();
    for (size_t length = 0; length < whole.size(); ++length) {
        if (loadText(whole.substr(0, length))) continue;
        EXPECT_TRUE(error_.text.starts_with(file().string())) << length << error_.text;
        EXPECT_EQ(error_.text.find('\n'), std::string::npos) << length << error_.text;
    }
}

// ---- Overrides

TEST_F(SceneFile, OverridesReplaceAndAdd) {
    const auto scene =
        load({"water.waves.wind_m_s=12", "camera.low.vertical_fov_deg=60", "mesh.0.yaw_deg=10",
              "sun.irradiance=[1, 1, 1]", "sun.from_sky=true", "water.waves.spectrum=pierson-moskowitz",
              "title=\"a = b\"", "camera.0.roll_deg=-5"});
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_EQ(scene->water->waves->windMps, 12);
    EXPECT_EQ(scene->cameras[1].verticalFovDeg, 60);
    EXPECT_EQ(scene->cameras[0].rollDeg, -5);
    EXPECT_EQ(scene->meshes[0].yawDeg, 10);
    EXPECT_EQ(scene->sun.irradiance, (demos::Vec3{1, 1, 1}));
    EXPECT_TRUE(scene->sun.fromSky);
    EXPECT_EQ(scene->water->waves->spectrum, "pierson-moskowitz");
    EXPECT_EQ(scene->title, "a = b");
}

TEST_F(SceneFile, OverridesTakeWholeTables) {
    const auto scene = load({"mesh=[]", "water.foam={albedo=0.3}"});
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_TRUE(scene->meshes.empty());
    EXPECT_EQ(scene->water->foam->albedo, 0.3f);
}

TEST_F(SceneFile, TheLastOverrideWins) {
    const auto scene = load({"time_s=3", "time_s=4"});
    ASSERT_TRUE(scene) << error_.text;
    EXPECT_EQ(scene->timeS, 4);
}

TEST_F(SceneFile, OverridesMendWhatIsBroken) {
    EXPECT_TRUE(loadText(replaced("wind_m_s = 6", "wind_m_s = -3"), {"water.waves.wind_m_s=3"}))
        << error_.text;
}

TEST_F(SceneFile, OverrideErrorsNameTheOverride) {
    EXPECT_EQ(problemOf("water.waves.wind_m_s=-3"),
              "--set water.waves.wind_m_s=-3: water.waves.wind_m_s is -3, expected 0 to 100 m/s");
    EXPECT_EQ(problemOf("water.waves.wind_m_s=fast"),
              "--set water.waves.wind_m_s=fast: water.waves.wind_m_s is 'fast', expected 0 to 100 m/s");
    EXPECT_EQ(problemOf("sun.irradience=1"),
              "--set sun.irradience=1: sun.irradience is not a known key, the nearest is sun.irradiance");
    EXPECT_EQ(
        problemOf("waves.wind_m_s=1"),
        "--set waves.wind_m_s=1: waves.wind_m_s is not a known key, the nearest is water.waves.wind_m_s");
    EXPECT_EQ(problemOf("camera.high.roll_deg=1"),
              "--set camera.high.roll_deg=1: the scene has no camera high, expected one of: level, low");
    EXPECT_EQ(problemOf("mesh.1.scale=1"),
              "--set mesh.1.scale=1: the scene has no mesh 1, expected one of: 0");
    EXPECT_EQ(problemOf("camera.low=1"),
              "--set camera.low=1: expected a key after camera.low, such as camera.low.near_m");
    EXPECT_EQ(problemOf("sky=1"), "--set sky=1: sky is 1, expected a table: [sky]");
    EXPECT_EQ(problemOf("time_s"), "--set time_s: expected path=value, such as water.waves.wind_m_s=12");
    EXPECT_EQ(problemOf("=1"), "--set =1: expected path=value, such as water.waves.wind_m_s=12");
    EXPECT_EQ(problemOf("sun.irradiance=[1,"), "--set sun.irradiance=[1,: the value is not TOML, expected a "
                                               "number, true, false, a text or [a, b, c]");
    EXPECT_EQ(problemOf("time_s="),
              "--set time_s=: the value is not TOML, expected a number, true, false, a text or "
              "[a, b, c]");
}

TEST_F(SceneFile, OverridesNameFilesOfAnyName) {
    for (const std::string file : {"/O'Brien/\"boat\" [1] {a}.glb",
                                   "/a#b=c\\d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s.glb", "/a\nb = 'c'.glb", "/[]"}) {
        EXPECT_FALSE(load({"mesh.0.file=" + file}));
        EXPECT_TRUE(error_.text.ends_with(file + ": no such file")) << error_.text;
    }
}

TEST_F(SceneFile, AnOverrideCannotSmuggleInASecondKey) {
    EXPECT_NE(problemOf("time_s=1\ntitle='x'"), "");
}

TEST_F(SceneFile, OddPathsAreRefused) {
    for (const char* path : {".", "..", "camera", "camera.", "camera..", "water.", ".water", "water..waves",
                             "mesh.-1.scale", "mesh.99999999999999999999.scale", "water.waves.wind_m_s.x"}) {
        EXPECT_NE(problemOf(std::string(path) + "=1"), "") << path;
    }
}

// ---- Every field of the table

struct Place {
    const Field* field;
    std::string path;     ///< as --set says it
    demos::Target target; ///< of a scene that is only here for its types
};

/// Every field, found through the table itself.
std::vector<Place> everyField() {
    static Scene types;
    std::vector<Place> places;
    const std::function<void(const demos::Section&, void*, const std::string&)> visit =
        [&](const demos::Section& section, void* owner, const std::string& path) {
            for (const Field& field : section.fields) {
                places.push_back({&field, path + std::string(field.key), field.target(owner)});
            }
            for (const demos::Child& child : section.children) {
                const std::string childPath =
                    path + std::string(child.section->key) + (child.repeated ? ".0." : ".");
                visit(*child.section, child.access.open(owner), childPath);
            }
        };
    visit(demos::sceneSection(), &types, "");
    return places;
}

bool isWhole(const Place& place) {
    const auto* const setting = std::get_if<demos::Setting>(&place.target);
    return std::holds_alternative<uint32_t*>(place.target) ||
           (setting && setting->field->type == seaglass::FieldType::integer);
}

bool isNumber(const Place& place) {
    const auto* const setting = std::get_if<demos::Setting>(&place.target);
    return std::holds_alternative<double*>(place.target) || isWhole(place) ||
           (setting && setting->field->type == seaglass::FieldType::float32);
}

TEST_F(SceneFile, EveryFieldIsInTheTableOnce) {
    std::vector<std::string> paths;
    for (const Place& place : everyField()) paths.push_back(place.path);
    EXPECT_GT(paths.size(), 40u);
    std::sort(paths.begin(), paths.end());
    EXPECT_EQ(std::adjacent_find(paths.begin(), paths.end()), paths.end());
}

/// The sample, with one of everything that can be repeated, and what else wants more than one field.
std::string fullSample() {
    std::string text = withColour("tint = [0.1, 0.2, 0.1]\nvisibility_m = 6");
    text.insert(text.find("\n[water]"),
                "[[mesh.keyframes]]\ntime_s = 3\nposition_m = [0, 0, 0]\nyaw_deg = 9\n"
                "[[mesh.exclusion_volumes]]\npoints_m = [[0, 0], [1, 0], [0, 1]]\n");
    text.insert(text.rfind("\n[[camera]]"),
                "[[camera.keyframes]]\ntime_s = 3\nposition_m = [0, 0, 0]\ntarget_m = [0, 0, 1]\n");
    return text + "[[water.waves.swells]]\n[water.extent]\nsize_m = [25, 10]\n" +
           "[water.shore]\nfile = 'tetra.gltf'\n" +
           "[[water.exclusion_volumes]]\npoints_m = [[0, 0], [1, 0], [0, 1]]\n[fog]\nend_m = 1e9\n";
}

TEST_F(SceneFile, EveryFieldRefusesADate) {
    tests::writeAll(file(), fullSample());
    for (const Place& place : everyField()) {
        EXPECT_NE(problemOf(place.path + "=1979-05-27").find(" is 1979-05-27, expected "), std::string::npos)
            << place.path << ": " << error_.text;
    }
}

TEST_F(SceneFile, EveryNumberRefusesNanAndInfinity) {
    for (const Place& place : everyField()) {
        if (!isNumber(place)) continue;
        for (const char* value : {"nan", "inf", "-inf"})
            EXPECT_NE(problemOf(place.path + "=" + value), "") << place.path;
        // A whole number that no double is.
        const bool isBeyond = place.field->most < 9e18;
        EXPECT_EQ(problemOf(place.path + "=9223372036854775807") != "", isBeyond) << place.path;
    }
}

TEST_F(SceneFile, EveryNumberHoldsItsRange) {
    for (const Place& place : everyField()) {
        if (!isNumber(place)) continue;
        const Field& field = *place.field;
        // A scene has water or a floor, not both, and on a planet the open sea alone.
        const bool floor = place.path.starts_with("floor."), open = place.path == "water.planet_radius_m";
        tests::writeAll(file(), floor  ? tests::sampleFloorScene()
                                : open ? tests::sampleScene()
                                       : fullSample());
        ASSERT_TRUE(std::isfinite(field.least) && std::isfinite(field.most) && field.least < field.most)
            << place.path;
        const auto written = [&](double value) {
            return place.path + "=" +
                   (isWhole(place) ? std::to_string(static_cast<long>(value))
                                   : testing::PrintToString(value));
        };
        const double step = std::max(1.0, std::abs(field.most) * 0.01);
        if (field.rule != demos::Rule::positive) {
            EXPECT_EQ(problemOf(written(field.least)), "");
        }
        EXPECT_EQ(problemOf(written(field.most)), "");
        EXPECT_NE(problemOf(written(field.most + step)), "") << place.path;
        EXPECT_NE(problemOf(written(field.least - step)), "") << place.path;
    }
}

TEST(DemoScenes, Load) {
    size_t count = 0;
    for (const std::filesystem::path& file : tests::demoScenes()) {
        Error error;
        EXPECT_TRUE(demos::loadScene(file, {}, error)) << error.text;
        ++count;
    }
    EXPECT_GE(count, 2u);
}

} // namespace
