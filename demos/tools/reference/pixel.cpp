#include "reference/pixel.h"

#include <cmath>

#include "reference/light/air.h"
#include "reference/light/water_light.h"
#include "reference/shade/shade_bed.h"
#include "reference/shade/shade_floor.h"
#include "reference/shade/shade_water.h"

namespace demos::reference {

namespace {

glm::vec3 background(const Frame& frame, const Ray& ray) {
    const glm::vec3& direction = ray.direction;
    const Light& light = frame.world->light;
    const auto soft = static_cast<float>(softEdgeOfSun(static_cast<double>(frame.pixelAngle)));
    const glm::vec3 sun =
        light.sunDisc(direction, frame.desc.samples > 1 ? 0.1f * static_cast<float>(sunRadius) : soft);
    const glm::vec3 sky = glm::min(light.sky(direction) + sun, glm::vec3(60000));
    return skyThroughAir(frame, ray.origin + ray.nearest * direction, direction, sky);
}

} // namespace

void PixelSum::add(const Frame& frame, uint32_t x, uint32_t y, uint32_t sample) {
    const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
    Random random(y * frame.desc.width + x, sample, frame.desc.seed);
    Random* const chance = frame.desc.samples > 1 ? &random : nullptr;
    // Each of several stands for its own part: textures that are blurred by the whole pixel would be blurred
    // twice.
    const float width = 1 / std::sqrt(static_cast<float>(frame.desc.samples));
    Ray ray = frame.rayThrough(corner + (chance ? random.inPixel() : glm::vec2(0.5f)), width);
    ray.inWater = isInWater(frame, ray.origin + ray.direction * ray.nearest);
    ++count_;
    Hit hit;
    if (!frame.geometry.trace(ray, Kind::everything, hit)) {
        sum_ += ray.inWater ? endlessWater(frame, ray) : background(frame, ray);
    } else if (hit.kind == Kind::opaque) {
        sum_ += ray.inWater ? bedInWater(frame, ray, hit, chance)
                            : throughAirToEye(frame, ray, hit, shadeHit(frame, ray, hit, chance));
    } else if (frame.world->floor) {
        sum_ += throughAirToEye(frame, ray, hit, shadeFloor(frame, ray, hit, chance));
    } else {
        const WaterRadiance water = shadeWater(frame, ray, hit, mostBounces, chance);
        waterSum_ +=
            ray.inWater ? water.radiance : throughAirToEye(frame, ray, hit, water.radiance, water.weight);
        waterWeight_ += water.weight;
        ++waterCount_;
    }
}

glm::vec3 PixelSum::mean() const {
    glm::vec3 sum = sum_;
    if (waterCount_ > 0) sum += waterSum_ * (static_cast<float>(waterCount_) / waterWeight_);
    return sum / static_cast<float>(count_);
}

} // namespace demos::reference
