// The command line of seaglass report.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace CLI {
class App;
}

namespace demos {

struct GatherOptions {
    std::filesystem::path folder; ///< holds a folder for each report
};

struct RawGather {
    std::string folder;
};

void describeGather(CLI::App& command, RawGather& raw);
std::optional<GatherOptions> checkGather(const RawGather& raw, Error& error);

} // namespace demos
