// Views that nobody chose: beside the reference they show faults which a scene's own cameras have long been
// cleared of.
#pragma once

#include "scene/scene.h"

namespace demos {

/// A function of the scene and `number` alone: by one of the scene's cameras, as far aside as half the way to
/// its target, on the same side of the surface from a tenth to three times as high over it, turned, tipped,
/// and one in four rolled. It may stand inside of something.
CameraDesc randomCamera(const Scene& scene, uint32_t number);

} // namespace demos
