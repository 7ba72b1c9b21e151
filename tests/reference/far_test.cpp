// A scene 100 km from the origin looks as it does there.
#include <cstdlib>

#include <gtest/gtest.h>

#include "host/host.h"
#include "scene/offset.h"
#include "scene/without.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 320, height = 180;

/// The harbour as its first camera sees it, moved by an offset; the water is flat, since waves are a function
/// of the place.
struct View {
    Scene scene;
    CameraDesc camera;
};

std::optional<View> calmHarbour(const Vec3& offset, Error& error) {
    std::optional<Scene> scene = loadScene(tests::demoScene("harbour"), {}, error);
    if (!scene) return std::nullopt;
    takeWaves(*scene->water);
    CameraDesc camera = scene->cameras.front();
    camera.offsetM = offset;
    applyOffset(*scene, camera);
    return View{*scene, camera};
}

std::optional<Picture> rendered(const View& view, Error& error) {
    const std::unique_ptr<Host> host = Host::create({}, error);
    if (!host || !host->load(view.scene, error)) return std::nullopt;
    return host->render({width, height, view.camera, view.scene.timeS, Aov::color}, error);
}

Picture traced(const View& view) {
    return tests::traced(view.scene, {width, height, view.camera}).color;
}

/// Share of pixels where any byte is off by more than one. A few stand on an edge.
double differing(const Picture& a, const Picture& b) {
    const std::vector<uint8_t> first = toneMap(a, 0), second = toneMap(b, 0);
    size_t count = 0;
    for (size_t i = 0; i < first.size(); i += 3) {
        bool off = false;
        for (size_t c = i; c < i + 3; ++c) off |= std::abs(int(first[c]) - int(second[c])) > 1;
        count += off ? 1 : 0;
    }
    return static_cast<double>(count) / (static_cast<double>(first.size()) / 3);
}

constexpr Vec3 far = {60e3, 500, 80e3};

TEST(Far, TheHostsPictureIsTheOneAtTheOrigin) {
    Error error;
    const std::optional<View> here = calmHarbour({0, 0, 0}, error), there = calmHarbour(far, error);
    ASSERT_TRUE(here && there) << error.text;
    const std::optional<Picture> a = rendered(*here, error), b = rendered(*there, error);
    ASSERT_TRUE(a && b) << error.text;
    EXPECT_LT(differing(*a, *b), 2e-4);
}

TEST(Far, TheReferencesPictureIsTheOneAtTheOrigin) {
    Error error;
    const std::optional<View> here = calmHarbour({0, 0, 0}, error), there = calmHarbour(far, error);
    ASSERT_TRUE(here && there) << error.text;
    EXPECT_LT(differing(traced(*here), traced(*there)), 2e-4);
}

} // namespace
