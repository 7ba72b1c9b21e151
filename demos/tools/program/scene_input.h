// What every command that draws a scene does first: read it, choose its camera, check where the pictures go.
#pragma once

#include "program/options.h"
#include "scene/camera_choice.h"

namespace demos {

/// The scene with --sky, --mesh and --set applied, in this order; to be looked at, with air where it says
/// nothing of fog.
std::optional<Scene> readScene(const RenderOptions& options, Error& error);

/// Everything that is read, for outputs to stay away from.
std::vector<std::filesystem::path> sceneFiles(const Scene& scene);

/// Whether every -o can be written and is none of the scene's own files.
bool checkPictures(const RenderOptions& options, const Scene& scene, Error& error);

/// Says where in the scene the file was named that could not be read.
void addPlace(const Scene& scene, Error& error);

} // namespace demos
