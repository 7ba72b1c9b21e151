// The boundary when an allocation fails: an error, and nothing left behind.
#include "tests/unit/sea/sea_support.h"
#include "tests/unit/sea/starved.h"

#include <gtest/gtest.h>

#include <cstring>

namespace {

using namespace seaglass;
using tests::Starved;

TEST(OutOfMemory, CreateSeaSaysSo) {
    const SeaDesc desc = tests::oneCascade();
    bool made = false;
    for (int allocations = 0; !made; ++allocations) {
        ASSERT_LT(allocations, 100);
        SeaError error;
        Sea* sea = nullptr;
        {
            const Starved starved(allocations);
            sea = createSea(&desc, &error);
        }
        made = sea != nullptr;
        EXPECT_EQ(made, std::strstr(error.text, "out of memory") == nullptr) << allocations;
        destroySea(sea);
    }
}

TEST(OutOfMemory, HeightGridReturnsNull) {
    const auto sea = tests::makeSea(tests::oneCascade());
    bool made = false;
    for (int allocations = 0; !made; ++allocations) {
        ASSERT_LT(allocations, 100);
        HeightGrid* grid = nullptr;
        {
            const Starved starved(allocations);
            grid = createHeightGrid(*sea, 1);
        }
        made = grid != nullptr;
        EXPECT_TRUE(made || allocations < 20);
        destroyHeightGrid(grid);
    }
}

TEST(OutOfMemory, HeightsAreCalmAndMarked) {
    const auto sea = tests::makeSea(tests::oneCascade());
    const double point[] = {1, 2};
    HeightSample sample;
    sample.height = 5;
    {
        const Starved starved(3);
        sampleHeights(*sea, 0, point, 1, &sample);
    }
    EXPECT_EQ(sample.height, 0);
    EXPECT_EQ(sample.folded, 1u);
}

} // namespace
