#include "tests/view/xvfb.h"

#include <csignal>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tests {

namespace {

/// The server's side: never returns.
[[noreturn]] void become(int said) {
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    const std::string fd = std::to_string(said);
    execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "800x600x24", "-nolisten", "tcp",
           static_cast<char*>(nullptr));
    _exit(127);
}

/// The number that the server chose; empty when it ended without one.
std::string firstLine(int from) {
    std::string line;
    for (char c = 0; read(from, &c, 1) == 1 && c != '\n';) line += c;
    return line;
}

} // namespace

Xvfb::Xvfb() {
    int said[2] = {-1, -1};
    if (pipe(said) != 0) return;
    server_ = fork();
    if (server_ == 0) become(said[1]);
    close(said[1]);
    const std::string number = firstLine(said[0]);
    close(said[0]);
    if (!number.empty()) display_ = ":" + number;
}

Xvfb::~Xvfb() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

} // namespace tests
