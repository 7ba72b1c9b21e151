#include "program/interrupt.h"

#include <csignal>

namespace demos {

namespace {

volatile std::sig_atomic_t wish = 0;

void remember(int signal) {
    wish = 1;
    std::signal(signal, SIG_DFL);
}

} // namespace

Interrupt::Interrupt() {
    wish = 0;
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
}

Interrupt::~Interrupt() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool Interrupt::wished() const {
    return wish != 0;
}

} // namespace demos
