// References of one driver gate, those of others advise.
#include "tests/program/screenshots/folders.h"

namespace {

namespace fs = std::filesystem;
using tests::expectSays;

class Drivers : public tests::Folders {
  protected:
    Drivers() {
        writeBoth("deep/a.png", square(4));
        EXPECT_EQ(bless({"--yes", "--driver", "one 1.0"}).code, 0);
        fs::remove_all(at("ref"));
        EXPECT_EQ(bless({"--yes", "--driver", "one 1.0"}).code, 0);
        write("out/deep/a.png", square(20));
    }
};

TEST_F(Drivers, TheReferencesOwnGates) {
    expectSays(compare({"--tolerant"}), 1, {"different: deep/a.png"});
    expectSays(compare({"--tolerant", "--driver", "one 1.0"}), 1, {"different: deep/a.png"});
}

TEST_F(Drivers, AnotherAdvises) {
    const tests::Outcome outcome =
        compare({"--tolerant", "--driver", "two", "--junit", "a.xml", "--json", "a.json"});
    expectSays(outcome, 0,
               {"advice alone: pictures are of 'two', references ref of 'one 1.0'", "advice: deep/a.png: "});
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(tests::readAll(at("a.xml")).find("failures=\"0\""), std::string::npos);
    EXPECT_NE(tests::readAll(at("a.xml")).find("<system-out>advice: "), std::string::npos);
    EXPECT_NE(tests::readAll(at("a.json")).find("\"verdict\": \"advice\""), std::string::npos);
    tests::writeAll(at("out/deep/a.png"), "no picture");
    expectSays(compare({"--driver", "two"}), 2, {"not compared: deep/a.png"});
}

TEST_F(Drivers, AnotherKeepsItsOwnBeside) {
    expectSays(bless({"--yes", "--driver", "two (2)"}), 2, {"of the driver 'one 1.0' and this is 'two (2)'"});
    const std::string gating = tests::readAll(at("ref/deep/a.png"));
    expectSays(bless({"--yes", "--driver", "two (2)", "--advice"}), 0, {"renewed: ref@two-2/deep/a.png"});
    EXPECT_EQ(tests::readAll(at("ref/deep/a.png")), gating);
    EXPECT_EQ(tests::readAll(at("ref@two-2/deep/driver.txt")), "two (2)\n");
    expectSays(compare({"--driver", "two (2)"}), 0,
               {"references ref@two-2", "same: deep/a.png", "of 'two (2)'"});
    write("out/deep/a.png", square(24));
    expectSays(compare({"--driver", "two (2)"}), 0, {"advice: deep/a.png"});
    const tests::Outcome within = tests::run(
        SEAGLASS_PROGRAM, {{"compare", "ref/deep", "out/deep", "--driver", "two (2)"}, {}, at("")});
    expectSays(within, 0, {"ref@two-2/deep", "advice: a.png"});
}

} // namespace
