#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace demos {

enum class Plotted { yes, noGnuplot, failed };

/// Runs gnuplot on a script in its folder. `error` is set unless it drew.
Plotted runGnuplot(const std::filesystem::path& script, Error& error);

} // namespace demos
