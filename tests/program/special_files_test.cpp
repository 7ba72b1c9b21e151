// Names that stand for no file: pipes, sockets, devices, folders, links to nowhere. Nothing waits for them,
// reads them, or puts a file in their place; each is called what it is.
#include <filesystem>

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "demos/host/files/image_file.h"
#include "tests/program/refused.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;

struct Special {
    std::string name, says;
};

const Special specials[] = {{"pipe", "is a pipe"},
                            {"socket", "is a socket"},
                            {"device", "is a device"},
                            {"folder", "is a folder"},
                            {"link", "is a link to nowhere"},
                            {"loop", "cannot be read: Too many levels of symbolic links"},
                            {"none", "no such file"}};

class SpecialFiles : public testing::Test {
  protected:
    SpecialFiles() {
        tests::writeSample(folder_.path());
        const std::vector<uint8_t> rgb(3 * 16 * 12, 100);
        demos::Error error;
        EXPECT_TRUE(demos::writePng(at("good.png"), 16, 12, rgb, error)) << error.text;
    }

    fs::path at(const std::string& name) const { return folder_.path() / name; }

    /// A special file of that name and ending; its whole name.
    std::string make(const std::string& name, const std::string& ending) const {
        std::string whole = name + ending;
        const fs::path file = at(whole);
        fs::remove_all(file);
        if (name == "pipe") {
            EXPECT_EQ(mkfifo(file.c_str(), 0600), 0);
        }
        if (name == "socket") bindSocket(file);
        if (name == "device") fs::create_symlink("/dev/full", file);
        if (name == "folder") fs::create_directory(file);
        if (name == "link") fs::create_symlink("nowhere" + ending, file);
        if (name == "loop") fs::create_symlink(whole, file);
        return whole;
    }

    static void bindSocket(const fs::path& file) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        ASSERT_LT(file.string().size(), sizeof(address.sun_path));
        file.string().copy(address.sun_path, sizeof(address.sun_path) - 1);
        const int handle = socket(AF_UNIX, SOCK_STREAM, 0);
        EXPECT_EQ(bind(handle, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
        close(handle);
    }

    Outcome seaglass(const std::vector<std::string>& arguments) const {
        return tests::run(SEAGLASS_PROGRAM, {arguments, {}, at("")});
    }
    Outcome render(const std::vector<std::string>& more, const std::string& scene = "scene.toml") const {
        std::vector<std::string> arguments = {"render", scene, "-o", "out/a.png", "--size", "32x18"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return seaglass(arguments);
    }

    const tests::TemporaryFolder folder_;
};

TEST_F(SpecialFiles, AreCalledWhatTheyAre) {
    for (const Special& one : specials) {
        const std::string scene = make(one.name, ".toml"), picture = make(one.name, ".png");
        tests::expectRefused(render({}, scene), {scene + ": " + one.says + ", expected"});
        if (one.name == "folder") continue; // compared with a folder
        tests::expectRefused(seaglass({"compare", "good.png", picture}),
                             {picture + ": " + one.says + ", expected"});
        tests::expectRefused(seaglass({"bless", "good.png", picture, "--yes"}), {picture + ": ", one.says});
    }
}

TEST_F(SpecialFiles, AreNamedByWhateverReads) {
    const auto expectPipe = [&](const Outcome& outcome, const std::string& file) {
        tests::expectRefused(outcome, {file, "is a pipe", "expected"});
    };
    const std::string sky = make("pipe", ".exr"), mesh = make("pipe", ".gltf"), table = make("pipe", ".csv"),
                      picture = make("pipe", ".png");
    expectPipe(render({"--sky", sky}), sky);
    expectPipe(render({"--set", "sky.file=" + sky}), sky);
    expectPipe(render({"--mesh", mesh}), mesh);
    expectPipe(seaglass({"sea", "--wind", "5", "--spectrum", "table", "--table", table}), table);
    expectPipe(seaglass({"compare", "good.png", "good.png", "--mask", picture}), picture);
    expectPipe(seaglass({"compare", picture, "good.png"}), picture);
    EXPECT_TRUE(tests::namesIn(at("out")).empty());
}

// A file that is written is renamed to its name: whatever stood there would be gone.
TEST_F(SpecialFiles, StayWhereAFileWouldBeWritten) {
    for (const Special& one : specials) {
        if (one.name == "none" || one.name == "folder" || one.name == "socket") continue;
        const std::string picture = make(one.name, ".png");
        const fs::file_type before = fs::symlink_status(at(picture)).type();
        tests::expectRefused(seaglass({"bless", picture, "good.png", "--yes"}),
                             {picture, one.says, "expected"});
        EXPECT_EQ(fs::symlink_status(at(picture)).type(), before) << one.name;
        if (one.name == "link" || one.name == "loop") continue;
        const std::string json = make(one.name, ".json");
        tests::expectRefused(seaglass({"compare", "good.png", "good.png", "--json", json}),
                             {json, "expected"});
        tests::expectRefused(render({"-o", picture}), {picture, "expected"});
    }
}

// Of folders, too; and a note of the driver that is a pipe is no note, and stays.
TEST_F(SpecialFiles, AmongReferencesAreNamed) {
    fs::create_directories(at("ref"));
    fs::create_directories(at("new"));
    fs::copy_file(at("good.png"), at("new/one.png"));
    ASSERT_EQ(mkfifo(at("ref/one.png").c_str(), 0600), 0);
    tests::expectRefused(seaglass({"bless", "ref", "new", "--yes"}), {"ref/one.png: is a pipe", "expected"});
    fs::remove(at("ref/one.png"));
    ASSERT_EQ(mkfifo(at("ref/driver.txt").c_str(), 0600), 0);
    const Outcome outcome = seaglass({"bless", "ref", "new", "--yes", "--driver", "one 1.0"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("ref/driver.txt: is a pipe, expected"), std::string::npos) << outcome.err;
    EXPECT_TRUE(fs::is_fifo(at("ref/driver.txt")));
}

TEST_F(SpecialFiles, ThatAreEmptyAreNoPictures) {
    tests::writeAll(at("empty.png"), "");
    tests::expectRefused(seaglass({"compare", "good.png", "empty.png"}), {"empty.png: ", "expected"});
    tests::expectRefused(seaglass({"bless", "good.png", "empty.png", "--yes"}), {"empty.png: ", "expected"});
    tests::writeAll(at("empty.gltf"), "");
    tests::expectRefused(render({"--mesh", "empty.gltf"}), {"empty.gltf"});
}

TEST_F(SpecialFiles, ThatAreFullTakeNothingThatIsPrinted) {
    const Outcome outcome = tests::run(
        "/bin/sh",
        {{"-c", std::string(SEAGLASS_PROGRAM) + " compare good.png good.png > /dev/full"}, {}, at("")});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "standard output: cannot be written to, expected room for what is printed\n");
}

} // namespace
