#include "scene/offset.h"

#include <utility>

#include "scene/water_plane.h"

namespace demos {

namespace {

void moveWater(WaterDesc& water, const Vec3& offset) {
    const auto [x, y, z, d] = waterPlane(water);
    water.levelM += offset[1] + (x * offset[0] + z * offset[2]) / y;
    if (!water.extent) return;
    const Vec3 moved = alongPlane({x, y, z, 0}, offset);
    water.extent->centerM[0] += moved[0];
    water.extent->centerM[1] += moved[2];
}

} // namespace

void applyOffset(Scene& scene, CameraDesc& camera) {
    const Vec3 offset = std::exchange(camera.offsetM, {});
    const auto move = [&offset](Vec3& place) {
        for (size_t i = 0; i < 3; ++i) place[i] += offset[i];
    };
    for (MeshDesc& mesh : scene.meshes) {
        move(mesh.positionM);
        for (MeshKeyframe& keyframe : mesh.keyframes) move(keyframe.positionM);
    }
    if (scene.water) moveWater(*scene.water, offset);
    if (scene.water && scene.water->shore) move(scene.water->shore->positionM);
    if (scene.water)
        for (ExclusionVolumeDesc& volume : scene.water->exclusionVolumes) move(volume.positionM);
    if (scene.fog) scene.fog->baseHeightM += offset[1];
    if (scene.floor) move(scene.floor->pointM);
    move(camera.positionM);
    move(camera.targetM);
    for (CameraKeyframe& keyframe : camera.keyframes) {
        move(keyframe.positionM);
        move(keyframe.targetM);
    }
}

void moveCameras(Scene& scene, const Vec3& offset) {
    for (CameraDesc& camera : scene.cameras) {
        for (size_t i = 0; i < 3; ++i) {
            camera.positionM[i] += offset[i];
            camera.targetM[i] += offset[i];
            camera.offsetM[i] -= offset[i];
            for (CameraKeyframe& keyframe : camera.keyframes) {
                keyframe.positionM[i] += offset[i];
                keyframe.targetM[i] += offset[i];
            }
        }
    }
}

} // namespace demos
