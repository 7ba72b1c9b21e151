// The command line of seaglass bless.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace CLI {
class App;
}

namespace demos {

struct BlessOptions {
    std::filesystem::path reference, test;
    std::set<std::filesystem::path> names; ///< within the folders; empty: all, if `yes`
    bool yes = false;
    std::string driver; ///< that made the test's pictures; empty: this machine's first that is supported
    bool otherDriver = false;
    bool advice = false;          ///< references of another driver are kept beside, for it alone
    std::filesystem::path report; ///< of what is new or differs; empty: none
};

struct RawBless {
    std::string reference, test, driver, report;
    std::vector<std::string> names;
    bool yes = false, otherDriver = false, advice = false;
};

void describeBless(CLI::App& command, RawBless& raw);
std::optional<BlessOptions> checkBless(const RawBless& raw, Error& error);

} // namespace demos
