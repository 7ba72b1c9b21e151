// Bad input: one line that says what, where and what was expected, exit code 2, nothing left behind.
#include <gtest/gtest.h>

#include <unistd.h>

#include "program/program.h"
#include "tests/program/refused.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;

struct BadInput {
    std::string name;
    std::vector<std::string> arguments; ///< run in the sample's folder
    std::vector<std::string> says;      ///< each is in the line
};

void PrintTo(const BadInput& bad, std::ostream* out) {
    *out << bad.name;
}

std::vector<std::string> render(const std::vector<std::string>& more,
                                const std::string& scene = "scene.toml") {
    std::vector<std::string> arguments = {"render", scene, "-o", "out/a.png", "--size", "32x18"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::string nineOf(const std::string& element) {
    std::string all = element;
    for (int i = 1; i < 9; ++i) all += ", " + element;
    return all;
}

std::vector<BadInput> commandLines() {
    return {
        {"NoCommand", {}, {"expected seaglass render"}},
        {"UnknownCommand", {"rendr"}, {"rendr", "nearest is render"}},
        {"NoScene", {"render"}, {"no scene", "SCENE.toml"}},
        {"NoOutput", {"render", "scene.toml"}, {"no output", "-o"}},
        {"UnknownOption", render({"--sise", "3x3"}), {"--sise", "nearest is --size"}},
        {"ExtraWord", render({"more"}), {"'more'"}},
        {"OptionWithoutValue", render({"--camera"}), {"--camera"}},
        {"DevicesWithMore", {"devices", "all"}, {"'all'"}},
        {"SizeZero", render({"--size", "0x10"}), {"--size is '0x10'", "1 to 16384"}},
        {"SizeHuge", render({"--size", "16385x1"}), {"--size is '16385x1'", "1 to 16384"}},
        {"SizeOverflow", render({"--size", "99999999999x10"}), {"--size is '99999999999x10'"}},
        {"SizeNegative", render({"--size", "-5x10"}), {"--size is '-5x10'"}},
        {"SizeHalf", render({"--size", "10x"}), {"--size is '10x'", "WIDTHxHEIGHT"}},
        {"SizeNoNumber", render({"--size", "big"}), {"--size is 'big'"}},
        {"SupersampleZero", render({"--supersample", "0"}), {"--supersample is '0'", "1 to 4"}},
        {"SupersampleHuge",
         render({"--size", "8000x10", "--supersample", "3"}),
         {"--supersample is '3'", "16384"}},
        {"SupersampledClasses", render({"--supersample", "2", "--aov", "class"}), {"--supersample", "color"}},
        {"TimeNan", render({"--time", "nan"}), {"--time is 'nan'", "seconds"}},
        {"TimeNoNumber", render({"--time", "1s"}), {"--time is '1s'"}},
        {"FramesZero", render({"--frames", "0"}), {"--frames is '0'", "1 to 100000"}},
        {"FpsZero", render({"--frames", "2", "--fps", "0"}), {"--fps is '0'"}},
        {"FpsAlone", render({"--fps", "24"}), {"--fps", "--frames"}},
        {"UnknownAov", render({"--aov", "hight"}), {"--aov is 'hight'", "nearest is height"}},
        {"UnknownMistake", render({"--mistake", "typo"}), {"--mistake is 'typo'", "flipped_y"}},
        {"UnknownCamera", render({"--camera", "lo"}), {"--camera is 'lo'", "level, low", "nearest is low"}},
        {"UnknownQuality",
         render({"--quality", "hihg"}),
         {"--quality is 'hihg'", "low, medium, high or highest", "nearest is high"}},
        {"QualityOfAFloor", render({"--quality", "low"}, "floor.toml"), {"--quality low", "has no [water]"}},
        {"ReflectionSamplesAreThree",
         render({"--set", "water.reflection_samples=3"}),
         {"--set water.reflection_samples=3:", "a power of two, 1 to 4"}},
        {"FresnelIsUnknown",
         render({"--set", "water.fresnel=shlick"}),
         {"--set water.fresnel=shlick: water.fresnel is 'shlick'", "expected exact or schlick"}},
        {"BothValidations", render({"--validation", "--no-validation"}), {"--validation"}},
        {"SetWithoutValue", render({"--set", "time_s"}), {"--set time_s", "path=value"}},
        {"FloatsAboveTheWater",
         render({"--set", "mesh.0.floats=true"}),
         {"scene.toml:14: mesh.0.file: ", "tetra.gltf: is to float", "expected a mesh that reaches"}},
        {"MeshHasTooManyVolumes",
         render(
             {"--set", "mesh.0.exclusion_volumes=[" + nineOf("{points_m = [[0, 0], [1, 0], [0, 1]]}") + "]"}),
         {"count is out of range, expected 0 to 8"}},
        {"VolumeIsNotConvex",
         render({"--set", "mesh.0.exclusion_volumes=[{points_m = [[0, 0], [1, 0]]}]"}),
         {"scene.toml:14: mesh.0.file: ", "mesh.exclusion_volumes.0.points_m are 2, expected 3 to 7"}},
        {"SetUnknownKey",
         render({"--set", "water.wave=1"}),
         {"--set water.wave=1", "nearest is water.waves"}},
        {"SetControlsTheTerminal", render({"--set", "\x1b[2J=1"}), {"--set ?[2J=1: ?[2J is not a known key"}},
        {"SetOutOfRange",
         render({"--set", "water.waves.wind_m_s=-3"}),
         {"--set water.waves.wind_m_s=-3:", "0 to 100"}},
    };
}

std::vector<BadInput> files() {
    return {
        {"MissingScene", render({}, "nope.toml"), {"nope.toml", "no such file"}},
        {"SceneIsFolder", render({}, "out"), {"out", "is a folder"}},
        {"TruncatedScene", render({}, "truncated.toml"), {"truncated.toml:37:", "not valid TOML"}},
        {"UnknownKey",
         render({}, "unknown.toml"),
         {"unknown.toml:22: water.waves.wind_ms", "nearest is water.waves.wind_m_s"}},
        {"OutOfRange",
         render({}, "range.toml"),
         {"range.toml:22: water.waves.wind_m_s is -3", "expected 0 to 100 m/s"}},
        {"FresnelOfAnotherName",
         render({}, "fresnel.toml"),
         {"fresnel.toml:20: water.fresnel is 'shlick'", "expected exact or schlick"}},
        {"FloorOutOfRange",
         render({}, "floor_range.toml"),
         {"floor_range.toml:21: floor.roughness is 1.5", "expected 0 to 1"}},
        {"FloorUnknownKey",
         render({}, "floor_key.toml"),
         {"floor_key.toml:20: floor.with_m", "nearest is floor.width_m"}},
        {"FloorWithoutDirection",
         render({}, "floor_normal.toml"),
         {"floor_normal.toml:19: floor.normal has no length", "expected a direction"}},
        {"FloorTechniqueUnknown",
         render({}, "floor_technique.toml"),
         {"floor_technique.toml:24: floor.reflection.technique is 'srr'", "expected sky, sspr, ssr"}},
        {"FloorAndWater", render({"--set", "floor.width_m=3"}), {"floor is set, expected no [water]"}},
        {"FloorTextureMissing",
         render({"--set", "floor.texture=nope.png"}, "floor.toml"),
         {"--set floor.texture=nope.png:", "floor.texture", "expected a PNG file", "no such file"}},
        {"FloorTextureIsBroken",
         render({"--set", "floor.texture=broken.exr"}, "floor.toml"),
         {"--set floor.texture=broken.exr: floor.texture:", "broken.exr"}},
        {"SkyMissing", render({"--sky", "nope.exr"}), {"--sky nope.exr", "no such file", "HDR or EXR"}},
        {"SkyIsFolder", render({"--sky", "out"}), {"--sky out", "is a folder"}},
        {"SkyIsNoPicture", render({"--sky", "scene.toml"}), {"--sky", "scene.toml"}},
        {"SkyIsBrokenExr", render({"--sky", "broken.exr"}), {"--sky", "broken.exr"}},
        {"SkyIsTruncatedHdr", render({"--sky", "truncated.hdr"}), {"--sky", "truncated.hdr"}},
        {"SkyOfSceneIsBroken",
         render({"--set", "sky.file=broken.exr"}),
         {"--set sky.file=broken.exr", "sky.file"}},
        {"SkyInSceneIsBroken", render({}, "broken_sky.toml"), {"broken_sky.toml:6: sky.file", "broken.exr"}},
        {"MeshMissing", render({"--mesh", "nope.glb"}), {"--mesh nope.glb", "no such file", "glTF"}},
        {"MeshIsTruncated", render({"--mesh", "truncated.gltf"}), {"--mesh", "truncated.gltf"}},
        {"MeshIsNoGlb", render({"--mesh", "broken.glb"}), {"--mesh", "broken.glb"}},
        {"MeshInSceneIsBroken",
         render({}, "broken_mesh.toml"),
         {"broken_mesh.toml:14: mesh.0.file", "broken.glb"}},
        {"OutputUnknownExtension",
         {"render", "scene.toml", "-o", "out/a.jpg"},
         {"-o out/a.jpg", "'.jpg'", ".png or .exr"}},
        {"OutputNameIsLong",
         {"render", "scene.toml", "-o", "out/" + std::string(197, 'x') + ".png"},
         {"over 200 bytes in its name"}},
        {"CameraNameIsLong", render({"--camera", std::string(50000, 'x')}), {"--camera is 'xxx", "..."}},
        {"OutputNoExtension", {"render", "scene.toml", "-o", "out/a"}, {"-o out/a", ".png or .exr"}},
        {"OutputFolderMissing",
         {"render", "scene.toml", "-o", "nope/a.png"},
         {"-o nope/a.png", "folder nope"}},
        {"OutputFolderIsFile",
         {"render", "scene.toml", "-o", "sky.hdr/a.png"},
         {"-o sky.hdr/a.png", "not a folder"}},
        {"OutputIsFolder", {"render", "scene.toml", "-o", "folder.png"}, {"-o folder.png", "is a folder"}},
        {"OutputIsInput",
         {"render", "scene.toml", "-o", "broken.exr", "--sky", "broken.exr"},
         {"-o broken.exr", "read"}},
        {"StatsUnknownExtension", render({"--stats", "out/a.txt"}), {"--stats out/a.txt", ".json"}},
        {"StatsFolderMissing", render({"--stats", "nope/a.json"}), {"--stats nope/a.json", "folder nope"}},
        {"WordIsEmpty", render({"--camera", ""}), {"the word after --camera is empty", "expected a value"}},
        {"ValueIsEmpty", render({"--camera="}), {"--camera= is empty", "expected a value"}},
        {"UnknownDevice", render({"--device", "no such device"}), {"no such device"}},
    };
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    return text.replace(text.find(what), what.size(), with);
}

class BadInputTest : public testing::TestWithParam<BadInput> {
  protected:
    BadInputTest() {
        using tests::writeAll;
        const fs::path& at = folder_.path();
        const std::string scene = tests::sampleScene();
        tests::writeSample(at);
        fs::create_directory(at / "folder.png");
        writeAll(at / "truncated.toml", scene.substr(0, scene.find("position_m = [0, 2, 4]") + 16));
        writeAll(at / "unknown.toml", replaced(scene, "wind_m_s = 6", "wind_ms = 6"));
        writeAll(at / "range.toml", replaced(scene, "wind_m_s = 6", "wind_m_s = -3"));
        writeAll(at / "fresnel.toml", replaced(scene, "level = 128", "level = 128\nfresnel = \"shlick\""));
        const std::string floor = tests::sampleFloorScene();
        writeAll(at / "floor.toml", floor);
        writeAll(at / "floor_range.toml", replaced(floor, "roughness = 0.25", "roughness = 1.5"));
        writeAll(at / "floor_key.toml", replaced(floor, "width_m = 10", "with_m = 10"));
        writeAll(at / "floor_normal.toml", replaced(floor, "normal = [0, 1, 0]", "normal = [0, 0, 0]"));
        writeAll(at / "floor_technique.toml", replaced(floor, "\"sspr\"", "\"srr\""));
        writeAll(at / "broken_sky.toml", replaced(scene, "sky.hdr", "broken.exr"));
        writeAll(at / "broken_mesh.toml", replaced(scene, "tetra.gltf", "broken.glb"));
        writeAll(at / "broken.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0channels", 16));
        writeAll(at / "broken.glb", std::string("glTF\x02\0\0\0\xff\xff\0\0", 12));
        writeAll(at / "truncated.gltf", tests::sampleMesh().substr(0, 300));
        writeAll(at / "truncated.hdr", tests::sampleSky().substr(0, 100));
    }

    tests::TemporaryFolder folder_;
};

TEST_P(BadInputTest, SaysSoOnOneLineAndLeavesNothing) {
    const std::vector<std::string> before = tests::namesIn(folder_.path());
    const Outcome outcome = tests::run(demos::runProgram, {GetParam().arguments, {}, folder_.path()});
    tests::expectRefused(outcome, GetParam().says);
    EXPECT_EQ(tests::namesIn(folder_.path()), before);
    EXPECT_TRUE(tests::namesIn(folder_.path() / "out").empty());
}

const auto nameOf = [](const testing::TestParamInfo<BadInput>& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(CommandLine, BadInputTest, testing::ValuesIn(commandLines()), nameOf);
INSTANTIATE_TEST_SUITE_P(Files, BadInputTest, testing::ValuesIn(files()), nameOf);

TEST(BadOutput, AFolderThatCannotBeWrittenToIsRefused) {
    if (geteuid() == 0) GTEST_SKIP() << "root writes anywhere";
    const tests::TemporaryFolder folder;
    tests::writeSample(folder.path());
    fs::permissions(folder.path() / "out", fs::perms::owner_read | fs::perms::owner_exec);
    const Outcome outcome = tests::run(demos::runProgram, {render({}), {}, folder.path()});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("cannot be written to"), std::string::npos) << outcome.err;
    fs::permissions(folder.path() / "out", fs::perms::owner_all);
}

/// A machine whose Vulkan loader finds no driver.
const std::map<std::string, std::string> noDriver = {{"VK_DRIVER_FILES", "/nonexistent/none.json"},
                                                     {"VK_ICD_FILENAMES", "/nonexistent/none.json"}};

TEST(NoVulkanDevice, DevicesSaysSo) {
    const Outcome outcome = tests::run(demos::runProgram, {{"devices"}, noDriver});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("expected a Vulkan 1.3 device"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

TEST(NoVulkanDevice, RenderSaysSoAndWritesNothing) {
    const tests::TemporaryFolder folder;
    tests::writeSample(folder.path());
    const Outcome outcome =
        tests::run(demos::runProgram, {render({"--no-validation"}), noDriver, folder.path()});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("expected a Vulkan 1.3 device"), std::string::npos) << outcome.err;
    EXPECT_TRUE(tests::namesIn(folder.path() / "out").empty());
}

} // namespace
