#include "tests/gpu/rig/near_plane.h"

#include <cmath>

namespace tests {

using namespace seaglass;

NearPlaneCount countNearPlane(const WaterPicture& picture, const Camera& camera, const Sea& sea, double time,
                              double clear) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    std::vector<double> points, above;
    std::vector<size_t> pixels;
    for (uint32_t y = 0; y < picture.height; y += 3)
        for (uint32_t x = 0; x < picture.width; x += 7) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const glm::dvec3 start = camera.eye + ray * (camera.near / glm::dot(ray, forward));
            points.insert(points.end(), {start.x, start.z});
            above.push_back(start.y);
            pixels.push_back(size_t{y} * picture.width + x);
        }
    std::vector<HeightSample> heights(pixels.size());
    sampleHeights(sea, time, points.data(), heights.size(), heights.data());
    NearPlaneCount count;
    for (size_t i = 0; i < pixels.size(); ++i) {
        const double height = above[i] - double{heights[i].height};
        if (std::abs(height) < clear) continue;
        (height < 0 ? count.wet : count.dry) += 1;
        count.wrong += picture.covered(pixels[i]) != (height < 0);
    }
    return count;
}

} // namespace tests
