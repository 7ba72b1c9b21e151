// The command line of seaglass render.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/host.h"
#include "program/compare/values.h"

namespace demos {

struct RenderOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs; ///< at least one; every one gets each frame
    Size size;
    bool lens = false;    ///< with air, bloom and antialiasing: to be looked at, not to be measured
    bool metered = false; ///< exposed by a light meter, not by the scene
    uint32_t supersample =
        0; ///< render so many times larger each way, then average; 0: 2 by the lens, else 1
    std::optional<double> timeS;
    std::string camera; ///< empty takes the scene's first
    uint32_t frames = 1;
    bool numbered = false; ///< --frames was given
    double fps = 30;
    std::vector<std::string> overrides;
    Aov aov = Aov::color;
    Mistake mistake = Mistake::none;
    std::string quality;        ///< of the water; empty leaves it as the scene has it
    std::filesystem::path sky;  ///< instead of the scene's; empty keeps it
    std::filesystem::path mesh; ///< instead of the scene's; empty keeps them
    bool strict = false;        ///< what is not drawn as a mesh's file says it is an error
    std::filesystem::path stats;
    bool untimed = false; ///< draws no more frames than are written
    std::string device;
    bool validation = false;
};

} // namespace demos
