// The command line of seaglass sea.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace CLI {
class App;
}

namespace demos {

struct SeaOptions {
    WavesDesc waves;
    bool json = false;
    std::filesystem::path plot; ///< empty draws none
};

/// What the line says, before any of it is checked.
struct RawSea {
    std::string wind, fetch, depth, spectrum, table, spreading, shape, swell, beaufort, samples, cascades,
        patch, seed, plot;
    bool uncapped = false, json = false;
};

void describeSea(CLI::App& command, RawSea& raw);
std::optional<SeaOptions> checkSea(const RawSea& raw, Error& error);

} // namespace demos
