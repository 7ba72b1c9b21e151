// The techniques that are measured: all that a scene file can name, so that a later one needs nothing here.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace demos::measure {

struct Technique {
    std::string name, quality;
    std::vector<std::string> settings; ///< of the surface's reflection, as --set takes them
    bool part = true; ///< whether the surface has a reflection at all; without, it mirrors the sky as well
    bool isPreset =
        false; ///< `quality` is one of the library's, of water as the scene has it: a floor has none
};

std::span<const Technique> techniques();

/// Those with one of the names, all if none is given. Null with `error` set when there is none of a name.
std::optional<std::vector<const Technique*>> chooseTechniques(const std::vector<std::string>& names,
                                                              Error& error);

} // namespace demos::measure
