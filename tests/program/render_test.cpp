// What the program does when all is well, and when the run fails.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/program.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;

class Render : public testing::Test {
  protected:
    Render() { tests::writeSample(folder_.path()); }

    /// Renders the sample small, into out/.
    Outcome render(const std::vector<std::string>& more, size_t largestFile = 0) {
        std::vector<std::string> arguments = {"render", "scene.toml", "--size", "32x18"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return tests::run(demos::runProgram, {arguments, {}, folder_.path(), largestFile});
    }
    fs::path out(const std::string& name) const { return folder_.path() / "out" / name; }
    std::vector<std::string> outputs() const { return tests::namesIn(folder_.path() / "out"); }

    tests::TemporaryFolder folder_;
};

/// Width and height from a PNG's header, which come big-endian after the signature and the chunk's name.
std::pair<unsigned, unsigned> pngSize(const std::string& png) {
    const auto number = [&png](size_t at) {
        unsigned value = 0;
        for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png.at(at + i));
        return value;
    };
    return {number(16), number(20)};
}

using Names = std::vector<std::string>;

TEST(Program, PrintsVersionAndHelp) {
    const Outcome version = tests::run(SEAGLASS_PROGRAM, {{"--version"}});
    EXPECT_EQ(version.code, 0);
    EXPECT_TRUE(version.out.starts_with("seaglass ")) << version.out;
    for (const std::vector<std::string>& arguments :
         {Names{"--help"}, Names{"render", "--help"}, Names{"devices", "-h"}}) {
        const Outcome help = tests::run(SEAGLASS_PROGRAM, {arguments});
        EXPECT_EQ(help.code, 0);
        EXPECT_EQ(help.err, "");
        EXPECT_NE(help.out.find("Usage"), std::string::npos) << help.out;
    }
    EXPECT_NE(tests::run(SEAGLASS_PROGRAM, {{"render", "--help"}}).out.find("--aov"), std::string::npos);
}

TEST(Program, ListsDevices) {
    const Outcome outcome = tests::run(SEAGLASS_PROGRAM, {{"devices"}});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("supported"), std::string::npos) << outcome.out;
}

TEST_F(Render, WritesEveryOutputAndSaysWhere) {
    const Outcome outcome = render({"-o", "out/a.png", "-o", "out/b.exr"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outputs(), (Names{"a.png", "b.exr"}));
    EXPECT_EQ(pngSize(tests::readAll(out("a.png"))), std::make_pair(32u, 18u));
    EXPECT_TRUE(tests::readAll(out("b.exr")).starts_with("\x76\x2f\x31\x01"));
    EXPECT_EQ(tests::countLines(outcome.out), 2u);
    EXPECT_NE(outcome.out.find(": 32x18, "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" ms a frame, " + out("a.png").string()), std::string::npos) << outcome.out;
}

TEST_F(Render, DrawsNothingTwiceWhereNoTimeIsAskedFor) {
    const Outcome outcome = render({"-o", "out/a.png", "--plain", "--untimed"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(": 32x18, " + out("a.png").string()), std::string::npos) << outcome.out;
    ASSERT_EQ(render({"-o", "out/b.png", "--plain"}).code, 0);
    EXPECT_TRUE(tests::readAll(out("a.png")) == tests::readAll(out("b.png")));
    tests::expectRefused(render({"-o", "out/c.png", "--untimed", "--stats", "out/c.json"}),
                         {"--untimed and --stats exclude each other"});
}

TEST_F(Render, WhatIsToBeLookedAtIsSeenThroughAirAndLens) {
    ASSERT_EQ(render({"-o", "out/seen.png"}).code, 0);
    ASSERT_EQ(render({"-o", "out/plain.png", "--plain"}).code, 0);
    ASSERT_EQ(render({"-o", "out/measured.png", "-o", "out/measured.exr"}).code, 0);
    ASSERT_EQ(render({"-o", "out/foggy.png", "--set", "fog.density_per_m=0", "--supersample", "1"}).code, 0);
    const std::string plain = tests::readAll(out("plain.png"));
    EXPECT_TRUE(tests::readAll(out("measured.png")) == plain);
    EXPECT_FALSE(tests::readAll(out("seen.png")) == plain);
    EXPECT_FALSE(tests::readAll(out("foggy.png")) == plain) << "its light strays";
}

TEST_F(Render, ASceneWithoutGlitterHasNone) {
    const std::vector<std::string> towardsTheSun = {"--set", "sun.azimuth_deg=270", "--supersample", "1"};
    const auto seen = [&](const char* name, std::vector<std::string> more) {
        more.insert(more.end(), towardsTheSun.begin(), towardsTheSun.end());
        more.insert(more.end(), {"-o", std::string("out/") + name});
        const Outcome outcome = render(more);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return tests::readAll(out(name));
    };
    const std::string unsaid = seen("unsaid.png", {}), none = seen("none.png", {"--set", "water.glitter=0"});
    std::string scene = tests::sampleScene();
    scene.insert(scene.find("[water.waves]"), "glitter = 0\n\n");
    tests::writeAll(folder_.path() / "scene.toml", scene);
    EXPECT_FALSE(unsaid == none);
    EXPECT_TRUE(seen("said.png", {}) == none);
}

/// What a meter said.
double exposureIn(const Outcome& outcome) {
    const std::string name = "exposure_ev: ";
    const size_t at = outcome.out.find(name);
    EXPECT_NE(at, std::string::npos) << outcome.out << outcome.err;
    return at == std::string::npos ? 0 : std::stod(outcome.out.substr(at + name.size()));
}

// Four times the light asks for two stops less, and the picture is the same.
TEST_F(Render, AMeterExposesAnyLightAlike) {
    const Outcome dim = render({"-o", "out/dim.png", "--metered"});
    const Outcome bright = render({"-o", "out/bright.png", "--metered", "--set", "sky.intensity=4", "--set",
                                   "sun.irradiance=[12, 8, 4]", "--set", "exposure_ev=9"});
    EXPECT_NEAR(exposureIn(dim) - exposureIn(bright), 2, 0.02);
    ASSERT_EQ(render({"-o", "out/unmetered.png"}).code, 0);
    EXPECT_FALSE(tests::readAll(out("unmetered.png")) == tests::readAll(out("dim.png")));
}

// A scene's exposure is for its own light: by night's, noon is white.
TEST_F(Render, AnotherHourIsMeteredUnlessItsExposureIsSaid) {
    const auto meters = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"-o", "out/hour.png", "--supersample", "1"});
        const Outcome outcome = render(more);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out.find("metered") != std::string::npos;
    };
    EXPECT_FALSE(meters({}));
    EXPECT_TRUE(meters({"--set", "sky.clear=true"}));
    EXPECT_TRUE(meters({"--set", "sun.elevation_deg=5"}));
    EXPECT_FALSE(meters({"--set", "sky.clear=true", "--set", "exposure_ev=2"}));
    EXPECT_FALSE(meters({"--set", "sky.clear=true", "--plain"})) << "to be measured";
}

TEST_F(Render, TheSameCommandGivesTheSameBytes) {
    ASSERT_EQ(render({"-o", "out/a.exr", "--time", "7.25"}).code, 0);
    ASSERT_EQ(render({"-o", "out/b.exr", "--time", "7.25"}).code, 0);
    EXPECT_TRUE(tests::readAll(out("a.exr")) == tests::readAll(out("b.exr")));
}

TEST_F(Render, WarnsOfWavesThatTheCascadesCannotHold) {
    const Outcome lost = render({"-o", "out/a.png", "--set", "water.waves.largest_patch_m=10"});
    EXPECT_EQ(lost.code, 0) << lost.err;
    EXPECT_EQ(tests::countLines(lost.err), 1u) << lost.err;
    EXPECT_TRUE(lost.err.starts_with("warning: scene.toml: the cascades hold ")) << lost.err;
    EXPECT_NE(lost.err.find("too long for water.waves.largest_patch_m"), std::string::npos) << lost.err;
    const Outcome few = render(
        {"-o", "out/b.png", "--set", "water.waves.largest_patch_m=2000", "--set", "water.waves.samples=16"});
    EXPECT_NE(few.err.find("too short for water.waves.samples"), std::string::npos) << few.err;
    const Outcome flat = render(
        {"-o", "out/c.png", "--set", "water.waves.largest_patch_m=10", "--set", "water.waves.amplitude=0"});
    EXPECT_EQ(flat.err, "") << "nothing is asked for";
}

TEST_F(Render, WarnsOfFormerKeys) {
    const Outcome outcome = render({"-o", "out/a.png", "--strict", "--set", "water.reflection.roof_looks=2"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "warning: --set water.reflection.roof_looks=2: water.reflection.roof_looks is "
                           "called overhang_samples now\n");
}

TEST_F(Render, TimeCameraAndOverridesShow) {
    const std::vector<Names> variants = {{},
                                         {"--time", "3"},
                                         {"--camera", "low"},
                                         {"--set", "water.waves.wind_m_s=15"},
                                         {"--set", "sky.intensity=2"},
                                         {"--set", "water.fresnel=schlick"},
                                         {"--set", "mesh=[]"},
                                         {"--aov", "height"}};
    std::vector<std::string> pictures;
    for (const Names& variant : variants) {
        Names arguments = {"-o", "out/a.exr"};
        arguments.insert(arguments.end(), variant.begin(), variant.end());
        const Outcome outcome = render(arguments);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        pictures.push_back(tests::readAll(out("a.exr")));
    }
    for (size_t i = 1; i < pictures.size(); ++i)
        EXPECT_FALSE(pictures[i] == pictures[0]) << variants[i].back();
}

TEST_F(Render, QualitySetsWhatMayBeSetAfterIt) {
    const auto pictureOf = [&](const Names& more) {
        Names arguments = {"-o", "out/a.exr", "--size", "96x54"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = render(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return tests::readAll(out("a.exr"));
    };
    const std::string low = pictureOf({"--quality", "low"}), highest = pictureOf({"--quality", "highest"});
    EXPECT_FALSE(low == highest);
    const Names asLow = {"--set", "water.cells_per_level=128",    "--set", "water.reflection_samples=1",
                         "--set", "water.refraction_samples=2",   "--set", "water.slope_samples=1",
                         "--set", "water.wave_shadow_steps=0",    "--set", "water.reflection.technique=sspr",
                         "--set", "water.reflection.downscale=2", "--set", "water.parallax=false",
                         "--set", "water.pixels_per_shading=4"};
    EXPECT_TRUE(pictureOf(asLow) == low);
    Names after = {"--quality", "highest"};
    after.insert(after.end(), asLow.begin(), asLow.end());
    EXPECT_TRUE(pictureOf(after) == low);
}

TEST_F(Render, SkyAndMeshOfOnesOwn) {
    tests::writeAll(folder_.path() / "mine's.hdr", tests::sampleSky());
    tests::writeAll(folder_.path() / "mine [1].gltf", tests::sampleMesh());
    const Outcome outcome = render({"-o", "out/a.png", "--sky", "mine's.hdr", "--mesh", "mine [1].gltf",
                                    "--set", "mesh.0.position_m=[0, 0, -8]"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(Render, SkiesHaveDetailWhereTheSceneSaysSoAndItsOwnSkyIsSeen) {
    tests::writeAll(folder_.path() / "mine.hdr", tests::sampleSky());
    const auto pictureOf = [this](Names more) {
        more.insert(more.end(), {"-o", "out/a.png"});
        EXPECT_EQ(render(more).code, 0);
        return tests::readAll(out("a.png"));
    };
    const Names detailed = {"--set", "sky.detail=1"}, mine = {"--sky", "mine.hdr"};
    const Names plain = {"--plain"}, plainDetailed = {"--plain", "--set", "sky.detail=1"};
    std::string text = tests::readAll(folder_.path() / "scene.toml");
    EXPECT_TRUE(pictureOf(plainDetailed) == pictureOf(plain)) << "what is measured has the file's own";
    EXPECT_FALSE(pictureOf(detailed) == pictureOf({}));
    const std::string others = pictureOf(mine);
    text.insert(text.find("file = \"sky.hdr\""), "detail = 1.0\n");
    tests::writeAll(folder_.path() / "scene.toml", text);
    EXPECT_TRUE(pictureOf(mine) == others) << "which may be of more than clouds";
    EXPECT_FALSE(pictureOf({"--sky", "mine.hdr", "--set", "sky.detail=1"}) == others);
}

TEST_F(Render, EveryAov) {
    for (const char* aov : {"color", "reflection", "class", "height", "normal", "foam", "depth",
                            "reflection_source", "scene"}) {
        const Outcome outcome = render({"-o", "out/a.png", "--aov", aov});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "") << aov;
    }
    EXPECT_NE(render({"-o", "out/a.png", "--aov", "height"}).out.find("scale: black -"), std::string::npos);
}

TEST_F(Render, EveryOverlay) {
    for (const char* aov :
         {"overlay_depth", "overlay_plane", "overlay_classes", "overlay_confidence", "overlay_distance"}) {
        const Outcome outcome = render({"-o", "out/a.png", "--aov", aov});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "") << aov;
    }
    EXPECT_EQ(render({"-o", "out/a.png", "--aov", "overlay_plane"}).code, 0);
    const std::string right = tests::readAll(out("a.png"));
    for (const char* mistake : {"flipped_y", "forward_depth"}) {
        const Outcome outcome = render({"-o", "out/a.png", "--aov", "overlay_plane", "--mistake", mistake});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_FALSE(tests::readAll(out("a.png")) == right) << mistake;
    }
}

TEST_F(Render, EveryAovOfAFloor) {
    tests::writeAll(folder_.path() / "scene.toml", tests::sampleFloorScene());
    std::vector<std::string> pictures;
    for (const char* aov : {"color", "reflection", "class", "height", "normal", "foam", "depth",
                            "overlay_plane", "overlay_classes"}) {
        const Outcome outcome = render({"-o", "out/a.png", "--aov", aov, "--validation"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "") << aov;
        pictures.push_back(tests::readAll(out("a.png")));
    }
    EXPECT_FALSE(pictures[1] == pictures[5]) << "the reflection is black";
    EXPECT_FALSE(pictures[2] == pictures[5]) << "the classes are black";
    EXPECT_FALSE(pictures[4] == pictures[5]) << "the normals are black";
}

TEST_F(Render, AFloorMirrorsNoMoreThanItIsAskedTo) {
    std::string scene = tests::sampleFloorScene();
    tests::writeAll(folder_.path() / "scene.toml", scene);
    ASSERT_EQ(render({"-o", "out/sspr.exr"}).code, 0);
    ASSERT_EQ(render({"-o", "out/sky.exr", "--set", "floor.reflection.technique=sky"}).code, 0);
    const size_t from = scene.find("[floor.reflection]"), to = scene.find("[[camera]]");
    tests::writeAll(folder_.path() / "scene.toml", scene.erase(from, to - from));
    const Outcome outcome = render({"-o", "out/none.exr", "--validation"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(tests::readAll(out("none.exr")) == tests::readAll(out("sky.exr")));
    EXPECT_FALSE(tests::readAll(out("sspr.exr")) == tests::readAll(out("sky.exr")));
}

TEST_F(Render, WithoutWaterAndWithFlatWater) {
    const std::string scene = tests::sampleScene();
    const size_t water = scene.find("[water]"), waves = scene.find("[water.waves]"),
                 camera = scene.find("[[camera]]");
    tests::writeAll(folder_.path() / "scene.toml", scene.substr(0, water) + scene.substr(camera));
    EXPECT_EQ(render({"-o", "out/dry.png"}).code, 0);
    tests::writeAll(folder_.path() / "scene.toml", scene.substr(0, waves) + scene.substr(camera));
    EXPECT_EQ(render({"-o", "out/flat.png"}).code, 0);
}

TEST_F(Render, ValidationIsSilent) {
    const Outcome outcome = render({"-o", "out/a.png", "--validation", "--frames", "2", "--fps", "10"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
}

TEST_F(Render, SupersamplingKeepsTheSizeAndSoftensEdges) {
    ASSERT_EQ(render({"-o", "out/once.exr"}).code, 0);
    ASSERT_EQ(render({"-o", "out/four.exr", "--supersample", "2"}).code, 0);
    EXPECT_EQ(outputs(), (Names{"four.exr", "once.exr"}));
    EXPECT_FALSE(tests::readAll(out("once.exr")) == tests::readAll(out("four.exr")));
}

TEST_F(Render, SequencesAreNumberedBeforeTheExtension) {
    const Outcome outcome = render({"-o", "out/a.png", "--frames", "3", "--fps", "10"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outputs(), (Names{"a_0000.png", "a_0001.png", "a_0002.png"}));
    EXPECT_NE(outcome.out.find("a_0000.png .. a_0002.png"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "") << "progress is for terminals";
}

TEST_F(Render, SequencesAreNumberedInPlace) {
    ASSERT_EQ(render({"-o", "out/%02d_a.png", "--frames", "2"}).code, 0);
    EXPECT_EQ(outputs(), (Names{"00_a.png", "01_a.png"}));
}

TEST_F(Render, ASequenceRunsInTime) {
    ASSERT_EQ(render({"-o", "out/a.exr", "--time", "2", "--frames", "2", "--fps", "4"}).code, 0);
    ASSERT_EQ(render({"-o", "out/b.exr", "--time", "2.25"}).code, 0);
    EXPECT_TRUE(tests::readAll(out("a_0001.exr")) == tests::readAll(out("b.exr")));
}

TEST_F(Render, StatsAreJson) {
    const Outcome outcome = render({"-o", "out/a.png", "--stats", "out/a.json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json stats = nlohmann::json::parse(tests::readAll(out("a.json")));
    EXPECT_FALSE(stats.at("device").get<std::string>().empty());
    EXPECT_TRUE(stats.at("driver").is_string());
    EXPECT_EQ(stats.at("size"), nlohmann::json::parse("[32, 18]"));
    EXPECT_EQ(stats.at("scene"), (folder_.path() / "scene.toml").string());
    EXPECT_EQ(stats.at("camera"), "level");
    EXPECT_GT(stats.at("frame_ms").get<double>(), 0);
    // Only what timestamps took has a time on the device alone.
    EXPECT_TRUE(stats.at("clock") == "fence" || stats.at("clock") == "timestamps") << stats.at("clock");
    EXPECT_EQ(stats.at("gpu_frame_ms").is_null(), stats.at("clock") == "fence");
    EXPECT_NE(outcome.out.find(stats.at("clock").get<std::string>()), std::string::npos) << outcome.out;
    EXPECT_GT(stats.at("floor_ms").get<double>(), 0);
    EXPECT_GT(stats.at("full_screen_ms").get<double>(), 0);
    EXPECT_GT(stats.at("runs").get<int>(), 1);
    ASSERT_FALSE(stats.at("passes").empty());
    for (const nlohmann::json& pass : stats.at("passes")) {
        EXPECT_FALSE(pass.at("name").get<std::string>().empty());
        EXPECT_GE(pass.at("ms").get<double>(), 0);
        EXPECT_GE(pass.at("spread_ms").get<double>(), 0);
        EXPECT_NE(outcome.out.find(pass.at("name").get<std::string>()), std::string::npos) << outcome.out;
    }
}

TEST_F(Render, AFullDiskFailsTheRunAndLeavesNoHalfPicture) {
    for (const char* name : {"out/a.png", "out/a.exr"}) {
        const Outcome outcome = render({"-o", name, "--set", "camera.level.roll_deg=20"}, 200);
        EXPECT_EQ(outcome.code, 1) << name;
        EXPECT_NE(outcome.err.find(fs::path(name).filename().string()), std::string::npos) << outcome.err;
        EXPECT_TRUE(outputs().empty()) << outputs().front();
    }
}

} // namespace
