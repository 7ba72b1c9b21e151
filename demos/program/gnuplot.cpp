#include "program/gnuplot.h"

#include <cerrno>
#include <cstring>

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

} // namespace

Plotted runGnuplot(const std::filesystem::path& script, Error& error) {
    std::string program = "gnuplot", file = script.filename().string();
    char* const words[] = {program.data(), file.data(), nullptr};
    SpawnActions actions;
    posix_spawn_file_actions_addchdir_np(actions.get(), script.parent_path().c_str());
    pid_t child = 0;
    const int problem = posix_spawnp(&child, "gnuplot", actions.get(), nullptr, words, environ);
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
