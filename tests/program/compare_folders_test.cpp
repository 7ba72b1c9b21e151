// seaglass compare of whole folders.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "demos/host/files/image_file.h"
#include "tests/program/refused.h"
#include "tests/program/run.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;

constexpr uint32_t width = 40, height = 24;

class CompareFolders : public testing::Test {
  protected:
    CompareFolders() {
        for (const std::string name : {"a.png", "deep/er/b.png", "c.png"}) {
            write("ref/" + name);
            write("out/" + name);
        }
    }

    Outcome compare(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all = {"compare", "ref", "out"};
        all.insert(all.end(), more.begin(), more.end());
        return tests::run(SEAGLASS_PROGRAM, {all, {}, at("")});
    }

    fs::path at(const std::string& name) const { return folder_.path() / name; }

    /// Grey, with a darker square of `spot` pixels a side.
    void write(const std::string& name, uint32_t spot = 0, uint32_t wide = width) const {
        fs::create_directories(at(name).parent_path());
        std::vector<uint8_t> rgb(3 * wide * height, 128);
        for (uint32_t i = 0; i < spot * spot * 3; ++i) rgb[3 * wide * (i / (3 * spot)) + i % (3 * spot)] = 20;
        demos::Error error;
        ASSERT_TRUE(demos::writePng(at(name), wide, height, rgb, error)) << error.text;
    }

    const tests::TemporaryFolder folder_;
};

void expectSays(const Outcome& outcome, int code, const std::string& words) {
    EXPECT_EQ(outcome.code, code) << outcome.err << outcome.out;
    EXPECT_EQ(tests::countLines(outcome.err), code == 0 ? 0u : 1u) << outcome.err;
    EXPECT_NE((code == 0 ? outcome.out : outcome.err).find(words), std::string::npos)
        << outcome.err << outcome.out;
}

TEST_F(CompareFolders, EqualOnesAreTheSame) {
    expectSays(compare(), 0, "same: a.png\nsame: c.png\nsame: deep/er/b.png\n");
}

TEST_F(CompareFolders, NamesEachThatDiffersAndWhatIsInOneAlone) {
    write("out/deep/er/b.png", 6);
    write("out/new.png");
    fs::remove(at("out/c.png"));
    const Outcome outcome = compare({"--tolerant"});
    expectSays(outcome, 1, "deep/er/b.png: ");
    EXPECT_NE(outcome.out.find("FLIP over 0.15 lie together"), std::string::npos) << outcome.out;
    expectSays(outcome, 1, "c.png: no picture out/c.png, expected one as ref/c.png");
    expectSays(outcome, 1,
               "new.png: no reference ref/new.png, expected one: seaglass bless ref out new.png makes it");
    EXPECT_NE(outcome.out.find("same: a.png\n"), std::string::npos) << outcome.out;
}

TEST_F(CompareFolders, WhatCannotBeReadKeepsNothingElseBack) {
    write("out/deep/er/b.png", 6);
    write("out/a.png", 0, width + 1);
    fs::remove(at("ref/c.png"));
    fs::create_symlink("nowhere.png", at("ref/c.png"));
    fs::create_directory(at("out/folder.png"));
    write("ref/folder.png");
    tests::writeAll(at("ref/text.png"), "no picture");
    write("out/text.png");
    const Outcome outcome = compare();
    expectSays(outcome, 2, "a.png: ref/a.png is 40x24 and out/a.png is 41x24, expected one size");
    expectSays(outcome, 2, "c.png: ref/c.png: is a link to nowhere, expected a picture");
    expectSays(outcome, 2, "folder.png: out/folder.png: is a folder, expected a picture");
    expectSays(outcome, 2, "text.png: ref/text.png: ");
    expectSays(outcome, 2, "different: deep/er/b.png: ");
    EXPECT_EQ(tests::countLines(outcome.out), 5u) << outcome.out;
}

TEST_F(CompareFolders, AFolderOfNoneFails) {
    fs::remove_all(at("ref"));
    expectSays(compare({"--junit", "c.xml"}), 1,
               "a.png: no reference ref/a.png, expected one: seaglass bless ref out a.png makes it");
    EXPECT_NE(tests::readAll(at("c.xml")).find("tests=\"3\" failures=\"3\""), std::string::npos);
    fs::create_symlink("nowhere", at("ref"));
    expectSays(compare(), 2, "ref: is a link to nowhere, expected a folder");
    fs::remove(at("ref"));
    fs::create_directory(at("ref"));
    fs::remove_all(at("out"));
    expectSays(compare(), 2, "out is not there and ref a folder, expected two of a kind");
    fs::create_directory(at("out"));
    expectSays(compare(), 2, "no pictures, expected PNG, EXR or HDR");
    tests::writeAll(at("file.png"), "");
    const Outcome outcome = tests::run(SEAGLASS_PROGRAM, {{"compare", "ref", "file.png"}, {}, at("")});
    expectSays(outcome, 2, "file.png is a file and ref a folder");
}

TEST_F(CompareFolders, LinkedFoldersAreNotPassedOver) {
    fs::create_directory_symlink(at("ref"), at("ref/again"));
    expectSays(compare(), 2, "again: ref/again: is a link to a folder");
}

TEST_F(CompareFolders, WritesJsonAndJUnit) {
    write("out/c.png", 6);
    write("out/<&\"new\">.png");
    tests::writeAll(at("out/a.png"), "no picture");
    expectSays(compare({"--json", "c.json", "--junit", "c.xml", "--tolerant"}), 2, "not compared: a.png");
    const nlohmann::json json = nlohmann::json::parse(tests::readAll(at("c.json")));
    EXPECT_FALSE(json["same"]);
    ASSERT_EQ(json["pictures"].size(), 4u);
    EXPECT_EQ(json["pictures"][1]["verdict"], "bad input");
    EXPECT_EQ(json["pictures"][2]["verdict"], "different");
    EXPECT_EQ(json["pictures"][2]["measures"]["wrong"]["blob"]["max_pixels"], 16);
    EXPECT_GE(json["pictures"][2]["measures"]["wrong"]["blob"]["pixels"], 36);
    EXPECT_EQ(json["pictures"][3]["verdict"], "same");
    const std::string xml = tests::readAll(at("c.xml"));
    EXPECT_NE(xml.find("tests=\"4\" failures=\"2\" errors=\"1\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("name=\"&lt;&amp;&quot;new&quot;&gt;.png\"><failure message=\"no reference"),
              std::string::npos)
        << xml;
    EXPECT_NE(xml.find("name=\"deep/er/b.png\"/>"), std::string::npos) << xml;
}

TEST_F(CompareFolders, AFullDiskKeepsNoVerdictBack) {
    write("out/c.png", 6);
    const Outcome outcome = tests::run(
        SEAGLASS_PROGRAM, {{"compare", "ref", "out", "--tolerant", "--json", "j.json"}, {}, at(""), 64});
    expectSays(outcome, 2, "j.json: cannot be written, is the disk full?; different: c.png: ");
    EXPECT_TRUE(outcome.out.starts_with("same: a.png\ndifferent: c.png: ")) << outcome.out;
    EXPECT_FALSE(fs::exists(at("j.json")));
}

TEST_F(CompareFolders, NamesMayHoldAnything) {
    write("out/it's new.png");
    write("out/\xe9\x01\xc3\xa9\xed\xa0\x80.png");
    const Outcome outcome = compare({"--junit", "c.xml", "--json", "c.json", "--report", "report"});
    expectSays(outcome, 1, R"(: seaglass bless ref out 'it'\''s new.png' makes it)");
    const std::string xml = tests::readAll(at("c.xml"));
    EXPECT_NE(xml.find("name=\"??\xc3\xa9???.png\""), std::string::npos) << "of Latin-1: " << xml;
    EXPECT_EQ(nlohmann::json::parse(tests::readAll(at("c.json")))["pictures"].size(), 5u);
}

TEST_F(CompareFolders, TheReportShowsAllWorstFirst) {
    write("out/c.png", 6);
    write("out/a.png", 12);
    write("out/<new>.png");
    expectSays(compare({"--report", "report", "--tolerant"}), 1, "c.png");
    const std::string page = tests::readAll(at("report/index.html"));
    const auto place = [&page](const std::string& name) {
        const size_t found = page.find("</span>" + name + "</h2>");
        EXPECT_NE(found, std::string::npos) << name;
        return found;
    };
    EXPECT_NE(page.find("<title>3 of 4 failed</title>"), std::string::npos);
    EXPECT_LT(place("a.png"), place("c.png"));
    EXPECT_LT(place("c.png"), place("&lt;new&gt;.png"));
    EXPECT_LT(place("&lt;new&gt;.png"), place("deep/er/b.png"));
    EXPECT_NE(page.find("<section class=\"passed\">\n<h2><span class=\"verdict same\">same</span>deep"),
              std::string::npos);
    EXPECT_EQ(page.find('@'), std::string::npos) << "all is filled in";
    EXPECT_EQ(page.find("http"), std::string::npos) << "nothing from elsewhere";
    size_t shown = 0;
    for (size_t at = page.find("src=\""); at != page.npos; at = page.find("src=\"", at + 1), ++shown) {
        const std::string file = page.substr(at + 5, page.find('"', at + 5) - at - 5);
        EXPECT_TRUE(fs::exists(folder_.path() / "report" / file)) << file;
    }
    EXPECT_EQ(shown, 10u) << "what is new, too";
}

TEST_F(CompareFolders, TheReportIsNotAmongWhatItReads) {
    expectSays(compare({"--report", "out/report"}), 2, "--report out/report: is within out, which is read");
    EXPECT_FALSE(fs::exists(at("out/report")));
}

TEST_F(CompareFolders, OneFileWritesJUnitAsWell) {
    const Outcome outcome = tests::run(
        SEAGLASS_PROGRAM, {{"compare", "ref/a.png", "out/no.png", "--junit", "c.xml"}, {}, at("")});
    expectSays(outcome, 2, "out/no.png");
    EXPECT_NE(tests::readAll(at("c.xml")).find("<error message=\"out/no.png"), std::string::npos);
}

} // namespace
