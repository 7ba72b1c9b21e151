// Where cameras and meshes are at a time, by their keyframes: a pure function of time. CPU only.
#pragma once

#include "scene/surroundings.h"

namespace demos {

/// Without keyframes as it is. Else places go through them by cubic Hermite splines, angles by the short way,
/// both with continuous speed; before time 0 and after the last keyframe it stands still, or it loops. What
/// comes back stands still.
CameraDesc cameraAt(const CameraDesc& camera, double timeS);
MeshDesc meshAt(const MeshDesc& mesh, double timeS);

/// Whether the last keyframe, of which there must be one, is the pose at time 0.
bool endsWhereItBegins(const CameraDesc& camera);
bool endsWhereItBegins(const MeshDesc& mesh);

} // namespace demos
