// The command line of seaglass view.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "program/device/device_options.h"
#include "program/scene_options.h"

namespace demos {

struct ViewOptions {
    RenderOptions picture;       ///< of which outputs and what a measurement needs stay unset
    std::optional<double> stepS; ///< none: by the clock
    bool endless = true;         ///< --frames was not given
    uint32_t frames = 1;
    std::filesystem::path screenshot; ///< of the last frame; empty takes none
    bool paused = false;
    bool panel = true;
    std::string split;              ///< technique of the right half; empty: one picture, or
    bool splitReference = false;    ///< it is ray traced
    uint32_t referenceSamples = 64; ///< of each of its pixels
};

/// What the line says, before any of it is checked.
struct RawView : RawScene, RawDevice {
    std::string aov, frames, step, screenshot, split, spp;
    bool paused = false, noPanel = false;
};

void describeView(CLI::App& command, RawView& raw);
std::optional<ViewOptions> checkView(const RawView& raw, Error& error);

} // namespace demos
