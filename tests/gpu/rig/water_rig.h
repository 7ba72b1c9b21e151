// Draws water bodies into a picture of floats, with the scene behind given pixel by pixel.
#pragma once

#include <functional>
#include <optional>

#include "seaglass/water.h"
#include "tests/gpu/rig/rig.h"
#include "tests/unit/cameras.h"

namespace tests {

/// What the host's opaque scene left. Empty: nothing but sky.
struct SceneBehind {
    std::vector<float> color; ///< RGBA
    std::vector<float> depth;
};

struct WaterPicture {
    uint32_t width = 0, height = 0;
    std::vector<float> color; ///< RGBA; `untouched` where no water was drawn
    std::vector<float> depth;
    static constexpr float untouched = -1e4f;

    bool covered(size_t pixel) const { return color[pixel * 4 + 3] != untouched; }
};

class WaterTest : public GpuTest {
  protected:
    void SetUp() override;
    void TearDown() override;

    void useOwnContext();
    /// What is drawn into from here on, and resolved; 1 before.
    void useSamples(VkSampleCountFlagBits samples);
    /// Which way the target's depth runs from here on; reversed before.
    void useDepth(bool reversed);
    /// How scene and target hold colour from here on; linear before.
    void useEncoding(seaglass::Encoding encoding);
    /// From here on, water leaves the depth alone.
    void leaveDepth();
    /// From here on the sun stands there, with so much irradiance in each channel.
    void shineFrom(const glm::dvec3& unitToSun, float irradiance);
    seaglass::Body* makeBody(seaglass::BodyDesc desc);
    /// A frame: simulate at `time`, reflect, shade, draw.
    WaterPicture picture(const std::vector<seaglass::Body*>& bodies, const Camera& camera, double time = 0,
                         seaglass::SurfaceOutput output = seaglass::SurfaceOutput::shaded,
                         const SceneBehind& behind = {});

    /// From here on picture() multiplies what it clears with a body's caustics, and draws nothing. `lights`
    /// is kept.
    void drawCausticsOf(seaglass::Body* body, const seaglass::LightingDesc& lights);
    void drawCausticsOf(seaglass::Body* body) { drawCausticsOf(body, lighting); }

    /// Changes the view that both are told; null leaves it.
    std::function<void(seaglass::ViewDesc&)> changeView;
    /// Changes what reflect() is told of the view that draw() is told the truth of; null leaves it.
    std::function<void(seaglass::ViewDesc&)> misleadReflection;
    /// Recorded between simulate() and reflect(); null: nothing.
    std::function<void(VkCommandBuffer)> beforeReflection;
    /// Recorded before that pass; null: nothing.
    std::function<seaglass::Status(VkCommandBuffer, const seaglass::ViewDesc&)> beforeDrawing;
    /// From here on beforeDrawing shades the body, for `drawing`.
    void shadeBefore(seaglass::Body* body, seaglass::SurfaceOutput output = seaglass::SurfaceOutput::shaded);
    /// What picture() records in its pass, without shade() before; null: draw().
    std::function<seaglass::Status(VkCommandBuffer, seaglass::Target*, const seaglass::ViewDesc&)> drawing;
    seaglass::LightingDesc lighting; ///< no sun; the sky cube's radiance is 1, 2, 3

  private:
    demos::Image skyCube_;
    void makeTarget();

    seaglass::Target* target_ = nullptr;
    bool depthWrite_ = true, reversedDepth_ = true;
    seaglass::Encoding encoding_ = seaglass::Encoding::linear;
    VkSampleCountFlagBits samples_ = VK_SAMPLE_COUNT_1_BIT;
    std::vector<seaglass::Body*> bodies_;
};

/// The pixel's point on the surface, in the world.
glm::dvec3 worldAt(const Camera& camera, const WaterPicture& picture, uint32_t x, uint32_t y);

/// A pixel's line of sight: from the eye, or from the near plane where they are parallel. `along` is unit.
struct Line {
    glm::dvec3 from{0}, along{0};
};
Line lineThrough(const Camera& camera, uint32_t x, uint32_t y);
/// As its pixel's depth holds a point of the world.
float depthOf(const Camera& camera, const glm::dvec3& world);

/// The direction of a pixel's ray, unit.
glm::dvec3 rayThrough(const Camera& camera, uint32_t x, uint32_t y);
/// Black, and nothing in it.
SceneBehind nothingBehind(const Camera& camera);
/// A plane at height `bed`, of one radiance.
SceneBehind planeBelow(const Camera& camera, double bed, float radiance);

/// What stands before the rest, of one radiance, where `distanceAlong` a ray from the eye is positive.
template<typename DistanceAlong>
SceneBehind drawnOver(const Camera& camera, SceneBehind behind, float radiance,
                      const DistanceAlong& distanceAlong) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const double distance = distanceAlong(ray);
            if (!(distance > 0)) continue;
            const size_t i = size_t{y} * camera.width + x;
            behind.depth[i] = static_cast<float>(camera.near / (distance * glm::dot(ray, forward)));
            std::fill_n(&behind.color[i * 4], 3, radiance);
        }
    return behind;
}

/// A wind of 8 m/s, in few samples.
seaglass::SeaDesc breeze();

/// The angle of a pixel's ray below the horizon [rad].
double angleBelowHorizon(const Camera& camera, uint32_t x, uint32_t y);

} // namespace tests
