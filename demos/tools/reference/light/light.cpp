#include "reference/light/light.h"

#include <cmath>
#include <numbers>

namespace demos::reference {
namespace {

constexpr float brightest = 60000; ///< what the host's half-float pictures are held to

} // namespace

bool makeLight(SkyImage image, const SkyDesc& sky, const SunDesc& sun, Light& out, Error& error) {
    if (!std::isfinite(sky.rotationDeg) || !(sky.intensity >= 0 && sky.intensity <= 1e6)) {
        error.text = "the sky's rotation must be finite and its intensity 0 to 1e6";
        return false;
    }
    out.image = std::move(image);
    if (!chooseSun(sky, sun, out.image, out.sun, error)) return false;
    out.rotationDeg = sky.rotationDeg;
    out.intensity = sky.intensity;
    out.filtered = filterSky(out.image, sky.rotationDeg, sky.intensity);
    return true;
}

glm::vec3 Light::sky(const glm::vec3& direction) const {
    const double angle = glm::radians(-rotationDeg), c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 d = axes * glm::dvec3(direction);
    const glm::vec3 radiance = sampleSky(image, {c * d.x - s * d.z, d.y, s * d.x + c * d.z});
    return glm::min(radiance * static_cast<float>(intensity), glm::vec3(brightest));
}

glm::vec3 Light::sunDisc(const glm::vec3& direction, float soft) const {
    if (sun.direction.y <= 0) return glm::vec3(0);
    constexpr auto radius = static_cast<float>(sunRadius);
    const float disc = 1 - glm::smoothstep(radius - soft, radius + soft, glm::length(direction - toSun()));
    const float above = glm::smoothstep(-soft, soft, static_cast<float>((axes * glm::dvec3(direction)).y));
    return sunIrradiance() / (std::numbers::pi_v<float> * radius * radius) * (disc * above);
}

glm::vec3 Light::cube(const glm::vec3& direction, float mip) const {
    return sampleCube(filtered.cube, axes * glm::dvec3(direction), mip);
}

glm::vec3 Light::irradiance(const glm::vec3& normal) const {
    const glm::vec3 n(axes * glm::dvec3(normal));
    const auto& sh = filtered.irradianceSh;
    const glm::vec3 e = sh[0] + sh[1] * n.y + sh[2] * n.z + sh[3] * n.x + sh[4] * (n.x * n.y) +
                        sh[5] * (n.y * n.z) + sh[6] * (3 * n.z * n.z - 1) + sh[7] * (n.x * n.z) +
                        sh[8] * (n.x * n.x - n.y * n.y);
    return glm::max(e, glm::vec3(0));
}

glm::vec3 Light::towardsSun(const glm::vec2& at) const {
    const glm::vec3 towards = toSun();
    const glm::vec3 other = std::abs(towards.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(towards, other));
    const float radius = static_cast<float>(sunRadius) * std::sqrt(at.x);
    const float turn = 2 * std::numbers::pi_v<float> * at.y;
    return glm::normalize(towards +
                          radius * (std::cos(turn) * right + std::sin(turn) * glm::cross(towards, right)));
}

} // namespace demos::reference
