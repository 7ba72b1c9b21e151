// What is left out of a comparison, by rectangles and masks.
#include <algorithm>
#include <limits>

#include "tests/program/screenshots/folders.h"

namespace {

using tests::expectSays;
using Regions = tests::Folders;

TEST_F(Regions, WhatIsLeftOutMayBeAnything) {
    write("ref/a.png", square(4));
    write("out/a.png", square(20));
    expectSays(compare({"--tolerant"}), 1, {"lie together"});
    expectSays(compare({"--tolerant", "--ignore", "6x6+4+8"}), 1, {"10x10 at 18,6"});
    expectSays(compare({"--ignore", "6x6+4+8", "--ignore", "6x6+20+8"}), 0, {"same: a.png"});
    expectSays(compare({"--ignore", "6x6+4+8", "--ignore", "99x5+20+8"}), 1, {"share of pixels off"});
}

TEST_F(Regions, MeasuresAreOfTheRest) {
    write("ref/a.exr", square(4));
    demos::Picture broken = square(20);
    broken.rgba[0] = std::numeric_limits<float>::quiet_NaN();
    write("out/a.exr", broken);
    // Of four columns all of which are a square's, no pixel is within the limit.
    expectSays(compare({"--max-diff", "0.1", "--ignore", "20x24+0+0", "--ignore", "40x8+0+0", "--ignore",
                        "40x10+0+14", "--ignore", "16x24+24+0"}),
               1, {"share of pixels off by more than 0.1 is 1, expected at most 0"});
    EXPECT_EQ(compare({"--max-diff", "0.1", "--ignore", "40x24+0+0"}).code, 1) << "nothing is left";
}

TEST_F(Regions, AMaskLiesBesideTheReferenceOrIsNamed) {
    write("ref/deep/a_0000.exr", square(4));
    write("out/deep/a_0000.exr", square(20));
    demos::Picture mask = square(4, 0);
    for (float& value : mask.rgba) value = value < 0.25f ? 0.0f : 1.0f;
    demos::Picture both = square(20, 0);
    for (size_t i = 0; i < mask.rgba.size(); ++i) both.rgba[i] = both.rgba[i] < 0.25f ? 0 : mask.rgba[i];
    write("ref/deep/a.mask.png", both);
    expectSays(compare(), 0, {"same: deep/a_0000.exr"});
    write("ref/deep/a.mask.png", mask);
    expectSays(compare(), 1, {"different: deep/a_0000.exr"});
    write("both.png", both);
    expectSays(compare({"--mask", "both.png", "--report", "report", "--json", "a.json"}), 0,
               {"same: deep/a_0000.exr"});
    EXPECT_NE(tests::readAll(at("report/index.html")).find("<td>left out</td><td>72 pixels</td>"),
              std::string::npos);
    EXPECT_NE(tests::readAll(at("a.json")).find("\"left_out_pixels\": 72"), std::string::npos);
}

TEST_F(Regions, WhatCannotBeLeftOutIsNamed) {
    writeBoth("a.png", square(4));
    expectSays(compare({"--ignore", "6x6+4"}), 2, {"--ignore is '6x6+4', expected WIDTHxHEIGHT+LEFT+TOP"});
    expectSays(compare({"--ignore", "0x6+4+1"}), 2, {"--ignore is '0x6+4+1'"});
    expectSays(compare({"--ignore", "6x6+40+0"}), 2, {"--ignore 6x6+40+0: is outside of ref/a.png", "40x24"});
    expectSays(compare({"--mask", "none.png"}), 2, {"none.png: no such file"});
    demos::Picture small{2, 2, std::vector<float>(16, 1.0f)};
    write("ref/a.mask.png", small);
    expectSays(compare(), 2, {"ref/a.mask.png: the mask is 2x2, expected its picture's 40x24"});
    tests::writeAll(at("ref/a.mask.png"), "no picture");
    expectSays(compare(), 2, {"ref/a.mask.png: "});
}

} // namespace
