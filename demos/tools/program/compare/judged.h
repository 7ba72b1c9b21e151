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
    std::string section = {}; ///< of the report; likewise
    double badness = 0;       ///< the greatest measure as a multiple of its limit
};

constexpr const char* toString(ExitCode code) {
    return code == ok ? "same" : code == different ? "different" : "bad input";
}

} // namespace demos
