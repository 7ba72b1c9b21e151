// What picture files say of themselves, beyond their numbers, and what is read of them: each is made here by
// its bytes, or by OpenImageIO.
#include <cmath>
#include <limits>

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "demos/host/files/image_file.h"
#include "demos/host/files/unpacking.h"
#include "demos/host/water/sun.h"
#include "tests/program/run.h"

namespace {

namespace fs = std::filesystem;

struct Part {
    OIIO::ImageSpec spec;
    std::vector<float> pixels;
};

/// Channel i of each pixel holds i + 1.
Part partOf(int width, int height, const std::vector<std::string>& channels, const std::string& name = {}) {
    Part part{{width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT}, {}};
    part.spec.channelnames = channels;
    if (!name.empty()) part.spec.attribute("oiio:subimagename", name);
    for (int i = 0; i < width * height; ++i)
        for (size_t channel = 0; channel < channels.size(); ++channel)
            part.pixels.push_back(static_cast<float>(channel + 1));
    return part;
}

/// With a value of its own for each pixel, 1, 2, 3 ..., in R, G and B.
Part numbered(int width, int height) {
    Part part = partOf(width, height, {"R", "G", "B"});
    for (size_t i = 0; i < part.pixels.size(); ++i) part.pixels[i] = static_cast<float>(i / 3 + 1);
    return part;
}

class PictureFile : public testing::Test {
  protected:
    fs::path write(const std::vector<Part>& parts) const {
        const fs::path file = folder_.path() / "a.exr";
        const auto output = OIIO::ImageOutput::create("openexr");
        std::vector<OIIO::ImageSpec> specs;
        for (const Part& part : parts) specs.push_back(part.spec);
        bool ok = specs.size() == 1
                      ? output->open(file.string(), specs[0])
                      : output->open(file.string(), static_cast<int>(specs.size()), specs.data());
        for (size_t i = 0; ok && i < parts.size(); ++i)
            ok = (i == 0 || output->open(file.string(), specs[i], OIIO::ImageOutput::AppendSubimage)) &&
                 output->write_image(OIIO::TypeDesc::FLOAT, parts[i].pixels.data());
        EXPECT_TRUE(ok && output->close()) << output->geterror();
        return file;
    }

    fs::path writeHdr(const std::string& header, const std::string& pixels) const {
        const fs::path file = folder_.path() / "a.hdr";
        tests::writeAll(file, "#?RADIANCE\n" + header + pixels);
        return file;
    }

    demos::PictureFile read(const fs::path& file, const std::string& layer = {}) const {
        demos::Error error;
        std::optional<demos::PictureFile> picture =
            demos::readPictureFile(file, {layer, "--layer"}, demos::limits::comparedPixels, error);
        EXPECT_TRUE(picture) << error.text;
        return picture.value_or(demos::PictureFile{});
    }

    void expectRefused(const fs::path& file, const std::vector<std::string>& words,
                       const std::string& layer = {}) const {
        demos::Error error;
        EXPECT_FALSE(demos::readPictureFile(file, {layer, "--layer"}, demos::limits::comparedPixels, error));
        EXPECT_TRUE(error.text.starts_with(file.string() + ": ")) << error.text;
        for (const std::string& word : words)
            EXPECT_NE(error.text.find(word), std::string::npos)
                << "'" << word << "' is not in: " << error.text;
    }

    /// Red of each pixel.
    static std::vector<float> reds(const demos::PictureFile& file) {
        std::vector<float> out;
        for (size_t i = 0; i < file.picture.rgba.size(); i += 4) out.push_back(file.picture.rgba[i]);
        return out;
    }

    static std::vector<float> first(const demos::PictureFile& file) {
        const std::vector<float>& rgba = file.picture.rgba;
        return {rgba.begin(), rgba.begin() + (rgba.empty() ? 0 : 3)};
    }

    const tests::TemporaryFolder folder_;
};

using Floats = std::vector<float>;
const std::string rgbe = "FORMAT=32-bit_rle_rgbe\n";

/// One grey pixel for each digit, of that many quarters.
std::string greyPixels(const std::string& digits) {
    std::string bytes;
    for (const char digit : digits) bytes += std::string(3, static_cast<char>((digit - '0') * 16)) + '\x82';
    return bytes;
}

TEST_F(PictureFile, HdrIsTurnedUprightFromEachOfItsEightOrientations) {
    // The picture is 3 x 2: 1 2 3 over 4 5 6.
    const std::pair<const char*, const char*> stored[] = {
        {"-Y 2 +X 3", "123456"}, {"-Y 2 -X 3", "321654"}, {"+Y 2 +X 3", "456123"}, {"+Y 2 -X 3", "654321"},
        {"+X 3 -Y 2", "142536"}, {"+X 3 +Y 2", "415263"}, {"-X 3 -Y 2", "362514"}, {"-X 3 +Y 2", "635241"}};
    for (const auto& [resolution, pixels] : stored) {
        const demos::PictureFile file = read(writeHdr(rgbe + "\n" + resolution + "\n", greyPixels(pixels)));
        EXPECT_EQ(file.picture.width, 3u) << resolution;
        EXPECT_EQ(file.picture.height, 2u) << resolution;
        Floats quarters = reds(file);
        for (float& value : quarters) value *= 4;
        EXPECT_EQ(quarters, (Floats{1, 2, 3, 4, 5, 6})) << resolution;
    }
}

TEST_F(PictureFile, HdrIsFreedOfEveryExposureAndColorCorrection) {
    const std::string size = "\n-Y 1 +X 1\n", pixel = greyPixels("4");
    EXPECT_EQ(first(read(writeHdr(rgbe + size, pixel))), (Floats{1, 1, 1}));
    EXPECT_EQ(first(read(writeHdr(rgbe + "EXPOSURE=4\nEXPOSURE=0.5\n" + size, pixel))),
              (Floats{0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(first(read(writeHdr("EXPOSURE= 2.0\nCOLORCORR= 1 2 4\n" + rgbe + size, pixel))),
              (Floats{0.5f, 0.25f, 0.125f}));
    EXPECT_EQ(
        first(read(writeHdr("# EXPOSURE=4\nGAMMA=1\nPRIMARIES=0 0 0 0 0 0 0 0\n" + rgbe + size, pixel))),
        (Floats{1, 1, 1}));
}

TEST_F(PictureFile, HdrOfAnotherMeaningIsRefused) {
    const std::string size = "\n-Y 1 +X 1\n", pixel = greyPixels("4");
    expectRefused(writeHdr("FORMAT=32-bit_rle_xyze\n" + size, pixel), {"FORMAT=32-bit_rle_xyze", "rgbe"});
    expectRefused(writeHdr(rgbe + "GAMMA=2.2\n" + size, pixel), {"GAMMA=2.2", "expected 1"});
    expectRefused(writeHdr(rgbe + "EXPOSURE=0\n" + size, pixel), {"EXPOSURE=0", "positive"});
    for (const std::string power : {"200", "-200"}) {
        const std::string exposure = "EXPOSURE=1e" + power + "\n";
        expectRefused(writeHdr(rgbe + exposure + exposure + size, pixel), {"EXPOSURE", "expected 1e-30"});
    }
    expectRefused(writeHdr(rgbe + "COLORCORR=1 2\n" + size, pixel), {"COLORCORR=1 2", "three"});
    expectRefused(writeHdr(rgbe + "PRIMARIES=.6 .3 .6 .3 .6 .3 .3 .3\n" + size, pixel), {"primaries"});
}

TEST_F(PictureFile, HdrWhoseHeaderIsOddSaysWhatWasExpected) {
    const std::string size = "\n-Y 1 +X 1\n", pixel = greyPixels("4");
    expectRefused(writeHdr(size, pixel), {"no FORMAT", "expected FORMAT=32-bit_rle_rgbe"});
    expectRefused(writeHdr("EXPOSURE=2\n" + size, pixel), {"no FORMAT", "expected FORMAT=32-bit_rle_rgbe"});
    expectRefused(writeHdr("FORMAT=32-bit_rgbe\n" + size, pixel),
                  {"FORMAT=32-bit_rgbe, expected 32-bit_rle_rgbe"});
    expectRefused(writeHdr("FORMAT=32-bit_rle_rgbe \n" + size, pixel), {"expected 32-bit_rle_rgbe"});
    for (const std::string& windows : {"FORMAT=32-bit_rle_rgbe\r\n" + size, rgbe + "\r" + size})
        expectRefused(writeHdr(windows, pixel), {"CR and LF", "expected LF alone"});
    expectRefused(writeHdr(rgbe + size.substr(1), pixel), {"'-Y 1 +X 1'", "expected an empty line before"});
    expectRefused(writeHdr(rgbe, ""), {"does not end", "expected an empty line"});
    std::string history;
    for (int i = 0; i < 120; ++i) history += "VIEW= -vtv\n";
    expectRefused(writeHdr(history + rgbe + size, pixel), {"over 100 lines"});
    EXPECT_EQ(first(read(writeHdr("SOFTWARE=x\r\n" + rgbe + "\n-Y 1 +X 1\r\n", pixel))),
              first(read(writeHdr(rgbe + size, pixel))));
}

TEST_F(PictureFile, PrimariesBecomeThoseOfRec709) {
    const auto withChromaticities = [&](const std::array<float, 8>& xy, const Floats& pixel) {
        Part part = partOf(1, 1, {"R", "G", "B"});
        part.pixels = pixel;
        part.spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), xy.data());
        return first(read(write({part})));
    };
    const auto expectNear = [](const Floats& is, const Floats& expected) {
        for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(is[i], expected[i], 1e-3f) << i;
    };
    const std::array<float, 8> ap0 = {0.7347f, 0.2653f, 0, 1, 0.0001f, -0.077f, 0.32168f, 0.33767f};
    const std::array<float, 8> ap1 = {0.713f, 0.293f, 0.165f, 0.83f, 0.128f, 0.044f, 0.32168f, 0.33767f};
    expectNear(withChromaticities(ap0, {1, 1, 1}), {1, 1, 1});
    // Rec. 709's red, as ACES' transforms with Bradford's adaptation give it.
    expectNear(withChromaticities(ap0, {0.439633f, 0.089776f, 0.017541f}), {1, 0, 0});
    expectNear(withChromaticities(ap1, {0.613097f, 0.070194f, 0.020616f}), {1, 0, 0});
    const Floats same = {0.1f, 0.2f, 0.3f};
    EXPECT_EQ(withChromaticities({0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f}, same), same);
}

TEST_F(PictureFile, IsItsDisplayWindowWhateverTheDataWindow) {
    Part cropped = numbered(2, 1);
    cropped.spec.x = 11;
    cropped.spec.y = 21;
    cropped.spec.full_x = 10;
    cropped.spec.full_y = 20;
    cropped.spec.full_width = 3;
    cropped.spec.full_height = 2;
    const demos::PictureFile file = read(write({cropped}));
    EXPECT_EQ(reds(file), (Floats{0, 0, 0, 0, 1, 2}));
    EXPECT_EQ(demos::toText(file.header.data), "2x1+11+21");
    EXPECT_EQ(demos::toText(file.header.display), "3x2+10+20");
    Part beyond = numbered(4, 4);
    beyond.spec.x = -1;
    beyond.spec.y = -1;
    beyond.spec.full_width = 2;
    beyond.spec.full_height = 2;
    EXPECT_EQ(reds(read(write({beyond}))), (Floats{6, 7, 10, 11}));
}

TEST_F(PictureFile, MayTakeTheMemoryOfAnother) {
    Part cropped = numbered(2, 1);
    cropped.spec.full_width = 3;
    cropped.spec.full_height = 2;
    const auto readInto = [](const fs::path& file, size_t values) {
        demos::Error error;
        return demos::readPictureFile(file, {{}, "--layer"}, demos::limits::comparedPixels, error,
                                      std::vector<float>(values, 9));
    };
    for (const Part& part : {cropped, numbered(3, 2)}) {
        const fs::path file = write({part});
        for (const size_t values : {0, 5, 24, 200})
            EXPECT_EQ(readInto(file, values).value().picture.rgba, read(file).picture.rgba) << values;
    }
}

template<class Whole>
void expectShares(const demos::PictureFile& file, const std::vector<Whole>& wholes, size_t channels) {
    const auto share = [](Whole value) {
        return static_cast<float>(static_cast<double>(value) /
                                  static_cast<double>(std::numeric_limits<Whole>::max()));
    };
    const bool grey = channels < 3, opaque = channels % 2 == 1;
    for (size_t i = 0; i < wholes.size() / channels; ++i) {
        for (size_t slot = 0; slot < 4; ++slot) {
            const size_t channel = slot == 3 ? channels - 1 : grey ? 0 : slot;
            const float expected = slot == 3 && opaque ? 1 : share(wholes[i * channels + channel]);
            ASSERT_EQ(file.picture.rgba[4 * i + slot], expected) << i << ", " << slot << " of " << channels;
        }
    }
}

TEST_F(PictureFile, OfWholeNumbersIsTheirShareOfTheGreatest) {
    const auto expectRead = [this]<class Whole>(Whole /*of a kind*/, OIIO::TypeDesc type) {
        for (const int channels : {1, 2, 3, 4}) {
            const fs::path file = folder_.path() / "a.png";
            OIIO::ImageSpec spec(256, 256, channels, type);
            if (channels % 2 == 0) spec.alpha_channel = channels - 1;
            spec.attribute("oiio:UnassociatedAlpha", 1);
            std::vector<Whole> wholes(size_t{256} * 256 * static_cast<size_t>(channels));
            for (size_t i = 0; i < wholes.size(); ++i) wholes[i] = static_cast<Whole>(i);
            const auto output = OIIO::ImageOutput::create("png");
            ASSERT_TRUE(output->open(file.string(), spec) && output->write_image(type, wholes.data()) &&
                        output->close());
            expectShares(read(file), wholes, static_cast<size_t>(channels));
        }
    };
    expectRead(uint8_t{}, OIIO::TypeDesc::UINT8);
    expectRead(uint16_t{}, OIIO::TypeDesc::UINT16);
}

TEST_F(PictureFile, ThePictureIsToldFromOtherLayers) {
    const auto expectFirst = [&](const std::vector<Part>& parts, const Floats& color, const char* layer) {
        const demos::PictureFile file = read(write(parts));
        EXPECT_EQ(first(file), color);
        EXPECT_EQ(file.header.layer, layer);
    };
    const std::vector<std::string> ao = {"V.AO.R", "V.AO.G", "V.AO.B"};
    const auto with = [](std::vector<std::string> names, const std::vector<std::string>& more) {
        names.insert(names.end(), more.begin(), more.end());
        return names;
    };
    expectFirst({partOf(2, 2, with(ao, {"V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Combined.A"}))},
                {4, 5, 6}, "V.Combined");
    expectFirst({partOf(2, 2, with(ao, {"R", "G", "B"}))}, {4, 5, 6}, "");
    expectFirst({partOf(2, 2, {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z"})}, {1, 2, 3}, "");
    expectFirst({partOf(2, 2, {"N.X", "N.Y", "N.Z", "flat.Y"})}, {4, 4, 4}, "flat");
    expectFirst({partOf(2, 2, {"Y"})}, {1, 1, 1}, "");
    expectFirst({partOf(2, 2, {"Z"}, "depth"), partOf(2, 2, {"R", "G", "B"}, "rest")}, {1, 2, 3}, "rest");
    expectFirst({partOf(2, 2, {"R", "G", "B"}, "albedo"), partOf(2, 2, {"R", "G", "B", "A"}, "beauty")},
                {1, 2, 3}, "beauty");
}

TEST_F(PictureFile, SeveralLayersAreListedAndOneCanBeNamed) {
    const fs::path file = write({partOf(
        2, 2,
        {"first.R", "first.G", "first.B", "V.second.R", "V.second.G", "V.second.B", "N.X", "N.Y", "N.Z"})});
    expectRefused(file, {"several layers", "--layer", "V.second, first"});
    EXPECT_EQ(first(read(file, "first")), (Floats{1, 2, 3}));
    EXPECT_EQ(first(read(file, "v.Second")), (Floats{4, 5, 6}));
    EXPECT_EQ(first(read(file, "second")), (Floats{4, 5, 6}));
    EXPECT_EQ(first(read(file, "N")), (Floats{7, 8, 9}));
    expectRefused(file, {"no layer 'third'", "N, V.second, first"}, "third");
    EXPECT_EQ(first(read(write({partOf(2, 2, {"R", "G", "B", "vel.x", "vel.y"})}), "vel")),
              (Floats{4, 5, 0}));
    const fs::path views =
        write({partOf(2, 2, {"R", "G", "B"}, "rgba.left"), partOf(2, 2, {"R", "G", "B"}, "rgba.right")});
    expectRefused(views, {"several layers", "rgba.left, rgba.right"});
    EXPECT_EQ(read(views, "right").header.layer, "rgba.right");
}

TEST_F(PictureFile, WithoutColorIsRefused) {
    expectRefused(write({partOf(2, 2, {"Z"})}), {"no colour, only Z", "expected R, G, B or Y"});
    expectRefused(write({partOf(2, 2, {"N.X", "N.Y", "N.Z"})}), {"no colour, only N.X, N.Y, N.Z"});
    expectRefused(write({partOf(2, 2, {"Y", "RY", "BY"})}), {"luminance and chroma"});
}

TEST_F(PictureFile, WholeNumbersAreRefusedWhereTheyWouldBeColor) {
    Part part = partOf(2, 2, {"R", "G", "B", "id.x"});
    for (size_t i = 0; i < part.pixels.size(); i += 4) part.pixels[i + 3] = 4e9f;
    part.spec.channelformats = {OIIO::TypeDesc::HALF, OIIO::TypeDesc::HALF, OIIO::TypeDesc::HALF,
                                OIIO::TypeDesc::UINT32};
    EXPECT_EQ(first(read(write({part}))), (Floats{1, 2, 3}));
    expectRefused(write({part}), {"its channel id.x holds whole numbers, expected half or float"}, "id");
    part.spec.channelformats[1] = OIIO::TypeDesc::UINT32;
    expectRefused(write({part}), {"its channel G holds whole numbers"});
}

TEST_F(PictureFile, OfADeepImageIsRefused) {
    OIIO::ImageSpec spec(2, 2, 4, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"R", "G", "B", "Z"};
    spec.deep = true;
    const fs::path file = folder_.path() / "a.exr";
    const auto output = OIIO::ImageOutput::create("openexr");
    OIIO::DeepData data(spec);
    ASSERT_TRUE(output->open(file.string(), spec) && output->write_deep_image(data) && output->close())
        << output->geterror();
    expectRefused(file, {"is deep"});
}

TEST_F(PictureFile, HdrSaysHowHighPixelsAreToTheirWidth) {
    const std::string pixel = "\x80\x80\x80\x81";
    const auto aspect = [&](const std::string& lines) {
        return read(writeHdr(rgbe + lines + "\n-Y 1 +X 1\n", pixel)).header.pixelAspect;
    };
    EXPECT_EQ(aspect(""), 1);
    EXPECT_EQ(aspect("PIXASPECT=2\n"), 0.5);
    EXPECT_EQ(aspect("PIXASPECT=2\nPIXASPECT= 0.25\n"), 2);
}

TEST_F(PictureFile, SizesAreRefusedByTheHeaderAlone) {
    expectRefused(writeHdr(rgbe, "\n-Y 11000 +X 11000\n"),
                  {"11000x11000", "in 53 bytes", "expected at most 2097258 pixels"});
    expectRefused(writeHdr(rgbe, "\n-Y 1 +X 20000\n"), {"20000x1", "1 to 16384"});
}

/// What is left of bytes, or what is wrong with them.
std::string bareOf(const std::string& bytes) {
    std::string problem;
    const auto bare =
        demos::barePicture({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, problem);
    return bare ? std::string(bare->bytes.begin(), bare->bytes.end()) : problem;
}

std::string bytesOf(uint32_t number, int count) {
    std::string out;
    for (int i = count; i-- > 0;) out += static_cast<char>(number >> 8 * i & 0xff);
    return out;
}

TEST(BarePicture, IsAPngWithoutItsTextsAndTags) {
    const auto chunk = [](const char* kind, const std::string& data) {
        return bytesOf(static_cast<uint32_t>(data.size()), 4) + kind + data + "sums";
    };
    const std::string start = "\x89PNG\r\n\x1a\n" + chunk("IHDR", "13 bytes") + chunk("gAMA", "1234");
    const std::string texts = chunk("tEXt", "XML:com.adobe.xmp") + chunk("zTXt", "k") + chunk("iTXt", "k") +
                              chunk("eXIf", "II*") + chunk("sPLT", "p");
    const std::string pixels = chunk("PLTE", "123") + chunk("tRNS", "1") + chunk("IDAT", "pixels");
    const std::string end = chunk("IEND", "");
    EXPECT_EQ(bareOf(start + texts + pixels + texts + end + "more"), start + pixels + end);
    EXPECT_EQ(bareOf(start + pixels.substr(0, pixels.size() - 9)),
              start + pixels.substr(0, pixels.size() - 9))
        << "pixels that are cut off";
    EXPECT_EQ(bareOf(start + bytesOf(65538, 4) + "tEXt" + "few"),
              "has a chunk of 65538 bytes, expected at most what the file has");
}

std::string segmentOf(int marker, const std::string& data) {
    return std::string("\xff") + static_cast<char>(marker) +
           bytesOf(static_cast<uint32_t>(data.size()) + 2, 2) + data;
}

TEST(BarePicture, IsAJpegWithoutItsTextsAndTags) {
    const std::string exif = segmentOf(0xe1, std::string("Exif\0\0II*", 9)),
                      comment = segmentOf(0xfe, "text");
    const std::string texts = comment + segmentOf(0xe1, "http://ns.adobe.com/xap/1.0/") +
                              segmentOf(0xed, "Photoshop 3.0") + exif + segmentOf(0xe0, "none");
    const std::string start = "\xff\xd8" + segmentOf(0xe0, std::string("JFIF\0", 5)) + exif +
                              segmentOf(0xe2, std::string("ICC_PROFILE\0", 12)) + segmentOf(0xee, "Adobe") +
                              segmentOf(0xdb, "table");
    const std::string scan = segmentOf(0xda, "x") + std::string("ab\xff\0c\xff\xd0 d", 9), end = "\xff\xd9";
    EXPECT_EQ(bareOf(start + texts + scan + texts + scan + end + texts), start + scan + scan + end);
    EXPECT_EQ(bareOf(start + "\xff\x01" + comment + "between\xff" + scan), start + scan)
        << "a marker without a length, and bytes between segments";
    EXPECT_EQ(bareOf(start + scan.substr(0, 5)), start + scan.substr(0, 5)) << "cut off";
}

TEST(BarePicture, SaysHowLargeAJpegsFramesAre) {
    const auto frame = [](int marker, uint32_t width, uint32_t height) {
        return segmentOf(marker, "8" + bytesOf(height, 2) + bytesOf(width, 2) + "3");
    };
    const std::string bytes =
        "\xff\xd8\xff\x01" + frame(0xc2, 65500, 8) + frame(0xc4, 65501, 65501) + frame(0xc0, 8, 30000);
    std::string problem;
    const auto bare =
        demos::barePicture({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, problem);
    ASSERT_TRUE(bare) << problem;
    EXPECT_EQ(bare->width, 65500u);
    EXPECT_EQ(bare->height, 30000u);
}

TEST_F(PictureFile, ScansAndFramesOfJpegsAreCountedBeforeTheyAreUnpacked) {
    const auto jpeg = [&](size_t scans) {
        const std::string thumbnail("\xff\xe1\0\x08\xff\xda\0\2\xff\xda", 10),
            scan("\xff\xda\0\2x\xff\0y", 8);
        std::string bytes = "\xff\xd8" + thumbnail;
        for (size_t i = 0; i < scans; ++i) bytes += scan;
        return bytes + "\xff\xd9" + scan;
    };
    EXPECT_FALSE(bareOf(jpeg(64)).starts_with("has"));
    EXPECT_EQ(bareOf(jpeg(65)), "has 65 scans, expected at most 64");
    const auto refuse = [&](const std::string& bytes, const std::string& what) {
        tests::writeAll(folder_.path() / "a.jpg", bytes);
        expectRefused(folder_.path() / "a.jpg", {what});
    };
    refuse(jpeg(5000), "5000 scans");
    refuse("\xff\xd8" + segmentOf(0xc2, "8" + bytesOf(65500, 2) + bytesOf(65500, 2)),
           "is 65500x65500, expected 1 to 16384 each way");
    refuse("\xff\xd8" + segmentOf(0xc2, "8" + bytesOf(16000, 2) + bytesOf(16000, 2)),
           "is 16000x16000 in 11 bytes, expected at most 2097174 pixels");
}

/// With the bytes of `with` in the place of those of `what`.
std::string replaced(std::string text, const std::string& what, const std::string& with) {
    return text.replace(text.find(what), what.size(), with);
}

TEST_F(PictureFile, ExrsAskForNoMoreThanTheyHold) {
    const fs::path file = write({numbered(2, 1)});
    const std::string good = tests::readAll(file);
    const auto expect = [&](const std::string& bytes, const std::vector<std::string>& words) {
        tests::writeAll(file, bytes);
        expectRefused(file, words);
    };
    const std::string box("dataWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0", 29);
    expect(replaced(good, box, box.substr(0, 17) + std::string("\0\0\0\x70", 4) + box.substr(21)),
           {"attribute 'dataWindow' is said to hold 1879048192 bytes"});
    const size_t window = good.find(box) + box.size();
    std::string large = good;
    large[window + 3] = '\x7f';
    expect(large, {"is 2130706434x1, expected 1 to 16384 each way"});
    std::string many = good;
    for (int i = 0; i < 1025; ++i) many.insert(8, "a" + std::to_string(i) + std::string("\0i\0\0\0\0\0", 7));
    expect(many, {"has over 1024 attributes in a part"});
    expect(good.substr(0, window), {"dataWindow", "bytes"});
    expect(good.substr(0, good.find("dataWindow")), {"cut off"});
    expect("GIF89a", {"is no picture that is known"});
}

class SkyFile : public PictureFile {
  protected:
    void expectNoSky(const Part& part, const std::vector<std::string>& words) const {
        demos::Error error;
        EXPECT_FALSE(demos::readSkyImage({write({part})}, error));
        for (const std::string& word : words)
            EXPECT_NE(error.text.find(word), std::string::npos)
                << "'" << word << "' is not in: " << error.text;
    }
};

TEST_F(SkyFile, MustBeWholeSquareAndLatLong) {
    Part part = numbered(8, 2);
    part.spec.y = 1;
    part.spec.full_height = 4;
    expectNoSky(part, {"data window is 8x2+0+1", "display window, 8x4+0+0"});
    part = numbered(8, 4);
    part.spec.attribute("PixelAspectRatio", 2.0f);
    expectNoSky(part, {"aspect of 2"});
    part = partOf(8, 4, {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"});
    expectNoSky(part, {"sky.layer with one of a, b"});
    demos::Error error;
    const std::optional<demos::SkyImage> sky = demos::readSkyImage({write({part}), "b"}, error);
    ASSERT_TRUE(sky) << error.text;
    EXPECT_EQ(sky->radiance.front(), glm::vec3(4, 5, 6));
}

TEST_F(SkyFile, KeepsTheLightOfSunsThatAreFarBrighterThanHalvesHold) {
    Part part = partOf(64, 32, {"R", "G", "B"});
    const auto set = [&part](size_t x, size_t y, float value) {
        for (size_t c = 0; c < 3; ++c) part.pixels[3 * (64 * y + x) + c] = value;
    };
    const float infinite = std::numeric_limits<float>::infinity();
    set(20, 8, 1.6e9f); // the sun's, in candela per square metre
    set(40, 8, infinite);
    demos::Error error;
    const std::optional<demos::SkyImage> sky = demos::readSkyImage({write({part})}, error);
    ASSERT_TRUE(sky) << error.text;
    EXPECT_EQ(sky->radiance[64 * 8 + 20], glm::vec3(1.6e9f));
    EXPECT_EQ(sky->radiance[64 * 8 + 40], glm::vec3(1e7f));
}

/// Even, with one bright pixel.
demos::SkyImage withLamp(uint32_t x, uint32_t y) {
    demos::SkyImage sky{64, 32, std::vector<glm::vec3>(size_t(64) * 32, glm::vec3(1))};
    sky.radiance[y * 64 + x] = glm::vec3(500);
    return sky;
}

double most(const demos::SkyImage& sky) {
    float found = 0;
    for (const glm::vec3& pixel : sky.radiance) found = std::max(found, pixel.g);
    return static_cast<double>(found);
}

TEST(SkySun, ThatTheSkyKeepsLightsTheSceneInFull) {
    demos::SkyImage sky = withLamp(20, 8);
    sky.radiance[64 * 8 + 20] = glm::vec3(1e7f);
    const demos::SkyLight light = demos::filterSky(sky, 0, 1);
    const double pi = std::acos(-1.0), top = pi * 8 / 32, bottom = pi * 9 / 32;
    const double lamp = 1e7 * 2 * pi / 64 * (std::cos(top) - std::cos(bottom)) * std::cos((top + bottom) / 2);
    EXPECT_NEAR(static_cast<double>(light.irradianceUp.g) / (lamp + pi), 1, 0.02);
    for (const std::vector<glm::vec3>& level : light.cube.mips)
        for (const glm::vec3& texel : level) ASSERT_LE(texel.g, 65504) << "halves hold no more";
}

TEST(SkySun, IsCutOutOnlyToBePutBack) {
    const demos::SkyDesc desc;
    demos::SunDesc sun;
    demos::Sun chosen;
    demos::Error error;
    sun.fromSky = true;
    demos::SkyImage sky = withLamp(20, 8);
    ASSERT_TRUE(demos::chooseSun(desc, sun, sky, chosen, error)) << error.text;
    EXPECT_EQ(most(sky), 1);
    const double pi = std::acos(-1.0), pixel = 2 * pi / 64 * (std::cos(pi * 8 / 32) - std::cos(pi * 9 / 32));
    EXPECT_NEAR(chosen.irradiance.g / (499 * pixel), 1, 1e-5);

    sun.fromSky = false;
    sky = withLamp(20, 8);
    ASSERT_TRUE(demos::chooseSun(desc, sun, sky, chosen, error)) << error.text;
    EXPECT_EQ(most(sky), 500) << "the scene's own sun leaves the sky as it is";
    EXPECT_EQ(chosen.irradiance, glm::dvec3(3));

    sun.fromSky = true;
    sky = withLamp(20, 20);
    ASSERT_TRUE(demos::chooseSun(desc, sun, sky, chosen, error)) << error.text;
    EXPECT_EQ(most(sky), 500) << "what is below the horizon is no sun";
    EXPECT_EQ(chosen.irradiance, glm::dvec3(0));
}

} // namespace
