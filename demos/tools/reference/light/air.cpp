#include "reference/light/air.h"

#include <algorithm>

namespace demos::reference {
namespace {

constexpr double endless = 1e9; // [m]

/// Of a point relative to the eye; on a globe over the ball, on which fog lies.
double heightOf(const Frame& frame, const glm::vec3& position) {
    const World& world = *frame.world;
    const glm::dvec2 away(position.x, position.z);
    return (world.light.axes * (frame.camera.eye + glm::dvec3(position))).y +
           world.globe.dropAt(glm::dot(away, away));
}

glm::vec3 fogged(const seaglass::FogDesc& fog, const glm::vec3& radiance, const glm::vec3& sky, double passes,
                 float weight) {
    const glm::vec3 own(fog.color[0], fog.color[1], fog.color[2]);
    return glm::mix(weight * glm::mix(own, sky, fog.fromSky), radiance, static_cast<float>(passes));
}

/// As seaglass_fogSight() and seaglass_fogMip() of medium.glsl.
glm::vec3 skyOfFog(const Light& light, const glm::vec3& direction) {
    const glm::dvec3 d = light.axes * glm::dvec3(direction);
    const auto mips = static_cast<float>(light.filtered.cube.mips.size());
    return sampleCube(light.filtered.cube, {d.x, std::max(d.y, 0.03), d.z}, std::max(mips - 6, 0.0f));
}

} // namespace

glm::vec3 throughAir(const Frame& frame, const glm::vec3& from, const glm::vec3& direction, float way,
                     const glm::vec3& radiance, float weight) {
    const auto& fog = frame.world->fog;
    if (!fog) return radiance;
    const double begins = heightOf(frame, from), ends = heightOf(frame, from + way * direction);
    const double passes = seaglass::fogTransmittance(*fog, begins, ends - begins, static_cast<double>(way));
    const glm::vec3 sky = fog->fromSky > 0 ? skyOfFog(frame.world->light, direction) : glm::vec3(0);
    return fogged(*fog, radiance, sky, passes, weight);
}

glm::vec3 throughAirToEye(const Frame& frame, const Ray& ray, const Hit& hit, const glm::vec3& radiance,
                          float weight) {
    const float begins = frame.camera.parallel() ? ray.nearest : 0;
    return throughAir(frame, ray.origin + begins * ray.direction, ray.direction, hit.distance - begins,
                      radiance, weight);
}

glm::vec3 skyThroughAir(const Frame& frame, const glm::vec3& from, const glm::vec3& direction,
                        const glm::vec3& sky) {
    const auto& fog = frame.world->fog;
    if (!fog || !fog->overSky) return sky;
    const double rise = (frame.world->light.axes * glm::dvec3(direction)).y * endless;
    return fogged(*fog, sky, sky, seaglass::fogTransmittance(*fog, heightOf(frame, from), rise, endless), 1);
}

} // namespace demos::reference
