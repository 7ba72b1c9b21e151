// Waves whose normals are the wrong way round are seen by what measures pictures, and not by a hair.
#include <gtest/gtest.h>

#include "host/water/waves.h"
#include "measure/picture_error.h"
#include "seaglass/sea.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/traced_picture.h"
#include "water/interface/waves_backend.h"

namespace {

using namespace demos;

constexpr uint32_t width = 256, height = 144;
constexpr size_t waveSamples = 64;

/// The program's own waves with slopes turned about.
const seaglass::WavesBackend* flippedWaves() {
    static const seaglass::WavesBackend flipped = {
        "flipped", wavesBackend()->create, wavesBackend()->destroy,
        [](void* state, uint32_t cascade, double time, const seaglass::CascadeMaps& out) {
            wavesBackend()->evaluate(state, cascade, time, out);
            for (size_t i = 0; i < waveSamples * waveSamples * 4; i += 4) {
                out.derivatives[i] *= -1;
                out.derivatives[i + 1] *= -1;
            }
        }};
    return &flipped;
}

std::optional<measure::PictureError> errorWith(const seaglass::WavesBackend* waves, const Scene& scene,
                                               const reference::Pictures& truth, Error& error) {
    HostDesc desc;
    desc.wavesBackend = waves;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    if (!host || !host->load(scene, error)) return std::nullopt;
    measure::Shots shots;
    const FrameDesc frame{width, height, scene.cameras.front(), scene.timeS, Aov::color, 0};
    if (!takeShots(*host, frame, shots, error)) return std::nullopt;
    return errorOf(truth, shots, scene.exposureEv, error);
}

TEST(Normals, FlippedOnesAreMeasured) {
    Error error;
    const std::optional<Scene> scene = loadScene(
        tests::demoScene("harbour"), {"water.waves.samples=64", "water.waves.amplitude=0.5"}, error);
    ASSERT_TRUE(scene) << error.text;
    // Of many samples: the picture spreads what each pixel mirrors, which one ray does not.
    const reference::Pictures truth =
        tests::traced(*scene, {width, height, scene->cameras.front(), scene->timeS, 16}, true);
    const auto sound = errorWith(nullptr, *scene, truth, error);
    const auto flipped = errorWith(flippedWaves(), *scene, truth, error);
    ASSERT_TRUE(sound && flipped) << error.text;
    std::printf("FLIP %.3f -> %.3f, position p50 %.2f -> %.2f px, surface %.2f -> %.2f dB\n", *sound->flip,
                *flipped->flip, *sound->positionPxP50, *flipped->positionPxP50, *sound->psnrSurfaceDb,
                *flipped->psnrSurfaceDb);
    EXPECT_GT(*flipped->positionPxP50, 2 * *sound->positionPxP50);
    EXPECT_LT(*flipped->psnrSurfaceDb, *sound->psnrSurfaceDb - 0.5);
    EXPECT_GT(*flipped->flip, *sound->flip);
}

} // namespace
