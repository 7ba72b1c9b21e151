#include "tests/program/run.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tests {

namespace fs = std::filesystem;

namespace {

/// What a child runs: either.
struct Program {
    fs::path file;
    Main main = nullptr;
};

/// The child's side: never returns.
[[noreturn]] void become(const Program& program, const RunDesc& desc, const fs::path& out,
                         const fs::path& err) {
    const int flags = O_CREAT | O_WRONLY | O_TRUNC;
    const bool caught = dup2(open(out.c_str(), flags, 0600), STDOUT_FILENO) >= 0 &&
                        dup2(open(err.c_str(), flags, 0600), STDERR_FILENO) >= 0;
    if (!caught || (!desc.folder.empty() && chdir(desc.folder.c_str()) != 0)) _exit(126);
    for (const auto& [name, value] : desc.environment) setenv(name.c_str(), value.c_str(), 1);
    if (desc.largestFile > 0) {
        std::signal(SIGXFSZ, SIG_IGN); // writing then fails as it does on a full disk
        const rlimit limit = {desc.largestFile, desc.largestFile};
        if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(126);
    }
    std::vector<std::string> words = {program.main ? "seaglass" : program.file.string()};
    words.insert(words.end(), desc.arguments.begin(), desc.arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    if (program.main) {
        const int code = program.main(static_cast<int>(words.size()), pointers.data());
        std::fflush(nullptr);
        _exit(code); // what libraries do at exit waits for their threads, which a fork leaves behind
    }
    execv(program.file.c_str(), pointers.data());
    _exit(127);
}

/// The child's status as waitpid() gives it.
int statusOf(pid_t child, const fs::path& interruptOnce) {
    int status = 0;
    for (bool interrupt = !interruptOnce.empty();;) {
        const pid_t ended = waitpid(child, &status, interrupt ? WNOHANG : 0);
        if (ended == child) return status;
        if (ended < 0 && errno != EINTR) throw std::runtime_error("cannot wait");
        std::error_code ignored;
        if (interrupt && fs::exists(interruptOnce, ignored)) {
            kill(child, SIGINT);
            interrupt = false;
        }
        if (interrupt) usleep(2000);
    }
}

Outcome outcomeOf(const Program& program, const RunDesc& desc) {
    const TemporaryFolder caught;
    const fs::path out = caught.path() / "out", err = caught.path() / "err";
    std::fflush(nullptr); // else the child prints what this process is about to
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) become(program, desc, out, err);
    const int status = statusOf(child, desc.interruptOnce);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readAll(out), readAll(err)};
}

} // namespace

Outcome run(const fs::path& program, const RunDesc& desc) {
    return outcomeOf({program}, desc);
}

Outcome run(Main main, const RunDesc& desc) {
    return outcomeOf({{}, main}, desc);
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "seaglass-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string readAll(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void writeAll(const fs::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

size_t countLines(const std::string& text) {
    std::istringstream stream(text);
    size_t lines = 0;
    for (std::string line; std::getline(stream, line);) lines += line.empty() ? 0 : 1;
    return lines;
}

} // namespace tests
