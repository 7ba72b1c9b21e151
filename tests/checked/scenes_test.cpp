// No shader of the library or the sample host does what Vulkan leaves open while the demo scenes are drawn.
#include <regex>

#include <gtest/gtest.h>

#include "demos/tools/scene/scene.h"
#include "tests/program/demo_scenes.h"
#include "tests/program/run.h"

namespace {

struct Shot {
    std::string scene;
    std::string camera;  ///< empty: the first
    std::string quality; ///< empty: as the scene has it
    std::vector<std::string> overrides = {};

    std::string name() const {
        std::string all = scene + "_" + (camera.empty() ? "first" : camera);
        if (!quality.empty()) all += "_" + quality;
        for (const std::string& value : overrides) all += "_" + value.substr(value.rfind('.') + 1);
        return std::regex_replace(all, std::regex("[^A-Za-z0-9_]"), "_");
    }
};

void PrintTo(const Shot& shot, std::ostream* out) {
    *out << shot.name();
}

demos::Scene loaded(const std::filesystem::path& file) {
    demos::Error error;
    const std::optional<demos::Scene> scene = demos::loadScene(file, {}, error);
    if (!scene) throw std::runtime_error(error.text);
    return *scene;
}

std::vector<Shot> everyCamera() {
    std::vector<Shot> shots;
    for (const std::filesystem::path& file : tests::demoScenes()) {
        const demos::Scene scene = loaded(file);
        std::vector<std::string> qualities = {""};
        if (scene.water) qualities = {"low", "medium", "high", "highest"};
        for (const demos::CameraDesc& camera : scene.cameras)
            for (const std::string& quality : qualities)
                shots.push_back({file.stem().string(), camera.name, quality});
    }
    return shots;
}

std::vector<Shot> everyTechnique() {
    std::vector<Shot> shots;
    for (const std::filesystem::path& file : tests::demoScenes()) {
        const std::string reflection = loaded(file).water ? "water.reflection." : "floor.reflection.";
        for (const char* const technique : {"sspr", "ssr", "hybrid", "planar"})
            for (const char* const cells : {"false", "true"})
                shots.push_back({file.stem().string(),
                                 "",
                                 "",
                                 {reflection + "temporal=0.9", reflection + "march_cells=" + cells,
                                  reflection + "technique=" + technique}});
    }
    return shots;
}

class CheckedScene : public testing::TestWithParam<Shot> {};

TEST_P(CheckedScene, HasNoViolations) {
    const Shot& shot = GetParam();
    const tests::TemporaryFolder folder;
    const std::filesystem::path report = folder.path() / "report";
    // A later frame finds a history.
    std::vector<std::string> arguments = {
        "render", tests::demoScene(shot.scene).string(),   "--size", "160x90", "--frames", "2", "--plain",
        "-o",     (folder.path() / "frame%d.png").string()};
    if (!shot.camera.empty()) arguments.insert(arguments.end(), {"--camera", shot.camera});
    if (!shot.quality.empty()) arguments.insert(arguments.end(), {"--quality", shot.quality});
    for (const std::string& value : shot.overrides) arguments.insert(arguments.end(), {"--set", value});
    const tests::Outcome outcome =
        tests::run(SEAGLASS_PROGRAM, {arguments,
                                      {{"VK_ADD_LAYER_PATH", SEAGLASS_LAYERS},
                                       {"VK_INSTANCE_LAYERS", "VK_LAYER_SEAGLASS_checked_shaders"},
                                       {"SEAGLASS_VIOLATIONS", report.string()}}});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string noted = tests::readAll(report);
    EXPECT_TRUE(std::regex_match(
        noted,
        std::regex("checked [1-9]\\d* shaders in [1-9]\\d* places: 0 violated; left 0 shaders alone\n")))
        << noted;
}

std::string nameOf(const testing::TestParamInfo<Shot>& info) {
    return info.param.name();
}
INSTANTIATE_TEST_SUITE_P(FirstCamera, CheckedScene, testing::Values(Shot{"harbour", "", "highest"}), nameOf);
INSTANTIATE_TEST_SUITE_P(EveryCamera, CheckedScene, testing::ValuesIn(everyCamera()), nameOf);
INSTANTIATE_TEST_SUITE_P(EveryTechnique, CheckedScene, testing::ValuesIn(everyTechnique()), nameOf);

} // namespace
