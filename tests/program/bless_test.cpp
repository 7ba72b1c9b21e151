// seaglass bless: what it lists, what it renews, and when it renews nothing.
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "demos/host/files/image_file.h"
#include "tests/program/refused.h"
#include "tests/program/run.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;

class Bless : public testing::Test {
  protected:
    Bless() {
        write("ref/same.png", 100);
        write("out/same.png", 100);
        write("ref/other.png", 100);
        write("out/other.png", 140);
        write("out/deep/new.png", 100);
        write("ref/gone.png", 100);
    }

    Outcome bless(std::vector<std::string> more) const {
        more.insert(more.begin(), {"bless", "ref", "out", "--driver", "one 1.0"});
        return tests::run(SEAGLASS_PROGRAM, {more, {}, at("")});
    }

    fs::path at(const std::string& name) const { return folder_.path() / name; }

    void write(const std::string& name, uint8_t grey) const {
        fs::create_directories(at(name).parent_path());
        const std::vector<uint8_t> rgb(3 * 16 * 12, grey);
        demos::Error error;
        ASSERT_TRUE(demos::writePng(at(name), 16, 12, rgb, error)) << error.text;
    }

    void expectBlessed(const std::string& name, bool blessed) const {
        EXPECT_EQ(tests::readAll(at("ref/" + name)) == tests::readAll(at("out/" + name)), blessed) << name;
    }

    const tests::TemporaryFolder folder_;
};

TEST_F(Bless, ListsWhatDiffersAndRenewsNothingUnasked) {
    const Outcome outcome = bless({});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err, "2 left as they were, expected their names, or --yes for all\n");
    EXPECT_NE(outcome.out.find("deep/new.png: new\n  old: ref/deep/new.png\n  new: out/deep/new.png\n"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("other.png: FLIP mean 0."), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("; 1 of pixels differ, by at most 0.1569\n"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(outcome.out.find("same.png"), std::string::npos) << outcome.out;
    expectBlessed("other.png", false);
    EXPECT_FALSE(fs::exists(at("ref/deep")));
    EXPECT_FALSE(fs::exists(at("ref/driver.txt")));
}

TEST_F(Bless, RenewsWhatIsNamed) {
    const Outcome outcome = bless({"deep/new.png"});
    EXPECT_EQ(outcome.code, 1) << "the other is left";
    EXPECT_NE(outcome.out.find("renewed: ref/deep/new.png\n"), std::string::npos) << outcome.out;
    expectBlessed("deep/new.png", true);
    expectBlessed("other.png", false);
    EXPECT_EQ(tests::readAll(at("ref/deep/driver.txt")), "one 1.0\n");
    tests::expectRefused(bless({"other.png", "no.png"}), {"no.png: no such picture in out"});
    expectBlessed("other.png", false);
}

TEST_F(Bless, RenewsAllWithYes) {
    const Outcome outcome = bless({"--yes"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expectBlessed("deep/new.png", true);
    expectBlessed("other.png", true);
    EXPECT_TRUE(fs::exists(at("ref/gone.png"))) << "nothing is taken away";
    EXPECT_EQ(bless({}).code, 0) << "nothing is left";
}

TEST_F(Bless, RefusesReferencesOfAnotherDriver) {
    tests::writeAll(at("ref/driver.txt"), "other 2.0\n");
    const Outcome refused = bless({"--yes"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(tests::countLines(refused.err), 1u);
    EXPECT_NE(refused.err.find("of the driver 'other 2.0' and this is 'one 1.0', expected that one"),
              std::string::npos)
        << refused.err;
    expectBlessed("other.png", false);
    EXPECT_FALSE(fs::exists(at("ref/deep")));
    EXPECT_EQ(bless({"--yes", "--other-driver"}).code, 0);
    expectBlessed("other.png", true);
    EXPECT_EQ(tests::readAll(at("ref/driver.txt")), "one 1.0\n");
}

TEST_F(Bless, RefusesWhatIsNoPicture) {
    tests::writeAll(at("out/broken.png"), "no picture");
    tests::expectRefused(bless({"--yes"}), {"out/broken.png"});
    fs::remove(at("out/broken.png"));
    demos::Error error;
    demos::Picture nan{2, 1, {0, 0, 0, 1, 0, 0, 0, 1}};
    nan.rgba[4] = std::numeric_limits<float>::quiet_NaN();
    ASSERT_TRUE(demos::writeExr(at("out/nan.exr"), nan, error));
    tests::expectRefused(bless({"--yes"}), {"out/nan.exr: NaN or infinity in 1 pixels"});
    expectBlessed("other.png", false);
}

TEST_F(Bless, SaysWhatIsInItsWay) {
    const auto refused = [&](const std::string& reference, const std::string& test,
                             const std::string& words) {
        tests::expectRefused(
            tests::run(SEAGLASS_PROGRAM, {{"bless", reference, test, "--yes", "--driver", "x"}, {}, at("")}),
            {words});
    };
    refused("ref", "out/same.png", "ref: is a folder, expected a file as out/same.png is");
    refused("ref/same.png", "out", "ref/same.png: is a file, expected a folder");
    refused("ref", "nowhere", "nowhere: no such file or folder");
}

TEST_F(Bless, TakesOneFile) {
    const Outcome outcome =
        tests::run(SEAGLASS_PROGRAM,
                   {{"bless", "ref/other.png", "out/other.png", "--yes", "--driver", "x"}, {}, at("")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expectBlessed("other.png", true);
}

} // namespace
