#pragma once

#include <string>
#include <vector>

#include "program/exit_code.h"

namespace demos {

/// What became of one picture.
struct Judged {
    std::string name;
    ExitCode code = ok;
    std::string why;          ///< one line; empty when all is well
    std::string json;         ///< the measures; empty where none were taken
    std::string section = {}; ///< of the report, with @FOLDER@ for the way to its pictures; likewise
    double badness = 0;       ///< the greatest measure as a multiple of its limit
    bool advice = false;      ///< by references of another driver: what differs fails nothing
};

/// What it is called.
constexpr const char* verdict(const Judged& one) {
    if (one.code == badInput) return "bad input";
    return one.code == ok ? "same" : one.advice ? "advice" : "different";
}

/// What counts of it.
constexpr ExitCode gating(const Judged& one) {
    return one.advice && one.code == different ? ok : one.code;
}

} // namespace demos
