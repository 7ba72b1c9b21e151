#pragma once

#include <gtest/gtest.h>

#include "tests/program/run.h"

namespace tests {

/// Exit code 2 and one line with all of `words` in it, nothing on stdout.
inline void expectRefused(const Outcome& outcome, const std::vector<std::string>& words) {
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(countLines(outcome.err), 1u) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const std::string& word : words) {
        EXPECT_NE(outcome.err.find(word), std::string::npos) << "'" << word << "' is not in: " << outcome.err;
    }
}

} // namespace tests
