// Runs a program and catches what it says.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tests {

struct Outcome {
    int code = -1; ///< exit code, or -1 when a signal ended it
    std::string out, err;
};

struct RunDesc {
    std::vector<std::string> arguments;
    std::map<std::string, std::string> environment = {}; ///< added to this process's
    std::filesystem::path folder = {};                   ///< to run in; empty stays here
    size_t largestFile = 0;                   ///< bytes a file can grow to, as on a full disk; 0: no limit
    std::filesystem::path interruptOnce = {}; ///< SIGINT once this file is there; empty never
};

Outcome run(const std::filesystem::path& program, const RunDesc& desc);

using Main = int (*)(int argc, char** argv);
/// A program's main() in a process that is forked from this one, and so has its libraries: to load those of
/// seaglass, over 200 on Debian 12, takes 0.4 s. Before this process has started threads.
Outcome run(Main main, const RunDesc& desc);

/// A new, empty folder that goes with its owner.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

std::string readAll(const std::filesystem::path& file);
void writeAll(const std::filesystem::path& file, const std::string& content);
/// Names in a folder, sorted.
std::vector<std::string> namesIn(const std::filesystem::path& folder);
/// Lines of a text that are not empty.
size_t countLines(const std::string& text);

} // namespace tests
