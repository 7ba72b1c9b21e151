// A scene moved as a whole, to where a float no longer holds a place.
#pragma once

#include "scene/scene.h"

namespace demos {

/// Moves meshes, water or floor, and the camera by the camera's offset, which is zero from then on.
void applyOffset(Scene& scene, CameraDesc& camera);

/// Lets the scene's own cameras see it as before after it was moved by so much.
void moveCameras(Scene& scene, const Vec3& offset);

} // namespace demos
