#include <gtest/gtest.h>

#include "demos/tools/scene/nearest.h"

namespace {

using demos::editDistance;
using demos::nearest;

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(editDistance("", ""), 0u);
    EXPECT_EQ(editDistance("", "abc"), 3u);
    EXPECT_EQ(editDistance("abc", ""), 3u);
    EXPECT_EQ(editDistance("wind", "wnd"), 1u);
    EXPECT_EQ(editDistance("wind", "winds"), 1u);
    EXPECT_EQ(editDistance("wind", "wand"), 1u);
    EXPECT_EQ(editDistance("wind", "wnid"), 1u);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(EditDistance, IsTheSameBothWaysAndIgnoresCase) {
    EXPECT_EQ(editDistance("fetch_m", "featch"), editDistance("featch", "fetch_m"));
    EXPECT_EQ(editDistance("Wind_M_S", "wind_m_s"), 0u);
}

TEST(EditDistance, CutsVeryLongWords) {
    EXPECT_EQ(editDistance(std::string(100000, 'a'), "a"), 63u);
}

TEST(Nearest, GivesTheFirstOfTheNearest) {
    EXPECT_EQ(nearest("widn", {"sky", "wind", "wand"}), "wind");
    EXPECT_EQ(nearest("xx", {"ab", "cd"}), "ab");
    EXPECT_EQ(nearest("xx", {}), "");
}

} // namespace
