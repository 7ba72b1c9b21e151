// Keyframes: splines in closed form, and what a scene file may say of them.
#include "demos/tools/scene/motion/motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "demos/tools/scene/offset.h"
#include "demos/tools/scene/random_camera.h"
#include "demos/tools/scene/save.h"
#include "demos/tools/scene/scene.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

using demos::CameraDesc;
using demos::MeshDesc;
using demos::Scene;
using demos::Vec3;

MeshDesc boat(bool loops) {
    MeshDesc mesh;
    mesh.positionM = {0, 1, 0};
    mesh.yawDeg = 170;
    mesh.keyframes = {{2, {6, 1, 0}, -170}, {5, {6, 1, 9}, -100}};
    if (loops) mesh.keyframes.push_back({9, {0, 1, 0}, 170});
    mesh.loops = loops;
    return mesh;
}

double farthest(const Vec3& a, const Vec3& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

double apart(double a, double b) {
    return std::abs(std::remainder(a - b, 360));
}

TEST(Keyframes, AreWhereTheySay) {
    for (const bool loops : {false, true}) {
        const MeshDesc mesh = boat(loops);
        for (const demos::MeshKeyframe& keyframe : mesh.keyframes) {
            const MeshDesc now = meshAt(mesh, keyframe.timeS);
            EXPECT_LT(farthest(now.positionM, keyframe.positionM), 1e-12) << keyframe.timeS;
            EXPECT_LT(apart(now.yawDeg, keyframe.yawDeg), 1e-12) << keyframe.timeS;
            EXPECT_TRUE(now.keyframes.empty());
        }
        EXPECT_EQ(meshAt(mesh, 0).positionM, mesh.positionM);
    }
}

TEST(Keyframes, NothingJumpsInPlaceOrSpeed) {
    const double step = 1e-4;
    for (const bool loops : {false, true}) {
        const MeshDesc mesh = boat(loops);
        Vec3 speedBefore{};
        for (double t = -3; t < 12; t += step) {
            const MeshDesc from = meshAt(mesh, t), to = meshAt(mesh, t + step);
            Vec3 speed;
            for (size_t i = 0; i < 3; ++i) speed[i] = (to.positionM[i] - from.positionM[i]) / step;
            // As fast as two of its ways at once, and no jerk that a boat does not have.
            EXPECT_LT(std::hypot(speed[0], speed[2]), 8) << t;
            EXPECT_LT(apart(to.yawDeg, from.yawDeg) / step, 80) << t;
            if (t > -3) {
                EXPECT_LT(farthest(speed, speedBefore) / step, 40) << t;
            }
            speedBefore = speed;
        }
    }
}

TEST(Keyframes, StandStillBeforeAndAfterOrLoop) {
    EXPECT_EQ(meshAt(boat(false), -7).positionM, (Vec3{0, 1, 0}));
    EXPECT_EQ(meshAt(boat(false), 70).positionM, (Vec3{6, 1, 9}));
    for (const double t : {0.5, 2.5, 8.5})
        for (const double rounds : {-18.0, 9.0, 900.0})
            EXPECT_LT(farthest(meshAt(boat(true), t).positionM, meshAt(boat(true), t + rounds).positionM),
                      1e-9);
}

TEST(Keyframes, TurnTheShortWay) {
    for (double t = 0; t <= 2; t += 0.125) EXPECT_LT(apart(meshAt(boat(false), t).yawDeg, 180), 10.001) << t;
}

TEST(Keyframes, GoStraightWhereTheyLieStraight) {
    CameraDesc camera;
    camera.positionM = {0, 2, 0};
    camera.targetM = {0, 2, -10};
    for (const double t : {1.0, 2.0, 4.0, 8.0})
        camera.keyframes.push_back({t, {3 * t, 2, 0}, {3 * t, 2, -10}, 0});
    for (double t = 1; t <= 4; t += 0.1) {
        EXPECT_NEAR(cameraAt(camera, t).positionM[0], 3 * t, 1e-12) << "its times are uneven";
        EXPECT_NEAR(cameraAt(camera, t).targetM[0], 3 * t, 1e-12);
    }
    camera.keyframes.clear();
    EXPECT_EQ(cameraAt(camera, 3), camera);
}

/// The sample with keyframes of its mesh and its last camera.
class Moving : public testing::Test {
  protected:
    Moving() { tests::writeSample(folder_.path()); }

    static std::string text(const std::string& ofMesh, const std::string& ofCamera) {
        std::string scene = tests::sampleScene();
        return scene.insert(scene.find("\n[water]"), "\n" + ofMesh) + ofCamera;
    }
    std::optional<Scene> load(const std::string& scene) {
        tests::writeAll(file(), scene);
        return demos::loadScene(file(), {}, error_);
    }
    /// The error, behind the file's name and line.
    std::string problem(const std::string& ofMesh, const std::string& ofCamera) {
        if (load(text(ofMesh, ofCamera))) return "";
        return error_.text.substr(error_.text.find(": ") + 2);
    }
    std::filesystem::path file() const { return folder_.path() / "scene.toml"; }

    const std::string mesh_ = "[[mesh.keyframes]]\ntime_s = 3\nposition_m = [4, 0, 0]\nyaw_deg = 20\n";
    const std::string camera_ =
        "[[camera.keyframes]]\ntime_s = 5\nposition_m = [9, 1, 4]\ntarget_m = [9, 1, -5]\n";
    tests::TemporaryFolder folder_;
    demos::Error error_;
};

TEST_F(Moving, IsReadMovedAndSaved) {
    std::optional<Scene> scene = load(text(mesh_, camera_));
    ASSERT_TRUE(scene) << error_.text;
    ASSERT_EQ(scene->meshes[0].keyframes.size(), 1u);
    EXPECT_EQ(scene->meshes[0].keyframes[0].yawDeg, 20);
    ASSERT_EQ(scene->cameras[1].keyframes.size(), 1u);
    EXPECT_EQ(load(sceneText(*scene, folder_.path()))->cameras, scene->cameras);
    EXPECT_EQ(load(sceneText(*scene, folder_.path()))->meshes[0].keyframes[0].positionM, (Vec3{4, 0, 0}));

    const auto seen = [&](const CameraDesc& camera) {
        const Vec3 eye = cameraAt(camera, 2).positionM, mesh = meshAt(scene->meshes[0], 2).positionM;
        return Vec3{mesh[0] - eye[0], mesh[1] - eye[1], mesh[2] - eye[2]};
    };
    CameraDesc camera = scene->cameras[1];
    const Vec3 before = seen(camera);
    camera.offsetM = {1000, 5, -300};
    applyOffset(*scene, camera);
    EXPECT_LT(farthest(seen(camera), before), 1e-9) << "all keyframes are moved along";
    for (uint32_t i = 0; i < 8; ++i)
        EXPECT_TRUE(randomCamera(*scene, i).keyframes.empty()) << "nobody chose its path";
}

TEST_F(Moving, IsOneLineWhereItIsWrong) {
    const std::string elsewhere =
        "[[camera.keyframes]]\ntime_s = 9\nposition_m = [0, 1, 4]\ntarget_m = [0, 2, -5]\n";
    EXPECT_EQ(problem("loops = true\n", ""), "mesh.0.loops is true, expected keyframes to go through");
    EXPECT_EQ(problem(mesh_ + mesh_, ""),
              "mesh.0.keyframes.1.time_s is 3, expected a later time than that of "
              "mesh.0.keyframes.0");
    EXPECT_EQ(problem("", "loops = true\n" + camera_ + elsewhere),
              "camera.1.keyframes.1 is elsewhere than camera.1 begins, expected the same pose: "
              "camera.1.loops is true");
    EXPECT_EQ(problem("[[mesh.keyframes]]\ntime_s = 0\n", ""),
              "mesh.0.keyframes.0.time_s is 0, expected more than 0, up to 1e+06 s");
    EXPECT_EQ(problem("[[mesh.keyframes]]\ntime_s = nan\n", ""),
              "mesh.0.keyframes.0.time_s is nan, expected more than 0, up to 1e+06 s");
    EXPECT_EQ(problem("[[mesh.keyframes]]\ntime_s = 1\nposition_m = [0, 0, 0]\n", ""),
              "mesh.0.keyframes.0.yaw_deg is missing, expected -360 to 360 degrees");
    const std::string tilted = text("floats = true\n", "");
    const size_t at = tilted.find("level_m = 0");
    EXPECT_FALSE(load(std::string(tilted).insert(at, "tilt_deg = 4\n")));
    EXPECT_NE(error_.text.find("mesh.0.floats is true, expected [water], and water.tilt_deg of 0"),
              std::string::npos)
        << error_.text;
    EXPECT_EQ(problem("keyframes = 3\n", ""),
              "mesh.0.keyframes is 3, expected an array of tables: [[mesh.keyframes]]");
    EXPECT_EQ(problem("[[mesh.keyframes]]\ntime = 1\n", ""),
              "mesh.0.keyframes.0.time is not a known key, the nearest is mesh.keyframes.time_s");
}

} // namespace
