// Views with parallel lines of sight, and those whose axis lies beside their middle, against a traced truth.
#include <algorithm>
#include <string_view>

#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Parallel : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {};

TEST_P(Parallel, ViewsAgreeWithTheTracedTruth) {
    for (const Pose& pose : parallelPoses())
        for (const bool reversed : {true, false}) {
            Camera camera = pose.camera;
            camera.reversed = reversed;
            const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
            const Score s = score(traced, reflectScene(camera, traced, with(GetParam())));
            print(pose.name, s);
            EXPECT_GT(std::ranges::count(traced.truth, Truth::recoverable), 2000) << pose.name;
            EXPECT_GE(s.coverage, 0.97) << pose.name;
            EXPECT_LE(s.medianPixels, 0.15) << pose.name;
            EXPECT_LE(s.p95Pixels, 0.75) << pose.name;
            EXPECT_LE(s.falseOnSky, 0.005) << pose.name;
            EXPECT_LE(s.skyOnGeometry, 0.01) << pose.name;
        }
}

/// Of what is mirrored there, along the ray.
double distanceFromMirror(const Camera& camera, const glm::dvec2& pixel) {
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    const glm::dvec2 ndc = pixel / glm::dvec2(camera.width, camera.height) * 2.0 - 1.0;
    const auto at = [&](double depth) {
        const glm::dvec4 p = inverse * glm::dvec4(ndc, depth, 1);
        return glm::dvec3(p) / p.w;
    };
    const glm::dvec3 near = at(camera.reversed ? 1 : 0);
    const glm::dvec3 ray = glm::normalize(at(0.5) - near);
    const glm::dvec3 on = near - ray * (near.y / ray.y);
    return nearestHit(harbourOfBoxes(), on, ray * glm::dvec3(1, -1, 1));
}

TEST_P(Parallel, DistancesAreThoseAlongTheMirroredRays) {
    for (const Pose& pose : parallelPoses()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const Reflected found = reflectScene(pose.camera, traced, with(GetParam()));
        std::vector<double> errors;
        for (size_t i = 0; i < found.info.size(); ++i) {
            if (traced.truth[i] != Truth::recoverable || !(found.info[i] > 0)) continue;
            const glm::dvec2 pixel(static_cast<double>(i % traced.width) + 0.5,
                                   static_cast<double>(i / traced.width) + 0.5);
            errors.push_back(std::abs(double{found.info[i]} - distanceFromMirror(pose.camera, pixel)));
        }
        EXPECT_LE(quantile(errors, 0.5), 0.01) << pose.name;
        EXPECT_LE(quantile(errors, 0.9), 0.1) << pose.name;
    }
}

/// There is no eye: only where the near plane lies counts.
TEST_P(Parallel, TheCamerasOriginMayLieAnywhereOnItsAxis) {
    const Camera camera = parallelPoses().front().camera;
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const Reflected expected = reflectScene(camera, traced, with(GetParam()));
    for (const double ahead : {-50.0, 40.0}) { // the latter under the water
        Camera moved = camera;
        const glm::dvec3 along = glm::normalize(camera.target - camera.eye) * ahead;
        moved.eye += along;
        moved.target += along;
        moved.near -= ahead;
        moved.far -= ahead;
        const Reflected found = reflectView(traced, viewDesc(moved), with(GetParam()));
        size_t differing = 0;
        for (size_t i = 0; i < found.info.size(); ++i)
            differing += reflectionClass(found.info[i]) != reflectionClass(expected.info[i]) ||
                         std::abs(found.info[i] - expected.info[i]) > 0.01f * std::abs(expected.info[i]);
        EXPECT_LE(differing, found.info.size() / 500) << ahead;
    }
}

/// Whether a mirrored ray leaves the view through its far plane.
bool leavesThroughTheFarPlane(const Camera& camera, const glm::dvec2& pixel) {
    const glm::dmat4 clip = projectionMatrix(camera) * viewMatrix(camera);
    const glm::dmat4 inverse = glm::inverse(clip);
    const glm::dvec2 ndc = pixel / glm::dvec2(camera.width, camera.height) * 2.0 - 1.0;
    const glm::dvec3 near(inverse * glm::dvec4(ndc, camera.reversed ? 1 : 0, 1));
    const glm::dvec3 ray = glm::normalize(glm::dvec3(inverse * glm::dvec4(ndc, 0.5, 1)) - near);
    const glm::dvec4 on = clip * glm::dvec4(near - ray * (near.y / ray.y), 1);
    const glm::dvec4 along = clip * glm::dvec4(ray * glm::dvec3(1, -1, 1), 0);
    const double far = camera.reversed ? 0 : 1;
    if (on.z < 0 || on.z > 1) return false; // the plane is not reached
    const glm::dvec4 end = on + along * ((far - on.z) / along.z);
    return (far - on.z) / along.z > 0 && std::abs(end.x) < 1 && std::abs(end.y) < 1;
}

TEST_P(Parallel, SkyIsWhereRaysLeaveThroughTheFarPlaneAlone) {
    for (Pose& pose : parallelPoses()) {
        Camera& camera = pose.camera;
        camera.far = 30;
        const TracedView traced = Tracer(camera, {}).run();
        const Reflected found = reflectScene(camera, traced, with(GetParam()));
        size_t skies = 0, wrong = 0;
        for (size_t i = 0; i < found.info.size(); ++i) {
            const glm::dvec2 pixel(static_cast<double>(i % traced.width) + 0.5,
                                   static_cast<double>(i / traced.width) + 0.5);
            const bool expected = leavesThroughTheFarPlane(camera, pixel);
            skies += expected;
            wrong += reflectionClass(found.info[i]) !=
                     (expected ? ReflectionClass::sky : ReflectionClass::unknown);
        }
        std::printf("%-8s %zu sky, %zu wrong\n", pose.name, skies, wrong);
        // The view from above sees no ray go on.
        EXPECT_EQ(skies > 1000, std::string_view(pose.name) != "steep") << pose.name;
        EXPECT_LE(wrong, found.info.size() / 200) << pose.name;
    }
}

TEST_P(Parallel, TemporalReuseFollowsThem) {
    Camera camera = parallelPoses().front().camera;
    ReflectorDesc desc = with(GetParam());
    desc.reflection.temporal = 0.9f;
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    Reflected last;
    for (int i = 0; i < 6; ++i) {
        // By whole pixels: what reuses the right ones stays as sharp as it was.
        const double pixel = camera.parallelHeight / camera.height;
        camera.eye.x += i < 5 ? 2 * pixel : 0;
        camera.target.x = camera.eye.x;
        TracedView traced = Tracer(camera, harbourOfBoxes()).run();
        for (size_t p = 0; p < traced.depth.size(); ++p)
            traced.color[p * 4] =
                static_cast<float>((p % camera.width + static_cast<size_t>(2 * std::min(i, 4))) % 6) / 6;
        ViewDesc view = viewDesc(camera);
        const SceneOnDevice scene = upload(traced, view);
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
        });
        const ReflectionImages images = reflectionImages(reflector, 0);
        last = {download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
        if (i < 5) continue;
        const Reflected fresh = reflectScene(camera, traced, with(GetParam()));
        size_t compared = 0, off = 0;
        for (size_t p = 0; p < traced.truth.size(); ++p) {
            if (traced.truth[p] != Truth::recoverable || !(fresh.info[p] > 0)) continue;
            ++compared;
            off += std::abs(last.color[p * 4] - fresh.color[p * 4]) > 0.05f;
        }
        std::printf("%zu of %zu off\n", off, compared);
        EXPECT_GT(compared, 3000u);
        EXPECT_LE(off, compared / 20);
    }
    destroyReflector(reflector);
    frame([](VkCommandBuffer) {});
    frame([](VkCommandBuffer) {});
}

/// A frustum whose axis lies beside its middle, as those of tiled walls and of each eye's display.
TEST_P(Parallel, OffCentreEyesAgreeWithTheTracedTruth) {
    for (const glm::dvec2 offCentre : {glm::dvec2(0.6, 0.2), glm::dvec2(-1.4, -0.5)})
        for (const bool reversed : {true, false}) {
            Camera camera = testCamera();
            camera.offCentre = offCentre;
            camera.reversed = reversed;
            const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
            const Score s = score(traced, reflectScene(camera, traced, with(GetParam())));
            print("beside", s);
            EXPECT_GE(s.coverage, 0.97);
            EXPECT_LE(s.medianPixels, 0.2);
            EXPECT_LE(s.p95Pixels, 1.0);
            EXPECT_LE(s.falseOnSky, 0.005);
            EXPECT_LE(s.skyOnGeometry, 0.01);
        }
}

INSTANTIATE_TEST_SUITE_P(, Parallel,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid),
                         nameOf);

} // namespace
