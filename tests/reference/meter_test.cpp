// The light meter: what it makes of even pictures, and of a sun's path.
#include <algorithm>
#include <cmath>
#include <cstdio>

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

} // namespace
