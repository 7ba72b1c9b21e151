// What PNGs say of their colours is followed, or named.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "demos/host/files/image_file.h"
#include "tests/gltf/plate.h"
#include "tests/program/run.h"

namespace {

namespace fs = std::filesystem;

using Chunk = std::pair<std::string, std::string>;

std::string bigEndian(const std::vector<uint32_t>& words) {
    std::string bytes;
    for (const uint32_t word : words)
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(word >> shift & 255);
    return bytes;
}

const Chunk linear = {"gAMA", bigEndian({100000})}, usualGamma = {"gAMA", bigEndian({45455})};
const Chunk displayP3 = {"cHRM", bigEndian({31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000})};
const Chunk rec709 = {"cHRM", bigEndian({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000})};

class PngColors : public testing::Test {
  protected:
    /// One pixel, with chunks before it.
    demos::PictureFile read(const std::vector<uint8_t>& rgba, const std::vector<Chunk>& chunks) const {
        std::string bytes = tests::png(1, 1, rgba), added;
        for (const auto& [name, data] : chunks) added += tests::pngChunk(name, data);
        constexpr size_t afterHeader = 33;
        tests::writeAll(folder_.path() / "a.png", bytes.insert(afterHeader, added));
        demos::Error error;
        std::optional<demos::PictureFile> file = demos::readPictureFile(
            folder_.path() / "a.png", {"", "--layer"}, demos::limits::comparedPixels, error);
        EXPECT_TRUE(file) << error.text;
        return file.value_or(demos::PictureFile{});
    }

    tests::TemporaryFolder folder_;
};

/// In steps of 8 bits.
void expectColor(const demos::PictureFile& file, const std::array<double, 3>& expected) {
    for (size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(double{file.picture.rgba.at(i)} * 255, expected[i], 0.6) << "channel " << i;
}

TEST_F(PngColors, GammaBecomesSRgbs) {
    const demos::PictureFile file = read({55, 128, 255, 128}, {linear});
    expectColor(file, {128, 188, 255}); // 0.2158, 0.502 and 1 of light
    EXPECT_NEAR(double{file.picture.rgba[3]}, 128 / 255.0, 1e-6) << "alpha is none";
    EXPECT_EQ(file.header.encoding, "gamma 1, brought to sRGB");
    const demos::PictureFile other = read({128, 128, 128, 255}, {{"gAMA", bigEndian({55556})}});
    expectColor(other, {146.4, 146.4, 146.4}); // 0.289 of light
    EXPECT_EQ(other.header.encoding, "gamma 0.55556, brought to sRGB");
}

TEST_F(PngColors, PrimariesBecomeRec709s) {
    const demos::PictureFile file = read({200, 100, 100, 255}, {usualGamma, displayP3});
    expectColor(file, {214.9, 92.6, 96.6}); // through light by CSS Color 4's matrices
    EXPECT_EQ(file.header.encoding, "primaries, brought to sRGB");
    EXPECT_EQ(read({9, 8, 7, 255}, {linear, displayP3}).header.encoding,
              "gamma 1 and primaries, brought to sRGB");
}

TEST_F(PngColors, WhatIsSRgbStaysAsItIs) {
    const std::vector<std::vector<Chunk>> plain = {
        {},
        {usualGamma},
        {usualGamma, rec709},
        {{"sRGB", std::string(1, '\0')}},
        {linear, displayP3, {"sRGB", std::string(1, '\1')}},
        {linear, {"iCCP", std::string("sRGB IEC61966-2.1\0\0x", 20)}},
        {linear, {"cICP", std::string("\1\15\0\1", 4)}},
        {{"gAMA", bigEndian({0})}},
        {{"gAMA", "a"}, {"cHRM", "b"}, {"cICP", "c"}},
    };
    for (const std::vector<Chunk>& chunks : plain) {
        const demos::PictureFile file = read({200, 100, 7, 255}, chunks);
        EXPECT_EQ(file.header.encoding, "");
        EXPECT_EQ(file.picture.rgba, (std::vector<float>{200 / 255.0f, 100 / 255.0f, 7 / 255.0f, 1}));
    }
}

TEST_F(PngColors, OtherProfilesAreNamedAndLeft) {
    const std::string profile("Display P3\0\0x", 13), dirty("a\nb\0\0x", 6);
    const demos::PictureFile named = read({200, 100, 7, 255}, {linear, {"iCCP", profile}});
    EXPECT_EQ(named.header.encoding, "ICC profile 'Display P3', taken for sRGB");
    expectColor(named, {200, 100, 7});
    EXPECT_EQ(read({1, 2, 3, 255}, {{"iCCP", dirty}}).header.encoding, "ICC profile 'a?b', taken for sRGB");
    EXPECT_EQ(read({1, 2, 3, 255}, {{"cICP", std::string("\11\20\0\1", 4)}}).header.encoding,
              "cICP 9/16/0/1, taken for sRGB");
}

} // namespace
