// What the viewer saves: a scene that renders as what is seen, under a name that is free.
#pragma once

#include "view/view_state.h"

namespace demos {

/// The scene with what is seen as its first camera, "view", and its time as the scene's.
Scene savedScene(const ViewState& state);

/// STEM_0001EXTENSION in the folder, or the first such number that nothing is called yet.
std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& extension);

} // namespace demos
