// Scenes that are saved are read back as they were.
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "demos/tools/scene/fields.h"
#include "demos/tools/scene/offset.h"
#include "demos/tools/scene/save.h"
#include "tests/program/demo_scenes.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using demos::Error;
using demos::Scene;

bool same(const auto* a, const auto* b) {
    return *a == *b;
}
bool same(const demos::Setting& a, const demos::Setting& b) {
    return a.field == b.field && a.get() == b.get();
}

/// Every field that a scene has, found through the table of fields alone.
void expectSame(Scene a, Scene b) {
    const std::function<size_t(const demos::Section&, void*, void*, const std::string&)> compare =
        [&](const demos::Section& section, void* one, void* other, const std::string& path) {
            size_t count = 0;
            for (const demos::Field& field : section.fields) {
                std::visit(
                    [&]<class T>(T value) {
                        EXPECT_TRUE(same(value, std::get<T>(field.target(other)))) << path << field.key;
                    },
                    field.target(one));
                ++count;
            }
            for (const demos::Child& child : section.children) {
                const std::vector<void*> ones = child.access.there(one), others = child.access.there(other);
                EXPECT_EQ(ones.size(), others.size()) << path << child.section->key;
                for (size_t i = 0; i < ones.size() && i < others.size(); ++i)
                    count += compare(*child.section, ones[i], others[i],
                                     path + std::string(child.section->key) + ".");
            }
            return count;
        };
    EXPECT_GT(compare(demos::sceneSection(), &a, &b, ""), 10u);
}

class Saved : public testing::Test {
  protected:
    Saved() { tests::writeSample(folder_.path()); }

    Scene loaded(const fs::path& file, const std::vector<std::string>& overrides = {}) {
        const std::optional<Scene> scene = demos::loadScene(file, overrides, error_);
        EXPECT_TRUE(scene) << error_.text;
        return scene.value_or(Scene{});
    }
    Scene throughAFile(const Scene& scene, const fs::path& file) {
        EXPECT_TRUE(demos::saveScene(scene, file, error_)) << error_.text;
        return loaded(file);
    }

    tests::TemporaryFolder folder_;
    Error error_;
};

TEST_F(Saved, EverySceneReadsBackAsItWas) {
    size_t scenes = 0;
    for (const std::filesystem::path& file : tests::demoScenes()) {
        SCOPED_TRACE(file.filename());
        const Scene scene = loaded(file);
        expectSame(scene, throughAFile(scene, folder_.path() / "out" / "saved.toml"));
        ++scenes;
    }
    EXPECT_GE(scenes, 7u);
}

TEST_F(Saved, SoDoesWhatWasSetByHand) {
    tests::writeAll(folder_.path() / "buoy.csv", "0.1,4\n0.2,1\n");
    const Scene scene =
        loaded(folder_.path() / "scene.toml",
               {"title=\"a \\\"b\\\" \\\\ c\\td\"", "time_s=-0.1", "exposure_ev=1e-7", "sun.from_sky=true",
                "water.waves.beaufort=7", "water.waves.seed=9007199254740993", "water.waves.spectrum=table",
                "water.waves.spectrum_table=buoy.csv", "water.waves.depth_m=12.3456789012345678",
                "water.waves.swells=[{height_m = 2}, {period_s = 9.5}]", "water.underwater.meniscus_m=0",
                "water.extent.shape=polygon", "water.extent.points_m=[[0, 0], [5.5, 1], [2, 6]]",
                "water.refraction.tint=[0.01, 0.2, 0.15]", "water.refraction.visibility_m=6.5",
                "camera.low.roll_deg=-12.5"});
    const Scene back = throughAFile(scene, folder_.path() / "out" / "saved.toml");
    expectSame(scene, back);
    EXPECT_EQ(back.title, "a \"b\" \\ c\td");
    EXPECT_EQ(back.water->waves->seed, 9007199254740993u);
    EXPECT_EQ(back.water->refraction->visibilityM, 6.5);
}

TEST_F(Saved, GlitterThatIsSaidToBeNoneIsWritten) {
    const std::filesystem::path scene = folder_.path() / "scene.toml", out = folder_.path() / "out.toml";
    EXPECT_FALSE(throughAFile(loaded(scene), out).water->saysGlitter);
    EXPECT_TRUE(throughAFile(loaded(scene, {"water.glitter=0"}), out).water->saysGlitter);
}

TEST_F(Saved, WaveShadowsThatAreSaidToBeNoneAreWritten) {
    const std::filesystem::path scene = folder_.path() / "scene.toml", out = folder_.path() / "out.toml";
    EXPECT_FALSE(throughAFile(loaded(scene), out).water->saysWaveShadows);
    EXPECT_TRUE(throughAFile(loaded(scene, {"water.wave_shadow_steps=0"}), out).water->saysWaveShadows);
}

// Under a low sun a gale drawn without is 25 % brighter in its shade than traced, and its sun path has no
// gaps.
TEST_F(Saved, WavesOfABreezeOnTheOpenSeaHideEachOther) {
    const std::filesystem::path scene = folder_.path() / "scene.toml";
    const auto steps = [&](const std::vector<std::string>& overrides) {
        Scene seen = loaded(scene, overrides);
        demos::addPhotographicDefaults(seen);
        return seen.water->shading.waveShadowSteps;
    };
    const std::string gale = "water.waves.beaufort=10", breeze = "water.waves.wind_m_s=8";
    EXPECT_EQ(steps({gale}), 8u);
    EXPECT_EQ(steps({breeze}), 8u);
    EXPECT_EQ(steps({gale, "water.wave_shadow_steps=0"}), 0u) << "what a scene says stands";
    EXPECT_EQ(steps({gale, "water.wave_shadow_steps=16"}), 16u);
    EXPECT_EQ(steps({"water.waves.beaufort=2"}), 0u);
    EXPECT_EQ(steps({"water.waves.wind_m_s=3"}), 0u);
    EXPECT_EQ(steps({breeze, "water.waves.amplitude=0.2"}), 0u) << "sheltered";
}

TEST_F(Saved, LeavesOutWhatIsTheDefaultAndNamesFilesFromWhereItIs) {
    Scene scene = loaded(folder_.path() / "scene.toml");
    scene.water->foam.reset();
    const std::string text = demos::sceneText(scene, folder_.path() / "out");
    EXPECT_NE(text.find("file = \"../sky.hdr\"\n"), std::string::npos) << text;
    EXPECT_NE(text.find("[water.waves]\nwind_m_s = 6\nsamples = 128\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("foam"), std::string::npos) << text;
    EXPECT_EQ(text.find("depth_m"), std::string::npos) << "deep water has no depth to write";
}

TEST_F(Saved, SaysWhereItCannotBeWritten) {
    EXPECT_FALSE(
        demos::saveScene(loaded(folder_.path() / "scene.toml"), folder_.path() / "none" / "a.toml", error_));
    EXPECT_NE(error_.text.find("a.toml: cannot be written"), std::string::npos) << error_.text;
}

TEST_F(Saved, CamerasSeeAMovedSceneAsBefore) {
    Scene scene = loaded(folder_.path() / "scene.toml", {"camera.low.offset_m=[100, 20, 3]"});
    Scene moved = scene;
    demos::CameraDesc camera = moved.cameras[1];
    demos::moveCameras(moved, camera.offsetM);
    demos::applyOffset(moved, camera);
    EXPECT_EQ(moved.cameras[1].positionM, camera.positionM);
    EXPECT_EQ(moved.cameras[1].offsetM, (demos::Vec3{}));
    // From the other one both are the same place.
    demos::CameraDesc level = moved.cameras[0];
    demos::applyOffset(moved, level);
    EXPECT_EQ(level.positionM, scene.cameras[0].positionM);
    EXPECT_EQ(moved.meshes[0].positionM, scene.meshes[0].positionM);
}

} // namespace
