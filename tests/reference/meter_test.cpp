// The light meter: what it makes of even pictures, and of a sun's path.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

#include "host/lens/meter.h"

namespace {

using namespace demos;

/// Four hundred pixels of one luminance, some of them of another.
Picture twoTones(float most, float some, size_t count) {
    Picture picture{20, 20, std::vector<float>(size_t{4} * 400, most)};
    std::fill_n(picture.rgba.begin(), 4 * count, some);
    return picture;
}

// A sun's path over a tenth of the picture takes more stops than its share of the mean, so that it has tones.
TEST(Meter, SparesTheSunsPath) {
    const double dull = meteredEv(twoTones(0.22f, 0.22f, 0));
    EXPECT_NEAR(dull, 0, 1e-3);
    const double few = meteredEv(twoTones(0.22f, 22, 8)), path = meteredEv(twoTones(0.22f, 22, 40));
    std::printf("stops: %.2f even, %.2f with 2 %% at a hundred times the light, %.2f with 10 %%\n", dull, few,
                path);
    EXPECT_NEAR(few, -0.02 * std::log2(100), 0.01);
    EXPECT_LT(path, -0.1 * std::log2(100) - 0.5);
    EXPECT_EQ(meteredEv(twoTones(0, 0, 0)), 0);
}

TEST(Meter, WeighsColoursByTheLightThatEyesSee) {
    const auto of = [](float red, float green, float blue) {
        Picture picture{20, 20, {}};
        for (int i = 0; i < 400; ++i) picture.rgba.insert(picture.rgba.end(), {red, green, blue, 1});
        return meteredEv(picture);
    };
    EXPECT_NEAR(of(1, 0, 0), std::log2(0.22 / 0.2126), 1e-3);
    EXPECT_NEAR(of(0, 1, 0), std::log2(0.22 / 0.7152), 1e-3);
    EXPECT_NEAR(of(0, 0, 1), std::log2(0.22 / 0.0722), 1e-3);
}

TEST(Meter, PassesOverWhatIsNoLight) {
    const double even = meteredEv(twoTones(1, 1, 0));
    for (const float none :
         {0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
        EXPECT_NEAR(meteredEv(twoTones(1, none, 100)), even, 1e-9) << none;
}

} // namespace
