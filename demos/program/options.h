// The command line as plain data.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/host.h"
#include "program/compare_options.h"
#include "program/measure_options.h"
#include "program/sea_options.h"
#include "program/values.h"
#include "scene/scene.h"

namespace demos {

struct RenderOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs; ///< at least one; every one gets each frame
    Size size;
    uint32_t supersample = 1; ///< render so many times larger each way, then average
    std::optional<double> timeS;
    std::string camera; ///< empty takes the scene's first
    uint32_t frames = 1;
    bool numbered = false; ///< --frames was given
    double fps = 30;
    std::vector<std::string> overrides;
    Aov aov = Aov::color;
    Mistake mistake = Mistake::none;
    std::filesystem::path sky;  ///< instead of the scene's; empty keeps it
    std::filesystem::path mesh; ///< instead of the scene's; empty keeps them
    std::filesystem::path stats;
    std::string device;
    bool validation = false;
};

struct ReferenceOptions {
    RenderOptions picture; ///< of which what a device, a sequence or a measurement needs stays unset
    uint32_t samples = 1;  ///< of each pixel
    uint64_t seed = 1;
    std::filesystem::path truth;    ///< empty writes none
    std::filesystem::path mirrored; ///< likewise
};

struct Options {
    enum class Command { render, reference, compare, measure, sea, devices, printed };
    Command command = Command::printed; ///< printed: help or version, and all is done
    RenderOptions render;
    ReferenceOptions reference;
    CompareOptions compare;
    MeasureOptions measure;
    SeaOptions sea;
};

/// Null with `error` set when the line makes no sense. Prints help and version when asked to.
std::optional<Options> parseOptions(int argc, const char* const* argv, Error& error);

} // namespace demos
