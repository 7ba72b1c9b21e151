// Where the scene of boxes is looked at from.
#pragma once

#include <vector>

#include "tests/unit/cameras.h"

namespace tests {

inline Camera testCamera() {
    Camera camera;
    camera.eye = {-1, 2.2, 9};
    camera.target = {-0.5, 1.2, 0};
    camera.width = 480; // both divide by 8
    camera.height = 272;
    return camera;
}

struct Pose {
    const char* name;
    Camera camera;
};

inline std::vector<Pose> poses() {
    const Camera level = testCamera();
    Camera roll35 = level;
    roll35.rollDegrees = 35;
    Camera roll90 = level;
    roll90.rollDegrees = 90;
    Camera steep = level;
    steep.eye = {-2, 16, 0};
    steep.target = {-2, 0, -5.8};
    Camera grazing = level;
    grazing.eye = {-1, 0.35, 9};
    grazing.target = {-0.8, 0.4, 0};
    return {{"level", level}, {"roll35", roll35}, {"roll90", roll90}, {"steep", steep}, {"grazing", grazing}};
}

/// By parallel lines of sight.
inline std::vector<Pose> parallelPoses() {
    Camera low;
    low.eye = {-1, 3, 12};
    low.target = {-1, 0.6, 0};
    low.parallelHeight = 8;
    low.near = 0.5;
    low.far = 140;
    low.width = 480;
    low.height = 272;
    Camera roll35 = low;
    roll35.rollDegrees = 35;
    Camera roll90 = low;
    roll90.rollDegrees = 90;
    Camera steep = low;
    steep.eye = {-2, 20, 8};
    steep.target = {-2, 0, -5.8};
    steep.parallelHeight = 16;
    // The far plane just under the water: mirror images lie far beyond it.
    steep.far = 30;
    Camera aside = low;
    aside.offCentre = {0.3, -0.4};
    return {{"low", low}, {"roll35", roll35}, {"roll90", roll90}, {"steep", steep}, {"aside", aside}};
}

/// Eyes and lenses at the limits: close to the plane, in it, below it and far above; one pixel wide; nearly
/// all of a half space.
inline std::vector<Camera> extremeCameras() {
    std::vector<Camera> cameras;
    for (const double height : {1e-3, 0.0, -1e-3, -2.0, 1e5}) {
        Camera camera = testCamera();
        camera.width = 96;
        camera.height = 54;
        camera.eye.y = height;
        cameras.push_back(camera);
    }
    Camera narrow = testCamera();
    narrow.fovDegrees = 1;
    narrow.width = 1;
    narrow.height = 64;
    cameras.push_back(narrow);
    Camera wide = testCamera();
    wide.fovDegrees = 179;
    wide.near = 1e-4;
    wide.width = 127;
    wide.height = 3;
    cameras.push_back(wide);
    return cameras;
}

} // namespace tests
