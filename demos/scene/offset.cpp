#include "scene/offset.h"

#include <utility>

namespace demos {

void applyOffset(Scene& scene, CameraDesc& camera) {
    const Vec3 offset = std::exchange(camera.offsetM, {});
    const auto move = [&offset](Vec3& place) {
        for (size_t i = 0; i < 3; ++i) place[i] += offset[i];
    };
    for (MeshDesc& mesh : scene.meshes) move(mesh.positionM);
    if (scene.water) scene.water->levelM += offset[1];
    if (scene.water && scene.water->extent) {
        scene.water->extent->centerM[0] += offset[0];
        scene.water->extent->centerM[1] += offset[2];
    }
    if (scene.water && scene.water->shore) move(scene.water->shore->positionM);
    if (scene.water)
        for (DryRoomDesc& room : scene.water->dryRooms) move(room.positionM);
    if (scene.floor) move(scene.floor->pointM);
    move(camera.positionM);
    move(camera.targetM);
}

void moveCameras(Scene& scene, const Vec3& offset) {
    for (CameraDesc& camera : scene.cameras) {
        for (size_t i = 0; i < 3; ++i) {
            camera.positionM[i] += offset[i];
            camera.targetM[i] += offset[i];
            camera.offsetM[i] -= offset[i];
        }
    }
}

} // namespace demos
