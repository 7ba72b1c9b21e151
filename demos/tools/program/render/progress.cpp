#include "program/render/progress.h"

#include <cstdio>

#include <unistd.h>

namespace demos {

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), started_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    clear();
}

void Progress::say(const std::string& what) {
    if (!terminal_) return;
    std::fprintf(stderr, "\r\033[K%s", what.c_str());
    std::fflush(stderr);
    shown_ = true;
}

void Progress::say(const std::string& what, uint32_t done, uint32_t all) {
    using Seconds = std::chrono::duration<double>;
    const double passed = Seconds(std::chrono::steady_clock::now() - started_).count();
    std::string line = what + " " + std::to_string(done) + "/" + std::to_string(all);
    if (done > 0 && done < all) {
        const double left = passed / done * (all - done);
        line += ", " + std::to_string(static_cast<long>(left + 0.5)) + " s left";
    }
    say(line);
}

void Progress::clear() {
    if (!shown_) return;
    std::fputs("\r\033[K", stderr);
    shown_ = false;
}

} // namespace demos
