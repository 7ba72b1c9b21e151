// What depends on how much a pixel shows is the same however the camera is turned.
#include <cmath>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// Twice as wide as high, and so wide that pixels beside the middle are a good deal smaller.
Camera upright(const glm::dvec3& eye, const glm::dvec3& target) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.fovDegrees = 50;
    camera.width = 192;
    camera.height = 96;
    return camera;
}

/// The same pixels, in a picture that stands on its side.
Camera onItsSide(Camera camera) {
    camera.fovDegrees =
        2 / radians(1) * std::atan(std::tan(radians(camera.fovDegrees) / 2) * camera.width / camera.height);
    std::swap(camera.width, camera.height);
    camera.rollDegrees = 90;
    return camera;
}

class PixelWidth : public WaterTest {
  protected:
    /// How far the two pictures of `seen` are apart, as a share of how much one varies.
    template<typename Seen>
    static double apart(const Camera& camera, Seen&& seen, size_t channel = 1) {
        const WaterPicture whole = seen(camera), turned = seen(onItsSide(camera));
        double off = 0, sum = 0, squares = 0, count = 0;
        for (uint32_t y = 0; y < whole.height; ++y)
            for (uint32_t x = 0; x < whole.width; ++x) {
                const size_t i = size_t{y} * whole.width + x;
                const size_t j = size_t{turned.height - 1 - x} * turned.width + y;
                const double a = whole.color[i * 4 + channel], b = turned.color[j * 4 + channel];
                if (whole.color[i * 4 + 3] == WaterPicture::untouched) continue;
                off += (a - b) * (a - b);
                sum += a;
                squares += a * a;
                ++count;
            }
        EXPECT_GT(count, 5000);
        const double deviation = std::sqrt(squares / count - sum * sum / (count * count));
        std::printf("apart by %.4f, varies by %.4f\n", std::sqrt(off / count), deviation);
        return std::sqrt(off / count) / deviation;
    }

    BodyDesc desc_;
};

/// A wall before the water's far end, in waves of light that are some pixels long.
SceneBehind stripedWall(const Camera& camera) {
    SceneBehind behind;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const double away = (-10 - camera.eye.z) / ray.z;
            const glm::dvec3 at = camera.eye + away * ray;
            const bool hit = away > 0 && at.y > 0;
            const double light = hit ? 2 + std::sin(5 * at.x) * std::sin(5 * at.y) : 0;
            behind.depth.push_back(
                static_cast<float>(hit ? camera.near / (away * glm::dot(ray, forward)) : 0));
            const auto value = static_cast<float>(light);
            behind.color.insert(behind.color.end(), {value, value, value, 1});
        }
    return behind;
}

TEST_F(PixelWidth, BlursReflectionsAlikeInACameraOnItsSide) {
    ReflectionDesc reflection;
    reflection.technique = ReflectionTechnique::ssr;
    reflection.edgeFade = 0;
    reflection.clearDistance = 0;
    reflection.scatter = 0.06f;
    desc_.reflection = &reflection;
    Body* const body = makeBody(desc_);
    const double off = apart(upright({0, 2, 8}, {0, 1.5, 0}), [&](const Camera& camera) {
        return picture({body}, camera, 0, SurfaceOutput::reflection, stripedWall(camera));
    });
    EXPECT_LT(off, 0.03);
}

TEST_F(PixelWidth, MakesMeshesAsFineInACameraOnItsSide) {
    SeaDesc sea;
    sea.windSpeed = 7;
    sea.fetch = 20e3f;
    sea.samples = 128;
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    desc_.mesh.cellSize = 0.1f;
    Body* const body = makeBody(desc_);
    for (const double height : {3.0, 5.0, 8.0, 12.0, 20.0}) {
        const double off = apart(
            upright({0, height, 0}, {0, 0, -2 * height}),
            [&](const Camera& camera) { return picture({body}, camera, 7, SurfaceOutput::height); }, 0);
        EXPECT_LT(off, 0.03) << height;
    }
}

TEST_F(PixelWidth, BlursCausticsAlikeInACameraOnItsSide) {
    SeaDesc sea;
    sea.windSpeed = 5;
    sea.fetch = 2e3f;
    sea.samples = 128;
    sea.cascades = 3;
    sea.largestPatch = 16;
    const RefractionDesc refraction{{0, 0, 0}, {0, 0, 0}, 1};
    const CausticsDesc caustics;
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    desc_.refraction = &refraction;
    desc_.caustics = &caustics;
    for (float& channel : lighting.sunIrradiance) channel = 5;
    for (float& channel : lighting.skyIrradiance) channel = 0;
    Body* const body = makeBody(desc_);
    drawCausticsOf(body);
    const double off = apart(upright({3, 40, 7}, {3, 0, 6.9}), [&](const Camera& camera) {
        WaterPicture p = picture({body}, camera, 2, SurfaceOutput::shaded, planeBelow(camera, -1.5, 1));
        for (size_t i = 0; i < p.color.size(); ++i) p.color[i] /= WaterPicture::untouched;
        return p;
    });
    EXPECT_LT(off, 0.03);
}

} // namespace
