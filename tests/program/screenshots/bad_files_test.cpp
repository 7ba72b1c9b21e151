// Files that cannot be compared: each is named, the others are compared, and nothing half-written is left.
#include <unistd.h>

#include "tests/program/screenshots/folders.h"

namespace {

namespace fs = std::filesystem;
using tests::expectSays;

class BadFiles : public tests::Folders {
  protected:
    BadFiles() {
        writeBoth("bad.png", square(4));
        writeBoth("good.png", square(4));
        writeBoth("other.png", square(4));
        write("out/other.png", square(20));
    }

    /// Also that the other two are compared, and what is written is whole.
    void expectNamed(const std::vector<std::string>& words) const {
        const tests::Outcome outcome =
            compare({"--report", "report", "--json", "a.json", "--junit", "a.xml", "--tolerant"});
        expectSays(outcome, 2, words);
        expectSays(outcome, 2, {"bad input: bad.png: ", "same: good.png", "different: other.png"});
        EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
        EXPECT_TRUE(tests::readAll(at("report/index.html")).ends_with("</html>\n"));
        EXPECT_TRUE(tests::readAll(at("a.json")).ends_with("}\n"));
        EXPECT_TRUE(tests::readAll(at("a.xml")).ends_with("</testsuites>\n"));
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_.path()))
            EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }
};

TEST_F(BadFiles, Corrupt) {
    std::string bytes = tests::readAll(at("out/bad.png"));
    bytes.resize(bytes.size() / 2);
    tests::writeAll(at("out/bad.png"), bytes);
    expectNamed({"out/bad.png: ", "expected a PNG, EXR or HDR picture"});
}

TEST_F(BadFiles, Empty) {
    tests::writeAll(at("out/bad.png"), "");
    expectNamed({"out/bad.png: is no picture that is known, expected PNG, EXR or HDR"});
}

TEST_F(BadFiles, Huge) {
    // A header alone that says 60000 x 60000.
    std::string bytes = tests::readAll(at("out/bad.png"));
    bytes.replace(16, 8, std::string("\x00\x00\xea\x60\x00\x00\xea\x60", 8));
    tests::writeAll(at("out/bad.png"), bytes);
    expectNamed({"out/bad.png: "});
}

TEST_F(BadFiles, OfBytesThatNoTerminalTakes) {
    tests::writeAll(at("out/bad.exr"),
                    std::string("\x76\x2f\x31\x01\x02\0\0\0na\r\n\x1b[2J\xff\0int\0\xff\xff\xff\x7f", 26));
    write("ref/bad.exr", square(4));
    const tests::Outcome outcome = compare();
    EXPECT_EQ(outcome.code, 2);
    for (const std::string& text : {outcome.out, outcome.err}) {
        EXPECT_NE(text.find("bad.exr: "), text.npos) << text;
        EXPECT_EQ(text.find_first_of("\r\x1b\xff"), text.npos) << text;
    }
    EXPECT_EQ(tests::countLines(outcome.out), 4u) << outcome.out;
}

TEST_F(BadFiles, OfAnotherSize) {
    demos::Picture small{2, 2, std::vector<float>(16, 0.5f)};
    write("out/bad.png", small);
    expectNamed({"ref/bad.png is 40x24 and out/bad.png is 2x2, expected one size"});
}

TEST_F(BadFiles, AFolderForAFile) {
    fs::remove(at("out/bad.png"));
    fs::create_directory(at("out/bad.png"));
    expectNamed({"out/bad.png: is a folder, expected a picture"});
}

TEST_F(BadFiles, WithoutPermission) {
    fs::permissions(at("ref/bad.png"), fs::perms::none);
    std::vector<std::string> command = {SEAGLASS_PROGRAM, "compare", "ref", "out"};
    if (geteuid() == 0) { // who may read anything, so somebody else does it
        fs::permissions(at(""), fs::perms::all);
        command.insert(command.begin(),
                       {"/usr/bin/setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups"});
    }
    const std::string program = command.front();
    command.erase(command.begin());
    const tests::Outcome outcome = tests::run(program, {command, {}, at("")});
    expectSays(outcome, 2,
               {"bad input: bad.png: ref/bad.png: cannot be read: Permission denied", "same: good.png",
                "different: other.png"});
}

TEST_F(BadFiles, ALinkToNowhere) {
    fs::remove(at("ref/bad.png"));
    fs::create_symlink("nowhere.png", at("ref/bad.png"));
    expectNamed({"ref/bad.png: is a link to nowhere, expected a picture"});
}

TEST_F(BadFiles, ALinkToItself) {
    fs::remove(at("out/bad.png"));
    fs::create_symlink("bad.png", at("out/bad.png"));
    expectNamed({"out/bad.png: "});
}

} // namespace
