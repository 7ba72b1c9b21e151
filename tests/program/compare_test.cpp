// seaglass compare: its exit codes, its words and what it writes.
#include <cmath>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "demos/host/files/image_file.h"
#include "tests/program/refused.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using demos::Picture;
using tests::Outcome;

constexpr uint32_t width = 40, height = 24;

Picture gradient() {
    Picture picture{width, height, {}};
    for (uint32_t i = 0; i < width * height; ++i) {
        const float value = static_cast<float>(i % width) / width;
        picture.rgba.insert(picture.rgba.end(), {value, 0.5f, 0.25f, 1});
    }
    return picture;
}

/// Adds to the red of the first pixels.
Picture changed(uint32_t pixels, float by) {
    Picture picture = gradient();
    for (uint32_t i = 0; i < pixels; ++i) picture.rgba[4 * i] += by;
    return picture;
}

class Compare : public testing::Test {
  protected:
    Outcome compare(const std::vector<std::string>& arguments, size_t largestFile = 0) const {
        std::vector<std::string> all = {"compare"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return tests::run(SEAGLASS_PROGRAM, {all, {}, folder_.path(), largestFile});
    }

    void writeExr(const std::string& name, const Picture& picture) const {
        demos::Error error;
        ASSERT_TRUE(demos::writeExr(folder_.path() / name, picture, error)) << error.text;
    }

    void writePng(const std::string& name, const Picture& picture) const {
        std::vector<uint8_t> rgb;
        for (size_t i = 0; i < picture.rgba.size(); ++i) {
            if (i % 4 != 3) rgb.push_back(static_cast<uint8_t>(std::lround(picture.rgba[i] * 255)));
        }
        demos::Error error;
        ASSERT_TRUE(demos::writePng(folder_.path() / name, picture.width, picture.height, rgb, error))
            << error.text;
    }

    /// A file of any format and channels, 4 x 3.
    void writeChannels(const std::string& name, OIIO::TypeDesc type, const std::vector<std::string>& channels,
                       const std::vector<float>& pixel, int dataRows = 3) const {
        OIIO::ImageSpec spec(4, dataRows, static_cast<int>(channels.size()), type);
        spec.full_height = 3;
        spec.channelnames = channels;
        spec.attribute("oiio:UnassociatedAlpha", 1);
        std::vector<float> pixels;
        for (int i = 0; i < 4 * dataRows; ++i) pixels.insert(pixels.end(), pixel.begin(), pixel.end());
        writeImage(name, spec, pixels);
    }

    void writeImage(const std::string& name, const OIIO::ImageSpec& spec,
                    const std::vector<float>& pixels) const {
        const std::string file = (folder_.path() / name).string();
        const auto output = OIIO::ImageOutput::create(file);
        ASSERT_TRUE(output && output->open(file, spec) &&
                    output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close());
    }

    nlohmann::json json(const std::string& name) const {
        return nlohmann::json::parse(tests::readAll(folder_.path() / name));
    }

    const tests::TemporaryFolder folder_;
};

void expectSame(const Outcome& outcome) {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(outcome.out.ends_with("\nsame\n")) << outcome.out;
}

void expectDifferent(const Outcome& outcome, const std::string& words) {
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("different: ")) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out.find("same"), std::string::npos) << outcome.out;
}

TEST_F(Compare, EqualPicturesAreTheSame) {
    writePng("a.png", gradient());
    writeExr("a.exr", gradient());
    tests::writeAll(folder_.path() / "a.hdr", tests::sampleSky());
    for (const std::string name : {"a.png", "a.exr", "a.hdr"}) {
        const Outcome outcome = compare({name, name});
        expectSame(outcome);
        EXPECT_NE(outcome.out.find("FLIP, mean "), std::string::npos) << outcome.out;
        EXPECT_NE(outcome.out.find("infinite"), std::string::npos) << outcome.out;
    }
    EXPECT_NE(compare({"a.png", "a.png"}).out.find("\nFLIP"), std::string::npos);
    EXPECT_NE(compare({"a.exr", "a.exr"}).out.find("\nHDR-FLIP"), std::string::npos);
}

TEST_F(Compare, WithoutLimitsOneStepOfOnePixelIsADifference) {
    writePng("a.png", gradient());
    writePng("b.png", changed(1, 1.0f / 255));
    expectDifferent(compare({"a.png", "b.png"}), "share of pixels off by more than 0 is");
    writeExr("a.exr", gradient());
    writeExr("b.exr", changed(1, 1e-6f));
    expectDifferent(compare({"a.exr", "b.exr"}), "share of pixels off by more than 0 is");
}

TEST_F(Compare, LimitsHoldTogether) {
    writePng("a.png", gradient());
    writePng("b.png", changed(8, 0.2f)); // of 960
    const std::vector<std::string> files = {"a.png", "b.png"};
    const auto with = [&](std::vector<std::string> options) {
        options.insert(options.begin(), files.begin(), files.end());
        return compare(options);
    };
    expectSame(with({"--max-flip", "0.2"}));
    expectDifferent(with({"--max-flip", "0.0001"}), "mean FLIP is");
    expectSame(with({"--max-diff", "0.21"}));
    expectDifferent(with({"--max-diff", "0.19"}), "off by more than 0.19 is 0.008333, expected at most 0");
    expectSame(with({"--max-share", "0.01"}));
    expectDifferent(with({"--max-share", "0.008"}), "off by more than 0 is 0.008333, expected at most 0.008");
    expectSame(with({"--max-diff", "0.1", "--max-share", "0.01", "--max-flip", "0.2"}));
    expectDifferent(with({"--max-diff", "0.1", "--max-share", "0.001", "--max-flip", "0.2"}), "share");
    expectDifferent(with({"--max-diff", "0.1", "--max-share", "0.01", "--max-flip", "0.0001"}), "FLIP");
}

// Each limit that is given counts in place of its own tolerant one, and of no other.
TEST_F(Compare, ALimitLeavesTheOtherTolerantOnes) {
    Picture spot = gradient(), noise = gradient();
    spot.rgba[4 * 500 + 2] = 1; // one pixel, by 0.75
    for (size_t i = 0; i < noise.rgba.size(); i += 4) noise.rgba[i + 1] += i % 8 == 0 ? 0.02f : -0.02f;
    writePng("a.png", gradient());
    writePng("spot.png", spot);
    writePng("noise.png", noise);
    const auto with = [&](const std::string& test, std::vector<std::string> options) {
        options.insert(options.begin(), {"a.png", test, "--tolerant", "--max-flip", "1", "--max-p99", "1",
                                         "--max-wrong", "1", "--max-local", "1"});
        return compare(options);
    };
    constexpr const char *single = "off by more than 0.35 from all around is",
                         *step = "off by more than 0.01176 is 1";
    expectDifferent(with("spot.png", {}), single);
    expectSame(with("spot.png", {"--max-diff", "0.8"}));
    expectDifferent(with("noise.png", {}), step);
    expectDifferent(with("noise.png", {"--max-diff", "0.8"}), step);
    expectSame(with("noise.png", {"--max-share", "1"}));
    expectDifferent(with("spot.png", {"--max-share", "1"}), single);
    expectSame(with("noise.png", {"--max-diff", "0.1", "--max-share", "0.1"}));
    expectDifferent(with("noise.png", {"--max-diff", "0", "--max-share", "0"}), "off by more than 0 is 1");
}

TEST_F(Compare, NanInEitherPictureIsADifferenceWhateverTheLimits) {
    Picture broken = gradient();
    broken.rgba[40] = std::numeric_limits<float>::quiet_NaN();
    broken.rgba[81] = std::numeric_limits<float>::infinity();
    writeExr("a.exr", gradient());
    writeExr("nan.exr", broken);
    const std::vector<std::string> limits = {"--max-flip", "1", "--max-diff", "1e9", "--max-share", "1"};
    const auto with = [&](std::vector<std::string> files) {
        files.insert(files.end(), limits.begin(), limits.end());
        return compare(files);
    };
    expectDifferent(with({"a.exr", "nan.exr"}),
                    "NaN or infinity in 2 pixels of the test, the first at 10,0,");
    expectDifferent(with({"nan.exr", "a.exr"}),
                    "NaN or infinity in 2 pixels of the reference, the first at 10,0,");
    expectDifferent(with({"nan.exr", "nan.exr"}), "NaN or infinity");
}

TEST_F(Compare, OneValueInEightAndSixteenBitsIsTheSame) {
    std::vector<float> levels; // all that eight bits have, each a pixel
    for (int value = 0; value < 256; ++value)
        levels.insert(levels.end(), {static_cast<float>(value) / 255, 1, 0});
    OIIO::ImageSpec spec(256, 1, 3, OIIO::TypeDesc::UINT8);
    writeImage("a.png", spec, levels);
    spec.set_format(OIIO::TypeDesc::UINT16);
    writeImage("b.png", spec, levels);
    demos::Error error;
    const std::optional<Picture> a = demos::readPicture(folder_.path() / "a.png", error);
    const std::optional<Picture> b = demos::readPicture(folder_.path() / "b.png", error);
    ASSERT_TRUE(a && b) << error.text;
    ASSERT_EQ(a->rgba.size(), 4 * 256u);
    EXPECT_NE(a->rgba[4 * 100], a->rgba[4 * 101]);
    EXPECT_EQ(a->rgba, b->rgba);
    expectSame(compare({"a.png", "b.png"}));
}

TEST_F(Compare, NamesWhatItComparesAndWhatNot) {
    const OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT;
    writeChannels("plain.exr", type, {"R", "G", "B"}, {4, 5, 6});
    writeChannels("deep.exr", type, {"R", "G", "B", "A", "Z"}, {4, 5, 6, 1, 9});
    writeChannels("short.exr", type, {"R", "G", "B"}, {4, 5, 6}, 2);
    EXPECT_TRUE(compare({"plain.exr", "plain.exr"}).out.starts_with("NaN")) << "nothing to name";
    EXPECT_TRUE(compare({"deep.exr", "deep.exr"}).out.starts_with("both: R G B; not compared: A Z\n"));
    EXPECT_TRUE(compare({"plain.exr", "deep.exr"})
                    .out.starts_with("reference: R G B\ntest: R G B; not compared: A Z\n"));
    const Outcome cropped = compare({"plain.exr", "short.exr"});
    EXPECT_NE(cropped.out.find("test: R G B; data window 4x2+0+0 of 4x3+0+0\n"), std::string::npos)
        << cropped.out;
    expectDifferent(cropped, "share");
}

TEST_F(Compare, APngsGammaIsFollowedAndNamed) {
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::UINT16);
    writeImage("usual.png", spec, {0.5f, 1, 0});
    spec.attribute("oiio:ColorSpace", "Linear");
    writeImage("linear.png", spec, {0.2140411f, 1, 0});
    const Outcome outcome = compare({"usual.png", "linear.png", "--max-diff", "1e-4"});
    expectSame(outcome);
    EXPECT_TRUE(outcome.out.starts_with("reference: R G B\ntest: R G B; gamma 1, brought to sRGB\n"))
        << outcome.out;
    writeImage("mistaken.png", spec, {0.5f, 1, 0});
    expectDifferent(compare({"usual.png", "mistaken.png", "--max-diff", "0.2"}), "share");
}

TEST_F(Compare, LayersAreToldApartOrChosen) {
    const OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT;
    const std::vector<std::string> render = {"V.AO.R",       "V.AO.G",       "V.AO.B",
                                             "V.Combined.R", "V.Combined.G", "V.Combined.B"};
    writeChannels("a.exr", type, render, {1, 1, 1, 4, 5, 6});
    writeChannels("b.exr", type, render, {1, 1, 1, 4, 5, 7});
    writeChannels("plain.exr", type, {"R", "G", "B"}, {4, 5, 6});
    expectDifferent(compare({"a.exr", "b.exr"}), "share");
    expectSame(compare({"a.exr", "b.exr", "--layer", "AO"}));
    expectSame(compare({"plain.exr", "a.exr"}));
    expectDifferent(compare({"a.exr", "b.exr", "--layer", "Combined", "--layer", "AO"}), "share");
    writeChannels("c.exr", type, {"x.R", "x.G", "x.B", "y.R", "y.G", "y.B"}, {1, 1, 1, 2, 2, 2});
    tests::expectRefused(compare({"c.exr", "c.exr"}),
                         {"c.exr: ", "several layers", "--layer with one of x, y"});
    tests::expectRefused(compare({"c.exr", "c.exr", "--layer", "z"}), {"c.exr: has no layer 'z'"});
    tests::expectRefused(compare({"c.exr", "c.exr", "--layer", "x", "--layer", "x", "--layer", "x"}),
                         {"--layer is given 3 times"});
}

TEST_F(Compare, JsonHoldsTheMeasuresAndTheVerdict) {
    writeExr("a.exr", gradient());
    writeExr("b.exr", changed(480, 1.0f));
    expectDifferent(compare({"a.exr", "b.exr", "--json", "b.json", "--max-diff", "0.5", "--max-share", "0.1",
                             "--max-flip", "1"}),
                    "share");
    const nlohmann::json different = json("b.json");
    EXPECT_EQ(different["reference"], "a.exr");
    EXPECT_EQ(different["test"], "b.exr");
    EXPECT_EQ(different["size"], nlohmann::json({width, height}));
    EXPECT_FALSE(different["same"]);
    EXPECT_EQ(different["objections"].size(), 1u);
    EXPECT_EQ(different["flip"]["kind"], "hdr");
    EXPECT_GT(different["flip"]["mean"], 0.01);
    EXPECT_GE(different["flip"]["p99"], different["flip"]["mean"]);
    EXPECT_GE(different["flip"]["max"], different["flip"]["p99"]);
    EXPECT_NEAR(different["difference"]["max"].get<double>(), 1, 1e-6);
    EXPECT_NEAR(different["difference"]["mean"].get<double>(), 0.5 / 3, 1e-6);
    // The mean square is 1 / 6, the peak that of the ramp.
    const double peak = (width - 1.0) / width;
    EXPECT_NEAR(different["psnr_db"].get<double>(), 10 * std::log10(6 * peak * peak), 1e-4);
    EXPECT_EQ(different["shares"][0]["share"], 0.5);
    EXPECT_EQ(different["shares"][0]["max_share"], 0.1);

    expectSame(compare({"a.exr", "a.exr", "--json", "a.json"}));
    EXPECT_TRUE(json("a.json")["same"]);
    EXPECT_TRUE(json("a.json")["psnr_db"].is_null());
    EXPECT_EQ(json("a.json")["flip"]["mean"], 0);
}

double meanByte(const fs::path& file) {
    demos::Error error;
    const std::optional<Picture> picture = demos::readPicture(file, error);
    double sum = 0;
    for (const float value : picture.value().rgba) sum += static_cast<double>(value);
    return 255 * sum / static_cast<double>(picture->rgba.size());
}

TEST_F(Compare, TheReportIsAPageOfItsOwn) {
    writePng("a<b>&@SIZE@.png", gradient());
    writePng("b.png", changed(200, 0.1f));
    const Outcome outcome =
        compare({"a<b>&@SIZE@.png", "b.png", "--report", "new/report", "--max-flip", "1"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const fs::path report = folder_.path() / "new/report";
    EXPECT_NE(outcome.out.find("report: " + (report / "index.html").string()), std::string::npos)
        << outcome.out;
    EXPECT_EQ(tests::namesIn(report), (std::vector<std::string>{"flip.png", "index.html", "reference.png",
                                                                "report.json", "test.png"}));
    const std::string page = tests::readAll(report / "index.html");
    EXPECT_NE(page.find("a&lt;b&gt;&amp;&#64;SIZE&#64;.png"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos) << "nothing from elsewhere";
    EXPECT_EQ(page.find('@'), std::string::npos) << "all is filled in";
    EXPECT_NE(page.find("role=\"slider\""), std::string::npos);
    EXPECT_NE(page.find("<span class=\"verdict same\">same</span>b.png"), std::string::npos);
    EXPECT_NE(page.find("<p>40 &times; 24. "), std::string::npos);
    EXPECT_NE(page.find("<title>0 of 1 failed"), std::string::npos);
    EXPECT_EQ(tests::readAll(report / "test.png").substr(1, 3), "PNG");
    EXPECT_NEAR(meanByte(report / "reference.png"), meanByte(folder_.path() / "a<b>&@SIZE@.png"), 1e-9);
    EXPECT_NEAR(meanByte(report / "test.png"), meanByte(folder_.path() / "b.png"), 1e-9);
}

TEST_F(Compare, TheReportOfADifferenceSaysWhy) {
    writePng("a.png", gradient());
    writePng("b.png", changed(200, 0.1f));
    expectDifferent(compare({"a.png", "b.png", "--report", "."}), "share");
    const std::string page = tests::readAll(folder_.path() / "index.html");
    EXPECT_NE(page.find("<span class=\"verdict different\">different</span>"), std::string::npos);
    EXPECT_NE(
        page.find(
            "<p>share of pixels off by more than 0 is 0.2083, expected at most 0; FLIP is greatest at "),
        std::string::npos);
}

TEST_F(Compare, TheReportsExposureIsChosen) {
    Picture dim = gradient();
    for (float& value : dim.rgba) value *= 0.01f;
    writeExr("dim.exr", dim);
    expectSame(compare({"dim.exr", "dim.exr", "--report", "median"}));
    expectSame(compare({"dim.exr", "dim.exr", "--report", "none", "--exposure", "0"}));
    expectSame(compare({"dim.exr", "dim.exr", "--report", "bright", "--exposure", "9"}));
    const double median = meanByte(folder_.path() / "median/reference.png");
    EXPECT_GT(median, meanByte(folder_.path() / "none/reference.png") + 10);
    EXPECT_LT(median, meanByte(folder_.path() / "bright/reference.png") - 10);
}

TEST_F(Compare, AFullDiskIsNoDifference) {
    writePng("a.png", gradient());
    const Outcome outcome = compare({"a.png", "a.png", "--report", "report"}, 64);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
}

struct BadComparison {
    std::string name;
    std::vector<std::string> arguments;
    std::vector<std::string> says;
};

void PrintTo(const BadComparison& bad, std::ostream* out) {
    *out << bad.name;
}

class BadCompare : public Compare, public testing::WithParamInterface<BadComparison> {};

TEST_P(BadCompare, SaysSoOnOneLineAndLeavesNothing) {
    Picture turned = gradient();
    std::swap(turned.width, turned.height);
    writePng("a.png", gradient());
    writePng("turned.png", turned);
    writeExr("a.exr", gradient());
    writePng("reference.png", gradient());
    tests::writeAll(folder_.path() / "broken.png", "\x89PNG\r\n\x1a\nnothing");
    const std::string whole = tests::readAll(folder_.path() / "a.png");
    tests::writeAll(folder_.path() / "half.png", whole.substr(0, whole.size() / 2));
    tests::writeAll(folder_.path() / "a.jpg", "no matter what");
    fs::create_directory(folder_.path() / "folder.png");
    const std::vector<std::string> before = tests::namesIn(folder_.path());

    const Outcome outcome = compare(GetParam().arguments);
    tests::expectRefused(outcome, GetParam().says);
    EXPECT_EQ(tests::namesIn(folder_.path()), before);
}

std::vector<BadComparison> badComparisons() {
    const auto with = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"a.png", "a.png"});
        return options;
    };
    return {
        {"NoPicture", {}, {"expected seaglass compare REFERENCE TEST"}},
        {"OnePicture", {"a.png"}, {"expected seaglass compare REFERENCE TEST"}},
        {"ThreePictures", with({"a.png"}), {"'a.png' is one word too many", "seaglass compare --help"}},
        {"UnknownOption", with({"--max-flop", "1"}), {"--max-flop", "nearest is --max-flip"}},
        {"MissingReference", {"nope.png", "a.png"}, {"nope.png: no such file, expected"}},
        {"MissingTest", {"a.png", "nope.png"}, {"nope.png: no such file, expected"}},
        {"IsFolder", {"a.png", "folder.png"}, {"folder.png", "expected"}},
        {"IsBroken", {"a.png", "broken.png"}, {"broken.png", "expected"}},
        {"IsTruncated", {"a.png", "half.png"}, {"half.png", "expected"}},
        {"OtherSize", {"a.png", "turned.png"}, {"a.png is 40x24 and turned.png is 24x40, expected one size"}},
        {"OtherKind", {"a.png", "a.exr"}, {"a.png and a.exr", "expected two of a kind"}},
        {"OtherFormat", {"a.png", "a.jpg"}, {"a.jpg: '.jpg'", "expected .png, .exr or .hdr"}},
        {"FlipNoNumber", with({"--max-flip", "low"}), {"--max-flip is 'low'", "0 to 1"}},
        {"FlipNan", with({"--max-flip", "nan"}), {"--max-flip is 'nan'"}},
        {"FlipOverOne", with({"--max-flip", "1.5"}), {"--max-flip is '1.5'"}},
        {"DiffNegative", with({"--max-diff", "-0.1"}), {"--max-diff is '-0.1'"}},
        {"DataAlone", with({"--max-data", "1"}), {"--max-data is given without --tolerant"}},
        {"ShareOverOne", with({"--max-share", "5"}), {"--max-share is '5'", "0 to 1"}},
        {"ExposureNoNumber",
         {"a.exr", "a.exr", "--report", "r", "--exposure", "up"},
         {"--exposure is 'up'", "stops"}},
        {"ExposureAlone", {"a.exr", "a.exr", "--exposure", "1"}, {"--exposure", "--report"}},
        {"ExposureOfPng", with({"--report", "r", "--exposure", "1"}), {"--exposure", "PNG"}},
        {"JsonExtension", with({"--json", "a.txt"}), {"--json a.txt", ".json"}},
        {"JsonFolderMissing", with({"--json", "nope/a.json"}), {"--json nope/a.json", "folder nope"}},
        {"ReportIsFile", with({"--report", "a.jpg"}), {"--report a.jpg", "is a file, expected a folder"}},
        {"ReportInFile", with({"--report", "a.jpg/r"}), {"--report a.jpg/r", "is a file, expected a folder"}},
        {"ReportOverItsInput",
         {"reference.png", "a.png", "--report", "."},
         {"--report", "reference.png", "read"}},
    };
}

INSTANTIATE_TEST_SUITE_P(Inputs, BadCompare, testing::ValuesIn(badComparisons()),
                         [](const testing::TestParamInfo<BadComparison>& info) { return info.param.name; });

} // namespace
