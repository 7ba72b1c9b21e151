// Flat water, and a floor, mirror in the reference what the host draws from behind the mirror: two ways to
// one truth that share neither matrices nor rays.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host/passes/supersample.h"
#include "metrics/psnr.h"
#include "scene/without.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;
using reference::TruthClass;

/// Samples a pixel, each way. Through the middle alone, one pixel in 400 falls to the other side of an edge:
/// devices round vertices to 1/256 of a pixel.
constexpr uint32_t samples = 3;
constexpr uint32_t width = 256, height = 144;

struct Mirrored {
    Picture host, reference;
    std::vector<bool> solid; ///< whether all samples mirror something other than the sky
};

std::vector<bool> solidPixels(const Picture& truth) {
    std::vector<bool> solid(size_t{width} * height, true);
    for (size_t i = 0; i < truth.rgba.size() / 4; ++i) {
        const auto kind = static_cast<TruthClass>(std::lround(truth.rgba[4 * i]));
        if (kind == TruthClass::none || kind == TruthClass::sky)
            solid[i / truth.width / samples * width + i % truth.width / samples] = false;
    }
    return solid;
}

bool mirror(const Scene& scene, const CameraDesc& camera, Mirrored& out, Error& error) {
    const std::unique_ptr<Host> host = Host::create({}, error);
    if (!host || !host->load(scene, error)) return false;
    const FrameDesc frameDesc{width * samples, height * samples, camera, scene.timeS, Aov::reflection, 0};
    const std::optional<Picture> drawn = host->render(frameDesc, error);
    if (!drawn) return false;
    const reference::Pictures traced =
        tests::traced(scene, {frameDesc.width, frameDesc.height, camera, scene.timeS}, true);
    out = {averaged(*drawn, samples), averaged(traced.mirrored, samples), solidPixels(traced.truth)};
    return true;
}

double psnr(const Mirrored& mirrored, double exposureEv, size_t& count) {
    const std::vector<uint8_t> a = toneMap(mirrored.host, exposureEv),
                               b = toneMap(mirrored.reference, exposureEv);
    double squares = 0;
    count = 0;
    for (size_t i = 0; i < mirrored.solid.size(); ++i) {
        if (!mirrored.solid[i]) continue;
        ++count;
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) squares += std::pow(int{a[c]} - int{b[c]}, 2);
    }
    return psnrDb(squares / (3 * static_cast<double>(count)), 255);
}

class Planar : public testing::TestWithParam<std::string> {};

TEST_P(Planar, MirrorsWhatTheReferenceMirrors) {
    Error error;
    // Without the sun: its shadows are filtered maps here and rays there, which leaves 34 dB, mirrored or
    // not.
    const std::string surface = GetParam() == "floor" ? "floor" : "water";
    std::optional<Scene> scene =
        loadScene(tests::demoScene(GetParam()),
                  {surface + ".reflection.technique=planar", "sun.irradiance=[0,0,0]"}, error);
    ASSERT_TRUE(scene) << error.text;
    if (scene->water) takeWaves(*scene->water);
    for (const CameraDesc& camera : scene->cameras) {
        // From the air, and each once.
        if (camera.name == "below" || camera.name == "straddle" || camera.name == "far") continue;
        Mirrored mirrored;
        ASSERT_TRUE(mirror(*scene, camera, mirrored, error)) << error.text;
        size_t count = 0;
        const double db = psnr(mirrored, scene->exposureEv, count);
        RecordProperty(camera.name + "_db", std::to_string(db));
        EXPECT_GT(count, 1500u) << camera.name;
        EXPECT_GE(db, 45) << camera.name;
    }
}

INSTANTIATE_TEST_SUITE_P(, Planar, testing::Values("harbour", "floor"),
                         [](const testing::TestParamInfo<std::string>& info) { return info.param; });

} // namespace
