// The command line of seaglass measure.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "program/compare/values.h"

namespace CLI {
class App;
}

namespace demos {

struct MeasureOptions {
    std::vector<std::filesystem::path> scenes; ///< empty takes those of demos/scenes that mirror
    std::filesystem::path folder;
    Size size;
    uint32_t rounds = 20;
    uint32_t samples = 1;                ///< of the reference, a pixel
    uint32_t supersample = 1;            ///< of the pictures, each way
    std::vector<std::string> techniques; ///< empty takes all
    std::vector<std::string> cameras;    ///< of every scene; empty takes all
    std::vector<std::string> overrides;
    bool firstCameraOnly = false;
    bool flat = false;
    bool strict = false; ///< what is not drawn as a mesh's file says it is an error
    std::string device;  ///< part of its name; empty takes the best
};

/// What the line says, before any of it is checked.
struct RawMeasure {
    std::vector<std::string> scenes, techniques, cameras, overrides;
    std::string folder, size, rounds, samples, supersample, randomCameras, device;
    bool quick = false, flat = false, strict = false;
};

void describeMeasure(CLI::App& command, RawMeasure& raw);
std::optional<MeasureOptions> checkMeasure(const RawMeasure& raw, Error& error);

} // namespace demos
