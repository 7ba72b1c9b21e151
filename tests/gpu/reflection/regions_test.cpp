// Regions of larger targets, as dynamic resolution uses them, and cameras whose projection is jittered.
#include <algorithm>
#include <limits>

#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Regions : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {
  protected:
    ReflectorDesc desc() const {
        ReflectorDesc reflector;
        reflector.reflection.technique = GetParam();
        return reflector;
    }
};

/// A larger target that holds `garbage` beside the region.
TracedView amidst(float garbage, const TracedView& traced, uint32_t left, uint32_t top) {
    TracedView larger = framed(traced, left, top);
    for (uint32_t y = 0; y < larger.height; ++y)
        for (uint32_t x = 0; x < larger.width; ++x) {
            const bool inside = x >= left && y >= top && x < left + traced.width && y < top + traced.height;
            if (inside) continue;
            const size_t i = size_t{y} * larger.width + x;
            larger.depth[i] = garbage;
            std::fill_n(larger.color.begin() + static_cast<ptrdiff_t>(i * 4), 4, garbage);
        }
    return larger;
}

TEST_P(Regions, AreTheSamePictureToTheBit) {
    for (const bool reduced : {false, true})
        for (const bool odd : {false, true}) {
            Camera camera = testCamera();
            if (odd) {
                camera.rollDegrees = 50; // so that what lies over a border would be mirrored into the picture
                camera.width = 237;
                camera.height = 131;
            }
            ReflectorDesc wanted = desc();
            wanted.reflection.downscale = reduced ? 2 : 1;
            wanted.reflection.coarseKeys = reduced;
            wanted.reflection.overhangSamples = 6; // which reach far
            std::vector<Box> boxes = harbourOfBoxes();
            boxes.push_back({{-90, -1, -30}, {90, 4, -28}}); // seen and mirrored at the borders too
            const TracedView traced = Tracer(camera, boxes).run();
            const Reflected tight = reflectScene(camera, traced, wanted);
            for (const uint32_t corner : {0u, 13u}) {
                ViewDesc view = viewDesc(camera);
                view.viewport.x = static_cast<float>(corner);
                view.viewport.y = static_cast<float>(corner);
                // From frames before: what is no number, what stands before the eye, what stands in the
                // scene.
                for (const float garbage : {std::numeric_limits<float>::quiet_NaN(), 0.7f, 0.007f}) {
                    const TracedView around = amidst(garbage, traced, corner, corner);
                    const Reflected part = reflectView(around, view, wanted);
                    EXPECT_EQ(part.info, tight.info) << corner;
                    EXPECT_EQ(part.color, tight.color) << corner;
                }
            }
        }
}

/// Where in the picture the point shows that a pixel mirrors, as its hit distance tells.
glm::dvec2 sourceOf(const Camera& camera, const glm::dvec2& pixel, double distance) {
    const glm::dvec2 size(camera.width, camera.height);
    const glm::dmat4 clip = projectionMatrix(camera) * viewMatrix(camera);
    const glm::dvec2 ndc = pixel / size * 2.0 - 1.0;
    const glm::dvec4 through = glm::inverse(clip) * glm::dvec4(ndc, 0.5, 1);
    const glm::dvec3 ray = glm::normalize(glm::dvec3(through) / through.w - camera.eye);
    glm::dvec3 point = camera.eye + ray * (-camera.eye.y / ray.y + distance);
    point.y = -point.y;
    const glm::dvec4 seen = clip * glm::dvec4(point, 1);
    return (glm::dvec2(seen) / seen.w * 0.5 + 0.5) * size;
}

TEST_P(Regions, JitteredProjectionsKeepTheirPlaces) {
    // Of Halton's sequence to the bases 2 and 3, and a whole pixel.
    for (const glm::dvec2 jitter :
         {glm::dvec2(0, -1.0 / 6), glm::dvec2(-0.25, 1.0 / 6), glm::dvec2(0.25, -7.0 / 18),
          glm::dvec2(-0.375, -1.0 / 18), glm::dvec2(0.4375, 0.4814), glm::dvec2(1, -1)}) {
        Camera camera = testCamera();
        camera.rollDegrees = 35; // so that the places depend on both
        camera.jitter = jitter;
        const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
        const Reflected found = reflectScene(camera, traced, desc());
        const Score s = score(traced, found);
        std::vector<double> errors;
        for (size_t i = 0; i < found.info.size(); ++i) {
            if (traced.truth[i] != Truth::recoverable || !(found.info[i] > 0)) continue;
            const glm::dvec2 pixel(static_cast<double>(i % traced.width) + 0.5,
                                   static_cast<double>(i / traced.width) + 0.5);
            errors.push_back(glm::length(sourceOf(camera, pixel, double{found.info[i]}) - traced.source[i]));
        }
        const double median = quantile(errors, 0.5), p95 = quantile(errors, 0.95);
        std::printf("jitter %6.3f %6.3f  coverage %.4f, place %.4f px median %.4f px p95\n", jitter.x,
                    jitter.y, s.coverage, median, p95);
        EXPECT_GE(s.coverage, 0.96);
        EXPECT_LE(s.medianPixels, 0.15);
        EXPECT_LE(median, 0.05);
        // Rays close in on a crossing by halves of a stride.
        EXPECT_LE(p95, GetParam() == ReflectionTechnique::ssr ? 0.45 : 0.25);
    }
}

INSTANTIATE_TEST_SUITE_P(, Regions,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid),
                         nameOf);

} // namespace
