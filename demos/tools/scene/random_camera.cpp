#include "scene/random_camera.h"

#include <cmath>
#include <numbers>
#include <random>

#include "scene/water_plane.h"

namespace demos {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Standard distributions differ between libraries; their engine does not.
class Dice {
  public:
    explicit Dice(uint32_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
    }

  private:
    std::mt19937 engine_;
};

double heightOver(const Scene& scene, const Vec3& point) {
    if (scene.water) return alongPlane(waterPlane(*scene.water), point)[1];
    return point[1] - (scene.floor ? scene.floor->pointM[1] : 0);
}

} // namespace

CameraDesc randomCamera(const Scene& scene, uint32_t number) {
    Dice dice(number);
    const auto chosen = static_cast<size_t>(dice.between(0, static_cast<double>(scene.cameras.size())));
    CameraDesc camera = scene.cameras[chosen];
    camera.loops = false;
    camera.keyframes.clear();
    camera.name = randomCameraName(number);
    camera.orthographicHeightM = 0;
    const Vec3 from = camera.positionM, to = camera.targetM;
    const double away = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);

    const double aside = 0.5 * away * std::sqrt(dice.between(0, 1)),
                 towards = dice.between(0, 2 * std::numbers::pi);
    camera.positionM[0] += aside * std::cos(towards);
    camera.positionM[2] += aside * std::sin(towards);
    const double height = heightOver(scene, from);
    const bool inWater = height < 0;
    // Not into the bed.
    const double higher = std::pow(10, dice.between(-1, inWater ? 0 : 0.5));
    camera.positionM[1] += height * higher - heightOver(scene, camera.positionM);

    const double yaw =
        std::atan2(to[2] - from[2], to[0] - from[0]) + dice.between(-100 * degree, 100 * degree);
    const double pitch =
        inWater ? dice.between(-20 * degree, 70 * degree) : dice.between(-50 * degree, 5 * degree);
    const Vec3 sight = {std::cos(yaw) * std::cos(pitch), std::sin(pitch), std::sin(yaw) * std::cos(pitch)};
    for (size_t i = 0; i < 3; ++i) camera.targetM[i] = camera.positionM[i] + away * sight[i];
    const double roll = dice.between(-360, 360);
    camera.rollDeg = std::abs(roll) < 90 ? roll : 0;
    camera.verticalFovDeg = dice.between(25, 80);
    return camera;
}

} // namespace demos
