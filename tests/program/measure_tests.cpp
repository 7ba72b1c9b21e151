// seaglass measure: what it writes, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "measure/pareto.h"
#include "measure/picture_error.h"
#include "reference/truth.h"
#include "tests/program/refused.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using demos::measure::Answers;
using demos::measure::PictureError;
using demos::reference::TruthClass;
using nlohmann::json;
using tests::Outcome;

class Measure : public testing::Test {
  protected:
    Measure() { tests::writeSample(folder_.path()); }

    Outcome measure(const std::vector<std::string>& more, const fs::path& interruptOnce = {}) {
        std::vector<std::string> arguments = {"measure"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return tests::run(SEAGLASS_PROGRAM, {arguments, {}, folder_.path(), 0, interruptOnce});
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
    fs::path path(const std::string& name) const { return folder_.path() / name; }

    const tests::TemporaryFolder folder_;
};

void expectNumber(const json& object, const std::string& key) {
    ASSERT_TRUE(object.contains(key)) << key;
    ASSERT_TRUE(object[key].is_number()) << key << " is " << object[key];
    EXPECT_TRUE(std::isfinite(object[key].get<double>())) << key;
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
    ASSERT_EQ(found["entries"].size(), 3u);
    std::map<std::string, json> entries;
    for (const json& entry : found["entries"]) {
        EXPECT_EQ(entry["scene"], "calm.toml");
        EXPECT_EQ(entry["camera"], "level");
        EXPECT_EQ(entry["quality"], "default");
        for (const char* const key : {"ms", "x_floor", "x_floor_spread", "spread_ms", "floor_ms"})
            expectNumber(entry["cost"], key);
        EXPECT_TRUE(entry["cost"].at("bytes").is_null());
        for (const json& pass : entry["cost"].at("passes")) expectNumber(pass, "ms");
        for (const char* const key : {"flip", "psnr_db", "coverage", "false_sky_hits", "sky_on_geometry",
                                      "wrong_share", "flip_picture", "psnr_picture_db"})
            expectNumber(entry["error"], key);
        for (const char* const key : {"position_px_p50", "position_px_p95"})
            EXPECT_TRUE(entry["error"].at(key).is_null());
        entries[entry["technique"]] = entry;
    }
    const json& none = entries.at("none");
    const json& sky = entries.at("sky");
    const json& sspr = entries.at("sspr");
    EXPECT_EQ(none["cost"]["ms"], 0);
    EXPECT_EQ(sky["cost"]["ms"], 0);
    EXPECT_GT(sspr["cost"]["ms"].get<double>(), 0);
    EXPECT_EQ(sky["error"]["coverage"], 0);
    EXPECT_EQ(sky["error"]["sky_on_geometry"], 1);
    EXPECT_GT(sspr["error"]["coverage"].get<double>(), 0.8);
    EXPECT_LT(sspr["error"]["false_sky_hits"].get<double>(), 0.05);
    EXPECT_LT(sspr["error"]["sky_on_geometry"].get<double>(), 0.2);
    EXPECT_LT(sspr["error"]["flip"].get<double>(), sky["error"]["flip"].get<double>());
    EXPECT_EQ(tests::countLines(tests::readAll(path("new/tradeoff/tradeoff.csv"))), 4u);

    EXPECT_EQ(tests::namesIn(path("new/tradeoff")),
              (std::vector<std::string>{"1_calm_level.png", "1_calm_level.svg", "index.html", "tradeoff.csv",
                                        "tradeoff.json"}));
    const std::string page = tests::readAll(path("new/tradeoff/index.html"));
    EXPECT_NE(page.find("<polyline class=\"front\""), std::string::npos);
    EXPECT_NE(page.find("src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos) << "nothing from elsewhere";
    EXPECT_NE(page.find("<td>sspr, default</td>"), std::string::npos);
}

TEST_F(Measure, BadLinesAreRefused) {
    expectRefused({}, {"no output", "-o DIR"});
    expectRefused({"scene.toml"}, {"no output", "-o DIR"});
    expectRefused({"-o", "new"}, {"demos/scenes/harbour.toml", "no such file"});
    expectRefused({"nope.toml", "-o", "new"}, {"nope.toml", "no such file"});
    expectRefused({"scene.toml", "-o", "new", "--size", "big"}, {"--size is 'big'", "WIDTHxHEIGHT"});
    expectRefused({"scene.toml", "-o", "new", "--sise", "3x3"}, {"--sise", "nearest is --size"});
    expectRefused({"scene.toml", "-o", "sky.hdr"}, {"-o sky.hdr", "is a file, expected a folder"});
    expectRefused({"scene.toml", "-o", "new", "--device", "no such device"}, {"no such device"});
    expectRefused({"scene.toml", "-o", "new", "--technique", "sspt"},
                  {"--technique is 'sspt'", "none, sky, sspr", "nearest is sspr"});
    expectRefused({"scene.toml", "-o", "new", "--camera", "leven"},
                  {"--camera is 'leven'", "level, low", "nearest is level"});
    expectRefused({"scene.toml", "-o", "new", "--set", "water.wave.wind_m_s=3"},
                  {"--set water.wave.wind_m_s=3", "nearest is water.waves.wind_m_s"});
    expectRefused({"scene.toml", "-o", "new", "--size", "16384x16384000"}, {"--size is '16384x16384000'"});
    expectRefused({"scene.toml", "-o", "new", "--size", "16384x16384"}, {"--size is '16384x16384'", "GB"});
    std::string dry = tests::sampleScene();
    dry.erase(dry.find("[water]"), dry.find("[[camera]]") - dry.find("[water]"));
    tests::writeAll(path("dry.toml"), dry);
    expectRefused({"scene.toml", "dry.toml", "-o", "new"}, {"dry.toml", "no water"});
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
    const Outcome outcome = measure({"scene.toml", "-o", "some", "--quick", "--size", "48x27", "--technique",
                                     "sspr", "--technique", "sky", "--camera", "low", "--set", "time_s=3"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json entries = measured("some")["entries"];
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[0]["technique"], "sky");
    EXPECT_EQ(entries[1]["technique"], "sspr");
    for (const json& entry : entries) EXPECT_EQ(entry["camera"], "low");
}

TEST_F(Measure, FlatWaterIsASceneWithoutWavesAndFoam) {
    calm();
    const std::vector<std::string> line = {"--quick", "--size", "48x27", "--technique", "sspr"};
    const auto measureTo = [&](const std::string& folder, std::vector<std::string> more) {
        more.insert(more.end(), {"-o", folder});
        more.insert(more.end(), line.begin(), line.end());
        const Outcome outcome = measure(more);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return measured(folder);
    };
    const json flat = measureTo("flat", {"scene.toml", "--flat"});
    const json calm = measureTo("calm", {"calm.toml"});
    const json wavy = measureTo("wavy", {"scene.toml"});
    EXPECT_EQ(flat["flat"], true);
    EXPECT_EQ(wavy["flat"], false);
    EXPECT_EQ(flat["entries"][0]["error"], calm["entries"][0]["error"]);
    EXPECT_NE(flat["entries"][0]["error"], wavy["entries"][0]["error"]);
    for (const json& pass : flat["entries"][0]["cost"]["passes"]) EXPECT_NE(pass["name"], "waves_upload");
}

TEST_F(Measure, AnInterruptionLeavesWhatIsFinished) {
    calm();
    const Outcome outcome = measure({"calm.toml", "-o", "part", "--size", "64x36"}, path("part/index.html"));
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("interrupted: 1 of 2 views"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(path("part/index.html").string()), std::string::npos) << outcome.err;
    EXPECT_EQ(measured("part")["entries"].size(), 3u);
    EXPECT_EQ(tests::countLines(tests::readAll(path("part/tradeoff.csv"))), 4u);
    EXPECT_EQ(tests::namesIn(path("part")),
              (std::vector<std::string>{"1_calm_level.png", "1_calm_level.svg", "index.html", "tradeoff.csv",
                                        "tradeoff.json"}));
}

TEST_F(Measure, TwoRunsFindTheSameErrors) {
    const auto errors = [&](const std::string& folder) {
        const Outcome outcome = measure({"scene.toml", "-o", folder, "--quick", "--size", "64x36"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        json found = json::array();
        for (const json& entry : measured(folder)["entries"]) found.push_back(entry["error"]);
        return found;
    };
    EXPECT_EQ(errors("one"), errors("two"));
}

TEST(Pareto, KeepsWhatNothingBeats) {
    using demos::measure::paretoFront;
    EXPECT_EQ(paretoFront({{0, 3}, {1, 2}, {2, 2}, {3, 1}, {0, 4}}),
              (std::vector<bool>{true, true, false, true, false}));
    EXPECT_EQ(paretoFront({{1, 1}, {1, 1}}), (std::vector<bool>{true, true})) << "equals do not beat";
}

TEST(PictureErrors, CountWhatEachClassOfTruthAllows) {
    // One row of pixels; the last is no water and wholly wrong.
    const std::vector<TruthClass> kinds = {TruthClass::recoverable, TruthClass::recoverable,
                                           TruthClass::offScreen,   TruthClass::sky,
                                           TruthClass::sky,         TruthClass::none};
    const std::string claims = "hshs?h";
    const auto count = static_cast<uint32_t>(kinds.size());
    demos::Picture truth{count, 1, std::vector<float>(count * 4)};
    demos::Picture classes = truth;
    for (size_t i = 0; i < count; ++i) {
        truth.rgba[4 * i] = static_cast<float>(kinds[i]);
        classes.rgba[4 * i + 1] = claims[i] == 'h' ? 1 : 0;
        classes.rgba[4 * i + 2] = claims[i] == 's' ? 1 : 0;
    }
    std::swap(classes.rgba[4 * 3 + 1], classes.rgba[4 * 3 + 2]); // a hit where the sky is mirrored
    const std::vector<uint8_t> reference(count * 3, 100);
    std::vector<uint8_t> test = reference;
    test[0] = 151; // by a fifth of white
    test[count * 3 - 1] = 255;
    const PictureError error = demos::measure::errorOf({reference, test, &truth, &classes}, Answers::classes);
    EXPECT_DOUBLE_EQ(error.coverage.value(), 0.5);
    EXPECT_DOUBLE_EQ(error.falseSkyHits.value(), 0.5);
    EXPECT_DOUBLE_EQ(error.skyOnGeometry.value(), 1.0 / 3);
    EXPECT_DOUBLE_EQ(error.wrongShare.value(), 0.2);
    EXPECT_NEAR(error.psnrDb.value(), 10 * std::log10(15 / (0.2 * 0.2)), 1e-4);
    EXPECT_LT(error.psnrPictureDb.value(), error.psnrDb.value());
    EXPECT_GT(error.flip.value(), 0);

    const PictureError sky = demos::measure::errorOf({reference, test, &truth, nullptr}, Answers::sky);
    EXPECT_EQ(sky.coverage, 0);
    EXPECT_EQ(sky.falseSkyHits, 0);
    EXPECT_EQ(sky.skyOnGeometry, 1);

    EXPECT_FALSE(demos::measure::errorOf({reference, reference, &truth, &classes}, Answers::classes).psnrDb)
        << "infinite is no number";
    for (size_t i = 0; i < count; ++i) truth.rgba[4 * i] = 0;
    const PictureError dry = demos::measure::errorOf({reference, test, &truth, &classes}, Answers::classes);
    EXPECT_FALSE(dry.flip || dry.psnrDb || dry.coverage || dry.wrongShare) << "shares of nothing";
}

} // namespace
