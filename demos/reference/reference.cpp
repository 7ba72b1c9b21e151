#include "reference/reference.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "reference/shade_bed.h"
#include "reference/shade_floor.h"
#include "reference/shade_water.h"
#include "reference/water_light.h"

namespace demos::reference {
namespace {

glm::vec3 background(const Frame& frame, const glm::vec3& direction) {
    const Light& light = frame.world->light;
    const auto soft = static_cast<float>(softEdgeOfSun(static_cast<double>(frame.pixelAngle)));
    const glm::vec3 sun =
        light.sunDisc(direction, frame.desc.samples > 1 ? 0.1f * static_cast<float>(sunRadius) : soft);
    return glm::min(light.sky(direction) + sun, glm::vec3(60000));
}

/// A pixel's samples. Those that fall on water count by the area of the facets they met, but together no more
/// than their number.
glm::vec3 colorOf(const Frame& frame, uint32_t x, uint32_t y) {
    const uint32_t samples = frame.desc.samples;
    const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
    glm::vec3 sum(0), waterSum(0);
    float waterWeight = 0;
    uint32_t waterCount = 0;
    for (uint32_t i = 0; i < samples; ++i) {
        Random random(y * frame.desc.width + x, i, frame.desc.seed);
        Random* const chance = samples > 1 ? &random : nullptr;
        Ray ray = frame.rayThrough(corner + (chance ? random.inPixel() : glm::vec2(0.5f)));
        ray.inWater = isInWater(frame, ray.direction * ray.nearest);
        Hit hit;
        if (!frame.geometry.trace(ray, Kind::everything, hit)) {
            sum += ray.inWater ? endlessWater(frame, ray) : background(frame, ray.direction);
        } else if (hit.kind == Kind::opaque) {
            sum += ray.inWater ? bedInWater(frame, ray, hit, chance) : shadeHit(frame, ray, hit, chance);
        } else if (frame.world->floor) {
            sum += shadeFloor(frame, ray, hit, chance);
        } else {
            const WaterRadiance water = shadeWater(frame, ray, hit, mostBounces, chance);
            waterSum += water.radiance;
            waterWeight += water.weight;
            ++waterCount;
        }
    }
    if (waterCount > 0) sum += waterSum * (static_cast<float>(waterCount) / waterWeight);
    return sum / static_cast<float>(samples);
}

Picture emptyPicture(const Frame& frame) {
    return {frame.desc.width, frame.desc.height,
            std::vector<float>(size_t(frame.desc.width) * frame.desc.height * 4)};
}

void renderRow(const Frame& frame, uint32_t y, Pictures& out) {
    for (uint32_t x = 0; x < frame.desc.width; ++x) {
        const size_t at = (size_t(y) * frame.desc.width + x) * 4;
        const glm::vec3 color = colorOf(frame, x, y);
        for (int c = 0; c < 3; ++c) out.color.rgba[at + static_cast<size_t>(c)] = color[c];
        out.color.rgba[at + 3] = 1;
        if (out.truth.rgba.empty()) continue;
        const Truth truth = truthAt(frame, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        out.truth.rgba[at] = static_cast<float>(truth.kind);
        out.truth.rgba[at + 1] = truth.pixel.x;
        out.truth.rgba[at + 2] = truth.pixel.y;
        out.truth.rgba[at + 3] = truth.distance;
        for (int c = 0; c < 3; ++c) out.mirrored.rgba[at + static_cast<size_t>(c)] = truth.radiance[c];
        out.mirrored.rgba[at + 3] = 1;
    }
}

} // namespace

Pictures renderReference(const Frame& frame, bool withTruth, const ProgressFunction& progress) {
    Pictures out;
    out.color = emptyPicture(frame);
    if (withTruth) out.truth = out.mirrored = emptyPicture(frame);
    std::atomic<uint32_t> next{0};
    std::mutex told;
    uint32_t done = 0;
    const auto work = [&] {
        for (uint32_t y = next++; y < frame.desc.height; y = next++) {
            renderRow(frame, y, out);
            const std::scoped_lock lock(told);
            ++done;
            if (progress && !progress(done, frame.desc.height)) next = frame.desc.height;
        }
    };
    const uint32_t threads =
        frame.desc.threads > 0 ? frame.desc.threads : std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> others;
    for (uint32_t i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
    return out;
}

} // namespace demos::reference
