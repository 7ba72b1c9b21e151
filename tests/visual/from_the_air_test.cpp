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

} // namespace
