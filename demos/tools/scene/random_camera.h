// Views that nobody chose: beside the reference they show faults which a scene's own cameras have long been
// cleared of.
#pragma once

#include <string_view>

#include "scene/scene.h"

namespace demos {

inline constexpr std::string_view randomCameraPrefix = "random:";

inline std::string randomCameraName(uint32_t number) {
    return std::string(randomCameraPrefix) + std::to_string(number);
}

/// A function of the scene and `number` alone: by one of the scene's cameras, as far aside as half the way to
/// its target, on the same side of the surface from a tenth to three times as high over it, turned, tipped,
/// and one in four rolled. It may stand inside of something.
CameraDesc randomCamera(const Scene& scene, uint32_t number);

} // namespace demos
