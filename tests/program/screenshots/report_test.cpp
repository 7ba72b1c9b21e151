// The pages of compare, of bless, and of several reports: what they show of pictures that have no other, of
// values that are no light, of sequences, and of the worst places.
#include <nlohmann/json.hpp>

#include "tests/program/screenshots/folders.h"

namespace {

namespace fs = std::filesystem;
using tests::expectSays;

class Reports : public tests::Folders {
  protected:
    std::string page(const std::string& folder = "report") const {
        return tests::readAll(at(folder + "/index.html"));
    }

    /// All pictures that the page names are there.
    void expectPictures(const std::string& folder, size_t count) const {
        const std::string html = page(folder);
        size_t shown = 0;
        for (size_t i = html.find("src=\""); i != html.npos; i = html.find("src=\"", i + 1), ++shown) {
            const std::string file = html.substr(i + 5, html.find('"', i + 5) - i - 5);
            EXPECT_TRUE(fs::exists(at(folder) / file)) << file;
        }
        EXPECT_EQ(shown, count);
        EXPECT_EQ(html.find('@'), html.npos) << "all is filled in";
    }

    static size_t countOf(const std::string& text, const std::string& words) {
        size_t count = 0;
        for (size_t i = text.find(words); i != text.npos; i = text.find(words, i + 1)) ++count;
        return count;
    }

    tests::Outcome gather(const std::string& folder) const {
        return tests::run(SEAGLASS_PROGRAM, {{"report", folder}, {}, at("")});
    }
};

TEST_F(Reports, ShowWhatHasNoOther) {
    write("out/new.exr", square(4));
    write("ref/gone.png", square(4));
    writeBoth("sizes.png", square(4));
    write("out/sizes.png", {2, 2, std::vector<float>(16, 0.5f)});
    writeBoth("broken.png", square(4));
    tests::writeAll(at("out/broken.png"), "no picture");
    expectSays(compare({"--report", "report"}), 2, {"new.exr: no reference"});
    expectPictures("report", 5);
    for (const char* const words : {"<p>Test: <code>out/new.exr</code>, 40 &times; 24. It is tone-mapped",
                                    "<p>Reference: <code>ref/gone.png</code>, 40",
                                    "<p>Test: <code>out/sizes.png</code>, 2 &times; 2.</p>"})
        EXPECT_NE(page().find(words), std::string::npos) << words;
}

TEST_F(Reports, ZoomInOnTheWorstPlaces) {
    write("ref/a.png", square(4));
    write("out/a.png", square(24));
    writeBoth("faint.png", square(4));
    write("out/faint.png", square(4, 0.104f));
    expectSays(compare({"--report", "report"}), 1, {"a.png"});
    EXPECT_EQ(countOf(page(), "class=\"box\""), 3u) << "two of one, and where the other is greatest";
    EXPECT_EQ(countOf(page(), "class=\"zooms\""), 3u);
}

TEST_F(Reports, ShowValuesByTheirOwnScale) {
    demos::Picture height = square(4, -3);
    write("ref/height.exr", height);
    for (uint32_t x = 4; x < 10; ++x) height.rgba[4 * (width * 8 + x)] = -2.97f;
    write("out/height.exr", height);
    expectSays(compare({"--tolerant", "--report", "report", "--max-data", "0.02"}), 0, {});
    for (const char* const words : {"Values, no light: black is -3, white 0.5.", "difference map",
                                    ">0.02</span>", ">0.08 or more</span>", "6x1 at 4,8, 6 wrong pixels"})
        EXPECT_NE(page().find(words), std::string::npos) << words;
    demos::Error error;
    const std::optional<demos::Picture> shown =
        demos::readPicture(at("report/pictures/0/reference.png"), error);
    ASSERT_TRUE(shown) << error.text;
    EXPECT_EQ(shown->rgba[4 * (width * 8 + 4)], 0);
    EXPECT_EQ(shown->rgba[0], 1);
}

TEST_F(Reports, TabulateASequencesChanges) {
    for (int i = 0; i < 3; ++i) writeBoth("a_000" + std::to_string(i) + ".png", square(4));
    write("out/a_0001.png", square(20));
    expectSays(compare({"--tolerant", "--report", "report"}), 1, {"a_*.png: the change to a_0001.png"});
    EXPECT_NE(page().find("<tr><td>a_0002.png</td><td>0.0000</td><td>0."), std::string::npos);
    // By how much it is off, and not last.
    const nlohmann::json json = nlohmann::json::parse(tests::readAll(at("report/report.json")));
    EXPECT_EQ(json[3]["name"], "a_*.png");
    EXPECT_GT(json[3]["badness"], 1);
}

TEST_F(Reports, OfBlessShowOldAndNew) {
    write("ref/a.png", square(4));
    write("out/a.png", square(20));
    write("out/new.png", square(4));
    writeBoth("same.png", square(4));
    expectSays(bless({"--report", "page"}), 1, {"a.png: FLIP mean", "new.png: new", "report: "});
    expectPictures("page", 4);
    EXPECT_NE(page("page").find("<title>2 new or different</title>"), std::string::npos);
    EXPECT_EQ(page("page").find("same.png"), std::string::npos);
    EXPECT_FALSE(fs::exists(at("ref/new.png")));
    expectSays(bless({"--report", "out/page"}), 2, {"is within out, which is read"});
}

TEST_F(Reports, OfSeveralAreOnePage) {
    writeBoth("menu #1/a.png", square(4));
    writeBoth("game/b.png", square(4));
    write("out/game/b.png", square(20));
    for (const std::string name : {"menu #1", "game"})
        tests::run(
            SEAGLASS_PROGRAM,
            {{"compare", "ref/" + name, "out/" + name, "--tolerant", "--report", "all/" + name}, {}, at("")});
    fs::create_directory(at("all/none"));
    fs::create_directory(at("all/bad"));
    tests::writeAll(at("all/bad/report.json"), "{\"name\": 3}");
    expectSays(gather("all"), 0, {"report: "});
    const std::string html = page("all");
    EXPECT_NE(html.find("<title>2 of 3 failed</title>"), html.npos);
    const size_t bad = html.find("</span>bad</h2>"), game = html.find("</span>game/b.png</h2>"),
                 menu = html.find("</span>menu #1/a.png</h2>");
    EXPECT_TRUE(bad < game && game < menu && menu != html.npos) << "the worst first";
    EXPECT_NE(html.find("src=\"menu%20%231/pictures/0/test.png\""), html.npos);
    EXPECT_NE(html.find("url('game/pictures/0/flip.png')"), html.npos);
    EXPECT_NE(html.find("name=\"viewgame/pictures/0/\""), html.npos) << "a choice of its own";
    EXPECT_EQ(html.find('@'), html.npos);
}

TEST_F(Reports, OfNoneAreRefused) {
    fs::create_directory(at("empty"));
    expectSays(gather("empty"), 2, {"empty: no folder in it has a report.json"});
    expectSays(gather("nowhere"), 2, {"nowhere: is no folder"});
    expectSays(gather(""), 2, {"the word after report is empty, expected a value"});
}

} // namespace
