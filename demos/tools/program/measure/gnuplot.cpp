#include "program/measure/gnuplot.h"

#include <cerrno>
#include <cstring>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace demos {

namespace {

class SpawnActions {
  public:
    SpawnActions() { posix_spawn_file_actions_init(&actions_); }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    posix_spawn_file_actions_t* get() { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

/// Ours in a locale whose characters the scripts are written in: in the C locale gnuplot warns of its own
/// degree sign.
std::vector<char*> utf8Environment() {
    static char locale[] = "LC_ALL=C.UTF-8";
    std::vector<char*> variables;
    for (char** variable = environ; *variable; ++variable)
        if (std::strncmp(*variable, "LC_ALL=", 7) != 0) variables.push_back(*variable);
    variables.push_back(locale);
    variables.push_back(nullptr);
    return variables;
}

} // namespace

Plotted runGnuplot(const std::filesystem::path& script, Error& error) {
    std::string program = "gnuplot", file = script.filename().string();
    char* const words[] = {program.data(), file.data(), nullptr};
    SpawnActions actions;
    posix_spawn_file_actions_addchdir_np(actions.get(), script.parent_path().c_str());
    std::vector<char*> environment = utf8Environment();
    pid_t child = 0;
    const int problem = posix_spawnp(&child, "gnuplot", actions.get(), nullptr, words, environment.data());
    if (problem == ENOENT) {
        error.text = "gnuplot was not found (Debian: gnuplot-nox), so there are no plots";
        return Plotted::noGnuplot;
    }
    int status = 0;
    while (problem == 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (problem == 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return Plotted::yes;
    error.text = script.string() + ": gnuplot failed" +
                 (problem != 0 ? std::string(": ") + std::strerror(problem) : std::string());
    return Plotted::failed;
}

} // namespace demos
