// The sea from the air: its tiles are not seen to repeat, by an autocorrelation of the picture.
#include <cstdio>

#include <gtest/gtest.h>

#include "demos/host/files/image_file.h"
#include "demos/tools/metrics/repetition/repetition.h"
#include "tests/program/run.h"

namespace {

/// Of the ocean straight down from a height, 512 x 512.
demos::Repetition repetitionFrom(double height, const std::vector<std::string>& options) {
    const tests::TemporaryFolder folder;
    const std::string file = folder.path() / "sea.png", eye = std::to_string(height);
    std::vector<std::string> command = {"render",
                                        SEAGLASS_SOURCE "/demos/scenes/ocean.toml",
                                        "--camera",
                                        "high",
                                        "--size",
                                        "512x512",
                                        "--device",
                                        "llvmpipe",
                                        "-o",
                                        file,
                                        "--plain",
                                        "--set",
                                        "camera.high.position_m=[0," + eye + ",0]",
                                        "--set",
                                        "camera.high.target_m=[0,0,-0.001]"};
    command.insert(command.end(), options.begin(), options.end());
    const tests::Outcome outcome = tests::run(SEAGLASS_PROGRAM, {command});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    demos::Error error;
    const auto picture = demos::readPicture(file, error);
    EXPECT_TRUE(picture) << error.text;
    if (!picture) return {1, 0, 0};
    const demos::Repetition found = demos::repetition({picture->width, picture->height, picture->rgba});
    std::printf("%6.0f m: %.3f at (%d, %d)\n", height, found.most, found.right, found.down);
    return found;
}

TEST(FromTheAir, NoTileIsSeenToRepeat) {
    EXPECT_LT(repetitionFrom(5000, {}).most, 0.05);
}

// Nightly. From lower down single whitecaps are longer than 20 pixels.
TEST(FromTheAirEverywhere, NoTileIsSeenToRepeat) {
    for (const char* wind : {"8", "10", "15", "25"})
        for (const double height : {1000.0, 2000.0, 3500.0, 5000.0, 10000.0}) {
            const std::string set = std::string("water.waves.wind_m_s=") + wind;
            std::printf("%s m/s, ", wind);
            EXPECT_LT(repetitionFrom(height, {"--set", set}).most, 0.1) << height << " m, " << wind << " m/s";
        }
}

// Nightly. What is like itself 18 m on is a single whitecap with its plume. A sea whose waves all lie on one
// tile, wider than the picture, repeats nowhere, and has whitecaps too.
TEST(FromTheAirEverywhere, WhitecapsAreLittleLargerThanOnOneTile) {
    double tiled = 0, untiled = 0;
    for (const char* seed : {"1", "2", "3", "4", "5"}) {
        std::vector<std::string> set = {"--set", std::string("water.waves.seed=") + seed};
        tiled += repetitionFrom(500, set).most / 5;
        for (const char* one : {"water.waves.cascades=1", "water.waves.largest_patch_m=1000",
                                "water.waves.samples=1024", "water.waves.warp=0"})
            set.insert(set.end(), {"--set", one});
        untiled += repetitionFrom(500, set).most / 5;
    }
    std::printf("from 500 m %.3f in the mean, %.3f where all waves lie on one tile\n", tiled, untiled);
    EXPECT_LT(tiled, 0.12);
}

} // namespace
