// ICC profiles of pictures are followed where they are a matrix and a curve, and named.
#include <cmath>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "demos/host/files/color/icc_profile.h"
#include "demos/host/files/image_file.h"
#include "tests/program/run.h"

namespace {

using ProfileText = std::string;

std::string inBigEndian(uint32_t value, int bytes = 4) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255);
    return text;
}

std::string fixed(double value) {
    return inBigEndian(static_cast<uint32_t>(static_cast<int32_t>(std::lround(value * 65536))));
}

std::string xyz(const std::array<double, 3>& color) {
    return "XYZ " + inBigEndian(0) + fixed(color[0]) + fixed(color[1]) + fixed(color[2]);
}

std::string powerCurve(double power) {
    return "curv" + inBigEndian(0) + inBigEndian(1) +
           inBigEndian(static_cast<uint32_t>(std::lround(power * 256)), 2);
}

std::string formula(uint32_t form, const std::vector<double>& values) {
    std::string text = "para" + inBigEndian(0) + inBigEndian(form, 2) + inBigEndian(0, 2);
    for (const double value : values) text += fixed(value);
    return text;
}

std::string sRgbFormula() {
    return formula(3, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045});
}

std::string table(double power) {
    std::string text = "curv" + inBigEndian(0) + inBigEndian(64);
    for (int i = 0; i < 64; ++i) {
        const double v = i / 63.0;
        const double light =
            power > 0 ? std::pow(v, power) : (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
        text += inBigEndian(static_cast<uint32_t>(std::lround(light * 65535)), 2);
    }
    return text;
}

using Tags = std::vector<std::pair<std::string, std::string>>;

ProfileText profileOf(const Tags& tags, const std::string& space = "RGB XYZ ") {
    std::string list, data;
    for (const auto& [name, content] : tags) {
        list += name + inBigEndian(static_cast<uint32_t>(132 + 12 * tags.size() + data.size())) +
                inBigEndian(static_cast<uint32_t>(content.size()));
        data += content + std::string((4 - content.size() % 4) % 4, '\0');
    }
    const size_t size = 132 + list.size() + data.size();
    return inBigEndian(static_cast<uint32_t>(size)) + std::string(4, '\0') + inBigEndian(0x02400000) +
           "mntr" + space + std::string(12, '\0') + "acsp" + std::string(28, '\0') + fixed(0.9642) +
           fixed(1) + fixed(0.8249) + std::string(48, '\0') +
           inBigEndian(static_cast<uint32_t>(tags.size())) + list + data;
}

using Colorants = std::array<std::array<double, 3>, 3>;

// Under D50, as profiles have them.
constexpr Colorants ofSRgb = {{{0.4361, 0.2225, 0.0139}, {0.3851, 0.7169, 0.0971}, {0.1431, 0.0606, 0.7141}}};
constexpr Colorants ofDisplayP3 = {
    {{0.5151, 0.2412, -0.0011}, {0.2920, 0.6922, 0.0419}, {0.1571, 0.0666, 0.7841}}};

Tags tagsOf(const std::string& name, const Colorants& colors, const std::string& curve) {
    return {{"desc", "desc" + inBigEndian(0) + inBigEndian(static_cast<uint32_t>(name.size() + 1)) + name +
                         std::string(79, '\0')},
            {"rXYZ", xyz(colors[0])},
            {"gXYZ", xyz(colors[1])},
            {"bXYZ", xyz(colors[2])},
            {"rTRC", curve},
            {"gTRC", curve},
            {"bTRC", curve}};
}

std::span<const uint8_t> bytesOf(const ProfileText& text) {
    return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

class IccProfiles : public testing::Test {
  protected:
    /// Pixels of 200, 100, 100; by the kind's own bytes, in a file that is called a PNG.
    demos::PictureFile read(const std::string& kind, const ProfileText& profile) const {
        const std::filesystem::path file = folder_.path() / "a.png";
        OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeDesc::UINT8);
        spec.attribute("Compression", "jpeg:100");
        spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                       profile.data());
        std::vector<uint8_t> pixels;
        for (int i = 0; i < 64; ++i) pixels.insert(pixels.end(), {200, 100, 100});
        const std::filesystem::path written = folder_.path() / ("a." + kind);
        const auto output = OIIO::ImageOutput::create(written.string());
        EXPECT_TRUE(output && output->open(written.string(), spec) &&
                    output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) && output->close());
        std::filesystem::rename(written, file);
        demos::Error error;
        std::optional<demos::PictureFile> picture =
            demos::readPictureFile(file, {"", "--layer"}, demos::limits::comparedPixels, error);
        EXPECT_TRUE(picture) << error.text;
        return picture.value_or(demos::PictureFile{});
    }

    static void expectColor(const demos::PictureFile& file, const std::array<double, 3>& expected) {
        for (size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(double{file.picture.rgba.at(i)} * 255, expected[i], 1.2) << "channel " << i;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(IccProfiles, MatricesAndCurvesAreFollowed) {
    for (const char* const kind : {"png", "jpg"}) {
        const demos::PictureFile p3 = read(kind, profileOf(tagsOf("Display P3", ofDisplayP3, sRgbFormula())));
        expectColor(p3, {214.9, 92.6, 96.6}); // as by its cHRM
        EXPECT_EQ(p3.header.encoding, "ICC profile 'Display P3', brought to sRGB") << kind;
        const demos::PictureFile linear = read(kind, profileOf(tagsOf("light", ofSRgb, powerCurve(1))));
        expectColor(linear, {228.7, 168.2, 168.2}); // 200 and 100 of 255 as light
        EXPECT_EQ(linear.header.encoding, "ICC profile 'light', brought to sRGB") << kind;
    }
    expectColor(read("png", profileOf(tagsOf("", ofSRgb, formula(0, {1})))), {228.7, 168.2, 168.2});
}

TEST_F(IccProfiles, SRgbIsKnownByWhatItSays) {
    for (const std::string& curve : {sRgbFormula(), table(0)}) {
        const demos::PictureFile file = read("png", profileOf(tagsOf("of a camera", ofSRgb, curve)));
        EXPECT_EQ(file.header.encoding, "");
        expectColor(file, {200, 100, 100});
    }
}

TEST_F(IccProfiles, OthersAreNamedAndLeft) {
    const Tags tables = tagsOf("by tables", ofDisplayP3, table(1.8));
    Tags toScreens = tagsOf("lookup", ofDisplayP3, sRgbFormula());
    toScreens.push_back({"A2B0", "mft2"});
    Tags uneven = tagsOf("uneven", ofDisplayP3, sRgbFormula());
    uneven.back().second = powerCurve(2);
    for (const char* const kind : {"png", "jpg"})
        for (const Tags& tags : {tables, toScreens, uneven}) {
            const demos::PictureFile file = read(kind, profileOf(tags));
            const std::string name = demos::profileName(bytesOf(profileOf(tags)));
            EXPECT_EQ(file.header.encoding, "ICC profile '" + name + "', taken for sRGB") << kind;
            expectColor(file, {200, 100, 100});
        }
    EXPECT_FALSE(demos::readProfile(bytesOf(profileOf(tables, "GRAYXYZ "))));
    EXPECT_FALSE(demos::readProfile(bytesOf(profileOf(tables, "RGB Lab "))));
}

TEST_F(IccProfiles, BrokenOnesAreNone) {
    const ProfileText whole = profileOf(tagsOf("Display P3", ofDisplayP3, sRgbFormula()));
    EXPECT_TRUE(demos::readProfile(bytesOf(whole)));
    for (size_t size = 0; size < whole.size(); ++size) {
        const ProfileText cut = whole.substr(0, size);
        demos::profileName(bytesOf(cut));
        demos::readProfile(bytesOf(cut));
        for (const char byte : {'\0', '\xff'}) {
            ProfileText other = whole;
            other[size] = byte;
            demos::profileName(bytesOf(other));
            demos::readProfile(bytesOf(other));
        }
    }
    EXPECT_FALSE(demos::readProfile(bytesOf(whole.substr(0, whole.size() - 4))));
}

TEST_F(IccProfiles, NamesMayBeInSeveralLanguages) {
    const std::string several = "mluc" + inBigEndian(0) + inBigEndian(1) + inBigEndian(12) + "enUS" +
                                inBigEndian(10) + inBigEndian(28) + std::string("\0C\0o\0l\0o\x20\xac", 10);
    EXPECT_EQ(demos::profileName(bytesOf(profileOf({{"desc", several}}))), "Colo?");
}

} // namespace
