// seaglass measure: what it writes, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "host/water/quality.h"
#include "measure/page/pareto.h"
#include "measure/page/plot.h"
#include "measure/picture_error.h"
#include "measure/technique.h"
#include "program/program.h"
#include "tests/program/refused.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using demos::measure::PictureError;
using demos::reference::TruthClass;
using nlohmann::json;
using tests::Outcome;

/// Those a scene can name, and none.
const size_t techniques = demos::measure::techniques().size();
const size_t techniquesOfAFloor = techniques - demos::qualities().size();

class Measure : public testing::Test {
  protected:
    Measure() { tests::writeSample(folder_.path()); }

    Outcome measure(const std::vector<std::string>& more, const fs::path& interruptOnce = {}) {
        std::vector<std::string> arguments = {"measure"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return tests::run(demos::runProgram, {arguments, {}, folder_.path(), 0, interruptOnce});
    }
    json measured(const std::string& folder) const {
        return json::parse(tests::readAll(path(folder) / "tradeoff.json"));
    }
    void expectRefused(const std::vector<std::string>& more, const std::vector<std::string>& words) {
        const std::vector<std::string> before = tests::namesIn(folder_.path());
        tests::expectRefused(measure(more), words);
        EXPECT_EQ(tests::namesIn(folder_.path()), before);
    }
    /// A mirror, so that every pixel's truth is plain.
    void calm() {
        std::string scene = tests::sampleScene();
        const size_t waves = scene.find("[water.waves]");
        scene.erase(waves, scene.find("[water.foam]") - waves);
        const size_t foam = scene.find("[water.foam]");
        scene.erase(foam, scene.find("[water.refraction]") - foam);
        tests::writeAll(folder_.path() / "calm.toml", scene);
    }
    /// A polished one, under the same things.
    void floor() {
        std::string scene = tests::sampleFloorScene();
        const std::string rough = "roughness = 0.25";
        scene.replace(scene.find(rough), rough.size(), "roughness = 0");
        tests::writeAll(folder_.path() / "floor.toml", scene);
    }
    fs::path path(const std::string& name) const { return folder_.path() / name; }
    void expectFiles(const std::string& folder) const {
        EXPECT_EQ(tests::namesIn(path(folder)),
                  (std::vector<std::string>{"1_calm_level.gp", "1_calm_level.png", "1_calm_level.svg",
                                            "index.html", "tradeoff.csv", "tradeoff.json", "tradeoff.md"}));
        EXPECT_NE(tests::readAll(path(folder + "/1_calm_level.svg")).find("sspr"), std::string::npos);
        const std::string markdown = tests::readAll(path(folder + "/tradeoff.md"));
        EXPECT_NE(markdown.find("### calm.toml\n\n| camera |"), std::string::npos) << markdown;
        EXPECT_NE(markdown.find("\n| level | sspr | default |"), std::string::npos) << markdown;
        const std::string page = tests::readAll(path(folder + "/index.html"));
        EXPECT_NE(page.find("src=\"data:image/svg+xml;base64,"), std::string::npos);
        EXPECT_NE(page.find("src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
        EXPECT_EQ(page.find("src=\"http"), std::string::npos) << "nothing from elsewhere";
        EXPECT_NE(page.find("<td>sspr, default</td>"), std::string::npos);
    }

    const tests::TemporaryFolder folder_;
};

void expectNumber(const json& object, const std::string& key) {
    ASSERT_TRUE(object.contains(key)) << key;
    ASSERT_TRUE(object[key].is_number()) << key << " is " << object[key];
    EXPECT_TRUE(std::isfinite(object[key].get<double>())) << key;
}

void expectFigures(const json& entry) {
    EXPECT_EQ(entry["scene"], "calm.toml");
    EXPECT_EQ(entry["camera"], "level");
    for (const char* const key :
         {"ms", "x_floor", "x_floor_spread", "spread_ms", "floor_ms", "surface_ms", "surface_x_trivial"})
        expectNumber(entry["cost"], key);
    for (const json& pass : entry["cost"].at("passes")) expectNumber(pass, "ms");
    for (const char* const key :
         {"flip", "psnr_db", "coverage", "false_sky_hits", "sky_on_geometry", "wrong_share",
          "psnr_surface_db", "flip_picture", "psnr_picture_db", "psnr_exact_db"})
        expectNumber(entry["error"], key);
    for (const char* const key : {"position_px_p50", "position_px_p95", "position_px_max", "psnr_valid_db"})
        EXPECT_EQ(entry["error"].at(key).is_null(),
                  entry["technique"] == "none" || entry["technique"] == "sky")
            << key;
}

/// Of techniques and their qualities over a calm sea, beside each other.
void expectOrder(const std::map<std::string, json>& entries) {
    const json& none = entries.at("none");
    const json& sky = entries.at("sky");
    const json& sspr = entries.at("sspr");
    EXPECT_EQ(none["cost"]["ms"], 0);
    EXPECT_EQ(sky["cost"]["ms"], 0);
    EXPECT_EQ(none["cost"]["bytes"], 0);
    EXPECT_EQ(sky["cost"]["bytes"], 0);
    // Colour, what is known and keys, each pixel; blurred copies and tiles beside.
    EXPECT_GT(sspr["cost"]["bytes"].get<int>(), 96 * 54 * (8 + 2));
    EXPECT_LT(sspr["cost"]["bytes"].get<int>(), 96 * 54 * 40);
    EXPECT_GT(sspr["cost"]["ms"].get<double>(), 0);
    EXPECT_EQ(sky["error"]["coverage"], 0);
    EXPECT_EQ(sky["error"]["sky_on_geometry"], 1);
    EXPECT_GT(sspr["error"]["coverage"].get<double>(), 0.8);
    EXPECT_LT(sspr["error"]["false_sky_hits"].get<double>(), 0.05);
    EXPECT_LT(sspr["error"]["sky_on_geometry"].get<double>(), 0.2);
    EXPECT_LT(sspr["error"]["position_px_p50"].get<double>(), 0.1);
    EXPECT_LT(sspr["error"]["position_px_p95"].get<double>(), 1);
    EXPECT_LT(sspr["error"]["flip"].get<double>(), sky["error"]["flip"].get<double>());
    EXPECT_GT(sspr["error"]["psnr_db"].get<double>(), sky["error"]["psnr_db"].get<double>() + 6);
    EXPECT_LT(entries.at("sspr half")["cost"]["bytes"].get<int>(), sspr["cost"]["bytes"].get<int>() / 2);
    EXPECT_GT(entries.at("sspr half")["error"]["position_px_p50"].get<double>(),
              sspr["error"]["position_px_p50"].get<double>());
    EXPECT_LT(entries.at("sspr coarse keys")["cost"]["bytes"].get<int>(), sspr["cost"]["bytes"].get<int>());
    EXPECT_EQ(entries.count("sky half"), 0u);
    const json& planar = entries.at("planar");
    EXPECT_GT(planar["cost"]["ms"].get<double>(), 0);
    EXPECT_GT(planar["error"]["coverage"].get<double>(), 0.98);
    EXPECT_LE(planar["error"]["false_sky_hits"].get<double>(), 0.01);
    EXPECT_LE(planar["error"]["sky_on_geometry"].get<double>(), 0.02);
}

TEST_F(Measure, WritesCostAndErrorOfEveryTechnique) {
    calm();
    const Outcome outcome = measure({"calm.toml", "-o", "new/tradeoff", "--quick", "--size", "96x54"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "progress is for terminals";
    EXPECT_NE(outcome.out.find("measured: " + path("new/tradeoff/index.html").string()), std::string::npos)
        << outcome.out;
    const json found = measured("new/tradeoff");
    EXPECT_FALSE(found["device"].get<std::string>().empty());
    EXPECT_FALSE(found["driver"].get<std::string>().empty());
    EXPECT_EQ(found["size"], json({96, 54}));
    EXPECT_GT(found["floor_ms"].get<double>(), 0);
    EXPECT_TRUE(found["clock"] == "fence" || found["clock"] == "timestamps") << found["clock"];
    for (const char* const file : {"index.html", "tradeoff.md"}) {
        const std::string text = tests::readAll(path("new/tradeoff") / file);
        EXPECT_NE(text.find(" by " + found["clock"].get<std::string>()), std::string::npos) << file;
    }
    ASSERT_EQ(found["entries"].size(), techniques);
    std::map<std::string, json> entries;
    for (const json& entry : found["entries"]) {
        expectFigures(entry);
        const std::string quality = entry["quality"], technique = entry["technique"];
        entries[quality == "default" ? technique : technique + " " + quality] = entry;
    }
    expectOrder(entries);
    EXPECT_NE(outcome.out.find("\nsspr, half "), std::string::npos) << outcome.out;
    EXPECT_EQ(tests::countLines(tests::readAll(path("new/tradeoff/tradeoff.csv"))), techniques + 1);
    expectFiles("new/tradeoff");
}

TEST_F(Measure, TakesAFloorAsItTakesWater) {
    floor();
    const Outcome outcome = measure({"floor.toml", "-o", "new", "--quick", "--size", "96x54"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json found = measured("new");
    ASSERT_EQ(found["entries"].size(), techniquesOfAFloor);
    std::map<std::string, json> entries;
    for (const json& entry : found["entries"]) {
        size_t draws = 0;
        for (const json& pass : entry["cost"]["passes"]) draws += pass["name"] == "mirror_draw" ? 1 : 0;
        EXPECT_EQ(draws, 1u) << entry["technique"];
        for (const char* const key : {"flip", "psnr_db", "coverage", "false_sky_hits", "sky_on_geometry",
                                      "wrong_share", "flip_picture", "psnr_picture_db"})
            expectNumber(entry["error"], key);
        const bool makesImage = entry["technique"] != "none" && entry["technique"] != "sky";
        EXPECT_EQ(entry["cost"]["ms"] > 0, makesImage);
        EXPECT_EQ(entry["cost"]["bytes"] > 0, makesImage);
        EXPECT_EQ(entry["cost"]["host_bytes"] > 0, makesImage);
        EXPECT_EQ(entry["error"]["position_px_p50"].is_number(), makesImage);
        const std::string quality = entry["quality"], technique = entry["technique"];
        entries[quality == "default" ? technique : technique + " " + quality] = entry;
    }
    EXPECT_EQ(entries.at("none")["error"], entries.at("sky")["error"]);
    const json &sky = entries.at("sky")["error"], &sspr = entries.at("sspr")["error"],
               &planar = entries.at("planar")["error"];
    EXPECT_EQ(sky["coverage"], 0);
    EXPECT_EQ(sky["sky_on_geometry"], 1);
    for (const json& error : {sspr, planar}) {
        EXPECT_GT(error["coverage"].get<double>(), 0.8);
        EXPECT_LT(error["false_sky_hits"].get<double>(), 0.05);
        EXPECT_LT(error["sky_on_geometry"].get<double>(), 0.2);
        EXPECT_LT(error["position_px_p50"].get<double>(), 0.1);
        EXPECT_LT(error["position_px_p95"].get<double>(), 1);
        EXPECT_LT(error["flip"].get<double>(), sky["flip"].get<double>());
        EXPECT_GT(error["psnr_db"].get<double>(), sky["psnr_db"].get<double>() + 6);
    }
    EXPECT_GT(entries.at("sspr half")["error"]["position_px_p50"].get<double>(),
              sspr["position_px_p50"].get<double>());
    EXPECT_NE(tests::readAll(path("new/index.html")).find("surface drawn, ms"), std::string::npos);
}

TEST_F(Measure, BadLinesAreRefused) {
    expectRefused({}, {"no output", "-o DIR"});
    expectRefused({"scene.toml"}, {"no output", "-o DIR"});
    expectRefused({"-o", "new"}, {"demos/scenes", "no scenes"});
    expectRefused({"nope.toml", "-o", "new"}, {"nope.toml", "no such file"});
    expectRefused({"scene.toml", "-o", "new", "--size", "big"}, {"--size is 'big'", "WIDTHxHEIGHT"});
    expectRefused({"scene.toml", "-o", "new", "--sise", "3x3"}, {"--sise", "nearest is --size"});
    expectRefused({"scene.toml", "-o", "new", "--rounds", "0"}, {"--rounds is '0'", "1 to 1000"});
    expectRefused({"scene.toml", "-o", "sky.hdr"}, {"-o sky.hdr", "is a file, expected a folder"});
    expectRefused({"scene.toml", "-o", "new", "--device", "no such device"}, {"no such device"});
    expectRefused({"scene.toml", "-o", "new", "--technique", "sspt"},
                  {"--technique is 'sspt', expected none, sky, sspr, ", " or water; the nearest is sspr"});
    expectRefused({"scene.toml", "-o", "new", "--camera", "leven"},
                  {"--camera is 'leven'", "level, low", "nearest is level"});
    expectRefused({"scene.toml", "-o", "new", "--set", "water.wave.wind_m_s=3"},
                  {"--set water.wave.wind_m_s=3", "nearest is water.waves.wind_m_s"});
    expectRefused({"scene.toml", "-o", "new", "--size", "16384x16384000"}, {"--size is '16384x16384000'"});
    expectRefused({"scene.toml", "-o", "new", "--size", "16384x16384"}, {"--size is '16384x16384'", "GB"});
    std::string dry = tests::sampleScene();
    dry.erase(dry.find("[water]"), dry.find("[[camera]]") - dry.find("[water]"));
    tests::writeAll(path("dry.toml"), dry);
    expectRefused({"scene.toml", "dry.toml", "-o", "new"},
                  {"dry.toml", "neither water nor floor", "[water] or [floor]"});
}

TEST_F(Measure, AFileThatASceneNamesIsRefusedWithItsPlace) {
    tests::writeAll(path("sky.hdr"), "none");
    expectRefused({"scene.toml", "-o", "new", "--quick"}, {"scene.toml", "sky.hdr"});
    // Before anything is measured, whichever scene it is.
    fs::create_directory(path("sound"));
    tests::writeSample(path("sound"));
    expectRefused({"sound/scene.toml", "scene.toml", "-o", "new", "--quick"}, {"scene.toml", "sky.hdr"});
}

TEST_F(Measure, AFolderThatCannotBeWrittenIsRefused) {
    // Not even root writes there.
    expectRefused({"scene.toml", "-o", "/proc/seaglass", "--quick"}, {"-o /proc/seaglass", "cannot be made"});
    expectRefused({"scene.toml", "-o", "/proc", "--quick"}, {"-o /proc", "cannot be written to"});
}

TEST_F(Measure, MeasuresWhatItIsAskedFor) {
    const Outcome outcome =
        measure({"scene.toml", "-o", "some", "--quick", "--size", "48x27", "--technique", "sspr",
                 "--technique", "sky", "--camera", "low", "--set", "time_s=3", "--rounds", "2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(measured("some")["runs"], 2);
    const json entries = measured("some")["entries"];
    ASSERT_GE(entries.size(), 3u);
    EXPECT_EQ(entries[0]["technique"], "sky");
    for (size_t i = 1; i < entries.size(); ++i) EXPECT_EQ(entries[i]["technique"], "sspr");
    for (const json& entry : entries) EXPECT_EQ(entry["camera"], "low");
}

TEST_F(Measure, RandomCamerasAreMeasuredBesideThoseThatAreNamed) {
    const Outcome outcome = measure({"scene.toml", "-o", "some", "--size", "48x27", "--technique", "sky",
                                     "--rounds", "1", "--camera", "low", "--random-cameras", "2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json entries = measured("some")["entries"];
    std::vector<std::string> cameras;
    for (const json& entry : entries) cameras.push_back(entry["camera"]);
    EXPECT_EQ(cameras, (std::vector<std::string>{"low", "random:1", "random:2"}));
    EXPECT_TRUE(fs::exists(path("some/2_scene_random_1.png")));
    expectRefused({"scene.toml", "-o", "new", "--random-cameras", "0"},
                  {"--random-cameras is '0'", "1 to 1000"});
}

// Samples make the reference's picture, not what is asked of a technique.
TEST_F(Measure, ComparesWithAsManySamplesAsItIsAskedFor) {
    const auto measureWith = [&](const char* samples, const char* folder) {
        const Outcome outcome = measure({"scene.toml", "-o", folder, "--quick", "--size", "48x27",
                                         "--technique", "planar", "--spp", samples});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return measured(folder);
    };
    const json one = measureWith("1", "one"), four = measureWith("4", "four");
    EXPECT_EQ(four["reference_samples"], 4);
    const json &before = one["entries"][0]["error"], &after = four["entries"][0]["error"];
    EXPECT_NE(before["flip"], after["flip"]);
    for (const char* const key : {"psnr_db", "coverage", "position_px_p50"})
        EXPECT_EQ(before[key], after[key]);
    expectRefused({"scene.toml", "-o", "new", "--spp", "0"}, {"--spp is '0'"});
}

// Of foam, whose edges are finer than pixels: in the sea without warp there is some before the camera.
TEST_F(Measure, ComparesPicturesThatAreSupersampledIfAsked) {
    std::string foamy = tests::sampleScene();
    foamy.insert(foamy.find("[water.foam]"), "warp = 0\n");
    tests::writeAll(folder_.path() / "foamy.toml", foamy);
    const auto measureWith = [&](const char* factor, const char* folder) {
        const Outcome outcome = measure({"foamy.toml", "-o", folder, "--quick", "--size", "48x27",
                                         "--technique", "planar", "--spp", "64", "--supersample", factor});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return measured(folder);
    };
    const json one = measureWith("1", "one"), four = measureWith("4", "four");
    EXPECT_EQ(four["supersample"], 4);
    const json &before = one["entries"][0]["error"], &after = four["entries"][0]["error"];
    EXPECT_LT(after["flip_picture"].get<double>(), 0.7 * before["flip_picture"].get<double>());
    for (const char* const key : {"psnr_db", "coverage", "position_px_p50"})
        EXPECT_EQ(before[key], after[key]);
    expectRefused({"scene.toml", "-o", "new", "--supersample", "5"}, {"--supersample is '5'", "1 to 4"});
    expectRefused({"scene.toml", "-o", "new", "--size", "8000x10", "--supersample", "3"},
                  {"--supersample is '3'", "16384"});
}

TEST_F(Measure, TakesAllScenesThatMirrorIfNoneIsNamed) {
    for (const char* const name : {"one", "two"}) {
        const fs::path folder = path("demos/scenes") / name;
        fs::create_directories(folder);
        tests::writeSample(folder);
    }
    const auto place = [&](const std::string& name, std::string scene) {
        for (const char* const file : {"sky.hdr", "tetra.gltf"}) scene.replace(scene.find(file), 0, "one/");
        tests::writeAll(path("demos/scenes") / (name + ".toml"), scene);
    };
    std::string dry = tests::sampleScene();
    place("b", dry);
    place("a", dry);
    dry.erase(dry.find("[water]"), dry.find("[[camera]]") - dry.find("[water]"));
    place("dry", dry);
    place("floor", tests::sampleFloorScene());
    const Outcome outcome = measure({"-o", "all", "--quick", "--size", "48x27", "--technique", "sky"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json entries = measured("all")["entries"];
    ASSERT_EQ(entries.size(), 3u);
    EXPECT_EQ(entries[0]["scene"], "demos/scenes/a.toml");
    EXPECT_EQ(entries[1]["scene"], "demos/scenes/b.toml");
    EXPECT_EQ(entries[2]["scene"], "demos/scenes/floor.toml");
}

TEST_F(Measure, FlatWaterIsASceneWithoutWavesAndWhatTheyMake) {
    calm();
    const std::vector<std::string> line = {"--quick", "--size", "48x27", "--technique", "sspr"};
    const auto measureTo = [&](const std::string& folder, std::vector<std::string> more) {
        more.insert(more.end(), {"-o", folder});
        more.insert(more.end(), line.begin(), line.end());
        const Outcome outcome = measure(more);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return measured(folder);
    };
    const json flat = measureTo("flat", {"scene.toml", "--flat", "--set", "water.caustics.strength=1"});
    const json calm = measureTo("calm", {"calm.toml"});
    const json wavy = measureTo("wavy", {"scene.toml"});
    EXPECT_EQ(flat["flat"], true);
    EXPECT_EQ(wavy["flat"], false);
    EXPECT_EQ(flat["entries"][0]["error"], calm["entries"][0]["error"]);
    EXPECT_NE(flat["entries"][0]["error"], wavy["entries"][0]["error"]);
    for (const json& pass : flat["entries"][0]["cost"]["passes"]) EXPECT_NE(pass["name"], "waves_upload");
}

TEST_F(Measure, ThePresetsAreOfWaterAndCostMoreAndMore) {
    const Outcome outcome =
        measure({"scene.toml", "-o", "dial", "--quick", "--size", "96x54", "--technique", "water"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json entries = measured("dial")["entries"];
    ASSERT_EQ(entries.size(), 4u);
    const char* const steps[] = {"low", "medium", "high", "highest"};
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(entries[i]["technique"], "water");
        EXPECT_EQ(entries[i]["quality"], steps[i]);
    }
    EXPECT_LE(entries[0]["cost"]["bytes"], entries[1]["cost"]["bytes"]);
    EXPECT_LT(entries[1]["cost"]["bytes"], entries[2]["cost"]["bytes"]);
    floor();
    expectRefused({"floor.toml", "-o", "none", "--technique", "water"},
                  {"floor.toml", "has a floor", "expected [water]"});
}

TEST_F(Measure, AnInterruptionLeavesWhatIsFinished) {
    calm();
    const Outcome outcome = measure({"calm.toml", "-o", "part", "--size", "64x36"}, path("part/index.html"));
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("interrupted: 1 of 2 views"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(path("part/index.html").string()), std::string::npos) << outcome.err;
    EXPECT_EQ(measured("part")["entries"].size(), techniques);
    EXPECT_EQ(tests::countLines(tests::readAll(path("part/tradeoff.csv"))), techniques + 1);
    EXPECT_EQ(tests::namesIn(path("part")),
              (std::vector<std::string>{"1_calm_level.gp", "1_calm_level.png", "1_calm_level.svg",
                                        "index.html", "tradeoff.csv", "tradeoff.json", "tradeoff.md"}));
}

TEST_F(Measure, WithoutGnuplotOnlyThePlotsAreMissing) {
    const Outcome outcome = tests::run(SEAGLASS_PROGRAM, {{"measure", "scene.toml", "-o", "bare", "--quick",
                                                           "--size", "48x27", "--technique", "sky"},
                                                          {{"PATH", "/nowhere"}},
                                                          folder_.path()});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: gnuplot was not found"), std::string::npos) << outcome.err;
    EXPECT_EQ(tests::namesIn(path("bare")),
              (std::vector<std::string>{"1_scene_level.gp", "1_scene_level.png", "index.html", "tradeoff.csv",
                                        "tradeoff.json", "tradeoff.md"}));
    EXPECT_EQ(tests::readAll(path("bare/index.html")).find("svg+xml"), std::string::npos);
}

class MeasuredTwice : public Measure {
  protected:
    /// Measures so many techniques, or those of a name.
    void expectTheSameErrors(size_t count, const std::vector<std::string>& named = {}) {
        const auto errors = [&](const std::string& folder) {
            std::vector<std::string> line = {"scene.toml", "-o", folder,   "--quick",
                                             "--rounds",   "1",  "--size", "64x36"};
            for (const std::string& name : named) line.insert(line.end(), {"--technique", name});
            const Outcome outcome = measure(line);
            EXPECT_EQ(outcome.code, 0) << outcome.err;
            const json entries = measured(folder)["entries"];
            json found = json::array();
            for (const json& entry : entries) found.push_back(entry["error"]);
            EXPECT_EQ(found.size(), count);
            return found;
        };
        EXPECT_EQ(errors("one"), errors("two"));
    }
};

TEST_F(MeasuredTwice, HybridHasTheSameErrors) {
    expectTheSameErrors(5, {"hybrid"});
}
TEST_F(MeasuredTwice, AllTechniquesHaveTheSameErrors) {
    expectTheSameErrors(techniques);
}

TEST(Plot, JoinsTheFrontAndHasAPlaceForWhatCostsNothing) {
    demos::measure::Tradeoff tradeoff;
    const auto add = [&](const char* technique, const char* quality, double xFloor, double flip) {
        demos::measure::Entry& entry = tradeoff.entries.emplace_back();
        entry.technique = technique;
        entry.quality = quality;
        entry.cost.xFloor = xFloor;
        entry.error.flip = flip;
    };
    add("sky", "default", 0, 0.3);
    add("good", "high", 8, 0.1);
    add("bad", "default", 16, 0.2);
    add("unseen", "default", 4, 0.05);
    tradeoff.entries.back().error.flip.reset();
    const demos::measure::Sheet sheet = {"s", "c", "f", 0, 4};
    const std::string script = plotScript(tradeoff, sheet, "a\"b.svg");
    const auto has = [&](const std::string& text) { return script.find(text) != std::string::npos; };
    EXPECT_TRUE(has("set output \"a b.svg\""));
    EXPECT_TRUE(has("$front << EOD\n2 0.3\n8 0.1\nEOD")) << script;
    EXPECT_TRUE(has("$beaten << EOD\n16 16 16 0.2\nEOD")) << script;
    EXPECT_TRUE(has("\"0\" 2,")) << script;
    EXPECT_TRUE(has("\"2\" at 8,0.1") && has("\"2  good, high\" at graph")) << script;
    EXPECT_TRUE(has("\"3\" at 16,0.2") && has("\"3  bad\" at graph")) << script;
    EXPECT_FALSE(has("unseen"));
}

TEST(Pareto, KeepsWhatNothingBeats) {
    using demos::measure::paretoFront;
    EXPECT_EQ(paretoFront({{0, 3}, {1, 2}, {2, 2}, {3, 1}, {0, 4}}),
              (std::vector<bool>{true, true, false, true, false}));
    EXPECT_EQ(paretoFront({{1, 1}, {1, 1}}), (std::vector<bool>{true, true})) << "equals do not beat";
}

/// One row of pixels, all of one grey, of which the truth and the technique say these things.
struct Row {
    Row(const std::vector<TruthClass>& kinds, const std::string& claims)
        : width(static_cast<uint32_t>(kinds.size())) {
        const demos::Picture grey{width, 1, std::vector<float>(width * 4, 0.2f)};
        truth.color = truth.mirrored = truth.truth = grey;
        shots.color = shots.reflection = shots.sources = shots.scene = grey;
        for (size_t i = 0; i < width; ++i) {
            truth.truth.rgba[4 * i] = static_cast<float>(kinds[i]);
            truth.truth.rgba[4 * i + 1] = truth.truth.rgba[4 * i + 2] = 10;
            shots.sources.rgba[4 * i] = shots.sources.rgba[4 * i + 1] = 10;
            shots.sources.rgba[4 * i + 3] = claims[i] == 'h' ? 2 : claims[i] == 's' ? 1 : 0;
        }
    }
    PictureError error() const {
        demos::Error problem;
        const std::optional<PictureError> found = errorOf(truth, shots, 0, problem);
        EXPECT_TRUE(found) << problem.text;
        return found.value_or(PictureError{});
    }

    uint32_t width;
    demos::reference::Pictures truth;
    demos::measure::Shots shots;
};

constexpr TruthClass none = TruthClass::none, sky = TruthClass::sky, recoverable = TruthClass::recoverable,
                     offScreen = TruthClass::offScreen;

TEST(PictureErrors, CountWhatEachClassOfTruthAllows) {
    Row row({recoverable, recoverable, offScreen, sky, sky, none}, "hsshuh");
    row.shots.color.rgba[0] = 0.4f;
    row.shots.color.rgba[4 * 5] = 9; // no water, and wholly wrong
    const PictureError error = row.error();
    EXPECT_EQ(error.coverage, 0.5);
    EXPECT_EQ(error.falseSkyHits, 0.5);
    EXPECT_FALSE(error.falseSkyHitsInside) << "none is among others";
    EXPECT_DOUBLE_EQ(error.skyOnGeometry.value(), 2.0 / 3);
    EXPECT_EQ(error.wrongShare, 0.2);
    EXPECT_LT(error.psnrPictureDb.value(), error.psnrSurfaceDb.value());
    EXPECT_GT(error.flip.value(), 0);
    EXPECT_FALSE(error.psnrDb) << "nothing differs there, and infinite is no number";

    const PictureError dry = Row({none, none}, "hh").error();
    EXPECT_FALSE(dry.flip || dry.psnrSurfaceDb || dry.coverage || dry.falseSkyHits || dry.wrongShare ||
                 dry.positionPxP50)
        << "shares of nothing";
    EXPECT_EQ(dry.flipPicture, 0);
}

TEST(PictureErrors, KnowEdgesOfTheSkyFromWhatHangsInIt) {
    const std::vector<TruthClass> kinds = {recoverable, sky, sky, sky, sky, sky};
    const PictureError atEdge = Row(kinds, "hhssss").error(), hanging = Row(kinds, "hsshss").error();
    EXPECT_EQ(atEdge.falseSkyHits, hanging.falseSkyHits);
    EXPECT_EQ(atEdge.falseSkyHitsInside, 0);
    EXPECT_EQ(hanging.falseSkyHitsInside, 0.25);
}

TEST(PictureErrors, OfTheReflectionAreWhereItCouldBeFound) {
    Row row({recoverable, recoverable, recoverable, offScreen, sky}, "hhsss");
    row.shots.reflection.rgba[4 * 3] = row.shots.reflection.rgba[4 * 4] = 5;
    EXPECT_FALSE(row.error().psnrDb) << "these could not";
    row.shots.reflection.rgba[4 * 2] = 5;
    EXPECT_TRUE(row.error().psnrDb);
    EXPECT_FALSE(row.error().psnrValidDb) << "that was not";
    const double before = row.error().psnrDb.value();
    row.shots.reflection.rgba[0] = 5;
    EXPECT_TRUE(row.error().psnrValidDb);
    EXPECT_NEAR(row.error().psnrDb.value(), before - 10 * std::log10(2.0), 1e-6);
}

TEST(PictureErrors, AnExactLookupReadsThePixelThatShowsTheMirroredPoint) {
    Row row({recoverable, none, none, sky}, "uuuu");
    row.truth.truth.rgba[1] = 2.9f;
    row.truth.truth.rgba[2] = 0.5f;
    row.shots.scene.rgba[0] = row.shots.scene.rgba[4] = row.shots.scene.rgba[4 * 3] = 5;
    EXPECT_FALSE(row.error().psnrExactDb) << "none of these is looked up";
    row.shots.scene.rgba[4 * 2] = 0.4f;
    const PictureError error = row.error();
    row.shots.reflection.rgba[0] = 0.4f;
    EXPECT_DOUBLE_EQ(error.psnrExactDb.value(), row.error().psnrDb.value());
}

TEST(PictureErrors, PositionsAreOfHitsThatCouldBeFound) {
    Row row({recoverable, recoverable, recoverable, recoverable, offScreen}, "hhhsh");
    row.shots.sources.rgba[0] += 3;
    row.shots.sources.rgba[1] += 4;
    row.shots.sources.rgba[4 * 2] += 1;
    row.shots.sources.rgba[4 * 3] = row.shots.sources.rgba[4 * 4] = -1;
    const PictureError error = row.error();
    EXPECT_DOUBLE_EQ(error.positionPxP50.value(), 1);
    EXPECT_DOUBLE_EQ(error.positionPxP95.value(), 1 + 0.9 * 4);
    EXPECT_DOUBLE_EQ(error.positionPxMax.value(), 5);
}

TEST(PictureErrors, ArePictureByPictureRefusedWhereSomethingIsNotFinite) {
    const auto refused = [](const char* where, const auto& spoil) {
        Row row({recoverable, recoverable, sky}, "hhs");
        spoil(row);
        demos::Error problem;
        EXPECT_FALSE(errorOf(row.truth, row.shots, 0, problem));
        EXPECT_EQ(problem.text,
                  "NaN or infinity in 2 pixels of the " + std::string(where) + ", expected none");
    };
    const auto spoil = [](demos::Picture& picture) {
        picture.rgba[1] = std::numeric_limits<float>::quiet_NaN();
        picture.rgba[10] = picture.rgba[11] = std::numeric_limits<float>::infinity();
    };
    refused("picture", [&](Row& row) { spoil(row.shots.color); });
    refused("reflection", [&](Row& row) { spoil(row.shots.reflection); });
    refused("reflection's sources", [&](Row& row) { spoil(row.shots.sources); });
    refused("scene", [&](Row& row) { spoil(row.shots.scene); });
    refused("reference", [&](Row& row) { spoil(row.truth.color); });
    refused("reference's reflection", [&](Row& row) { spoil(row.truth.mirrored); });
}

} // namespace
