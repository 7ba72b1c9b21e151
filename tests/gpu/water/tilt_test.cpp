// Bodies on planes that are not level: with camera, sun, sky and scene turned alike, the picture is the level
// one's.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <glm/mat3x3.hpp>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/cube_edges.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/overlay_target.h"
#include "tests/gpu/rig/traced_scene.h"
#include "tests/gpu/rig/water_rig.h"
#include "water/interface/sea_contents.h"

namespace {

using namespace seaglass;
using namespace tests;

/// How the turned world lies in the level one's, and how high its water then stands over the origin.
struct Turn {
    const char* name;
    double degrees;
    glm::dvec3 axis; ///< level, so that the turn is the smallest that takes +Y to its normal
    glm::dvec3 shift{0, 3.5, 0};

    friend void PrintTo(const Turn& turn, std::ostream* out) { *out << turn.name; }
    glm::dmat4 worldFromLevel() const {
        return glm::translate(glm::rotate(glm::dmat4(1), radians(degrees), axis), shift);
    }
};

glm::vec3 skyOf(const glm::dvec3& d) {
    return {1 + 0.9 * d.x, 1 + 0.6 * d.z - 0.3 * d.y, 0.8 + 0.7 * d.y * d.x - 0.2 * d.z};
}

/// A direction through each texel of each face, as Vulkan lays cubes out.
glm::dvec3 texelOfCube(uint32_t face, double s, double t) {
    const std::array<glm::dvec3, 6> towards = {glm::dvec3(1, -t, -s), glm::dvec3(-1, -t, s),
                                               glm::dvec3(s, 1, t),   glm::dvec3(s, -1, -t),
                                               glm::dvec3(s, -t, 1),  glm::dvec3(-s, -t, -1)};
    return glm::normalize(towards[face]);
}

/// skyOf(), turned.
demos::Image skyCube(const glm::dmat3& worldFromLevel) {
    constexpr uint32_t edge = 64;
    std::vector<glm::vec4> texels;
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < edge; ++y)
            for (uint32_t x = 0; x < edge; ++x) {
                const double s = (2 * x + 1.0) / edge - 1, t = (2 * y + 1.0) / edge - 1;
                texels.emplace_back(skyOf(texelOfCube(face, s, t) * worldFromLevel), 1);
            }
    demos::ImageDesc desc;
    desc.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    desc.extent = {edge, edge};
    desc.cube = true;
    desc.mips = 7;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
    const std::span<const std::byte> level = std::as_bytes(std::span(texels));
    demos::Image cube;
    demos::Error error;
    EXPECT_TRUE(demos::createSampledImage(device(), desc, {&level, 1}, cube, error)) << error.text;
    copyEdges(device(), cube);
    return cube;
}

/// 0..1, of which a 255th is a step of a display.
double shown(float radiance) {
    const double r = std::max(0.0, double{radiance});
    return r / (1 + r);
}

class Tilts : public WaterTest, public testing::WithParamInterface<Turn> {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        worldFromLevel_ = GetParam().worldFromLevel();
        levelSky_ = skyCube(glm::dmat3(1));
        turnedSky_ = skyCube(glm::dmat3(worldFromLevel_));
        sea_.windSpeed = 6;
        sea_.fetch = 5e3f;
        sea_.samples = 64;
        sea_.windDirection = 0.7f;
        camera_.eye = {3, 4, 7};
        camera_.target = {1, 0.5, -6};
        for (int i = 0; i < 3; ++i) {
            lighting.sunIrradiance[i] = 2;
            lighting.skyIrradiance[i] = 3;
        }
        lighting.skyCubeMipLevels = 7;
        desc_.refraction = &refraction_;
    }

    void addWaves() {
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
    }

    /// Boxes in the water and over it, and its bed.
    SceneBehind scene() const {
        std::vector<Box> boxes = harbourOfBoxes();
        boxes.push_back({{-60, -6, -60}, {60, -4, 60}});
        const TracedView traced = Tracer(camera_, boxes).run();
        return {traced.color, traced.depth};
    }

    BodyDesc turned(const BodyDesc& level) const {
        BodyDesc desc = level;
        const glm::dvec4 plane = glm::dvec4(level.plane[0], level.plane[1], level.plane[2], level.plane[3]) *
                                 glm::inverse(worldFromLevel_);
        for (int i = 0; i < 4; ++i) desc.plane[i] = plane[i];
        return desc;
    }

    void turn(ViewDesc& view) const {
        glm::dmat4 matrix;
        std::memcpy(&matrix, view.view, sizeof matrix);
        copyMatrix(matrix * glm::inverse(worldFromLevel_), view.view);
    }

    void light(bool inTurned) {
        const glm::dvec3 sun = glm::normalize(glm::dvec3(0.5, 0.55, -0.6));
        const glm::dvec3 to = inTurned ? glm::dmat3(worldFromLevel_) * sun : sun;
        for (int i = 0; i < 3; ++i) lighting.toSun[i] = to[i];
        lighting.skyCube = (inTurned ? turnedSky_ : levelSky_).view.get();
    }

    /// As a host would: the sky, and a bright rectangle before it.
    void drawMirrored(VkCommandBuffer commands, const PlanarView& view) const;

    WaterPicture seen(bool inTurned, Body* body, double time, SurfaceOutput output,
                      const SceneBehind& behind) {
        light(inTurned);
        changeView = [&, inTurned](ViewDesc& view) {
            if (inTurned) turn(view);
            if (alsoChange) alsoChange(view, body, inTurned);
        };
        if (drawsCaustics) drawCausticsOf(body);
        return picture({body}, camera_, time, output, behind);
    }

    struct Pair {
        WaterPicture level, turned;
    };

    Pair both(double time, SurfaceOutput output, const SceneBehind& behind) {
        const auto [level, tilted] = bodies();
        return both(level, tilted, time, output, behind);
    }
    std::pair<Body*, Body*> bodies() { return {makeBody(desc_), makeBody(turned(desc_))}; }
    Pair both(Body* level, Body* tilted, double time, SurfaceOutput output, const SceneBehind& behind) {
        return {seen(false, level, time, output, behind), seen(true, tilted, time, output, behind)};
    }

    /// `strays`: share of the pixels that may differ by more, where rays pass things by a rounding.
    static void expectSame(const Pair& pair, const char* what, double strays = 0) {
        size_t covered = 0, off = 0;
        double worst = 0, sum = 0, brightest = 0, darkest = 1;
        for (size_t i = 0; i < pair.level.depth.size(); ++i) {
            EXPECT_EQ(pair.level.covered(i), pair.turned.covered(i)) << what << ", pixel " << i;
            if (!pair.level.covered(i)) continue;
            ++covered;
            double difference = 0;
            for (size_t c = 0; c < 3; ++c) {
                const double a = shown(pair.level.color[i * 4 + c]), b = shown(pair.turned.color[i * 4 + c]);
                difference = std::max(difference, std::abs(a - b));
                brightest = std::max(brightest, a);
                darkest = std::min(darkest, a);
            }
            if (difference > 1.5 / 255) ++off;
            worst = std::max(worst, difference);
            sum += difference;
        }
        std::printf("%s: %zu pixels, off by %.4f of 255 in the mean, %.2f at most, %zu by more than 1.5\n",
                    what, covered, 255 * sum / static_cast<double>(covered), 255 * worst, off);
        EXPECT_GT(covered, 2000u) << what;
        EXPECT_GT(brightest - darkest, 0.1) << what;
        EXPECT_LE(static_cast<double>(off), strays * static_cast<double>(covered)) << what;
    }

    std::function<void(ViewDesc&, Body*, bool inTurned)> alsoChange;
    bool drawsCaustics = false;
    glm::dmat4 worldFromLevel_{1};
    demos::Image levelSky_, turnedSky_;
    Camera camera_;
    SeaDesc sea_;
    FoamDesc foam_;
    RefractionDesc refraction_;
    ReflectionDesc reflection_;
    UnderwaterDesc underwater_;
    CausticsDesc caustics_;
    BodyDesc desc_;
};

void Tilts::drawMirrored(VkCommandBuffer commands, const PlanarView& view) const {
    beginDrawing(context(), commands, view);
    VkClearAttachment clears[2] = {{VK_IMAGE_ASPECT_COLOR_BIT, 0, {}}, {VK_IMAGE_ASPECT_DEPTH_BIT, 0, {}}};
    clears[0].clearValue.color = {{9, 4, 2, 1}};
    clears[1].clearValue.depthStencil.depth = 0.02f;
    const VkClearRect rectangle = {
        {{static_cast<int32_t>(view.extent.width / 4), static_cast<int32_t>(view.extent.height / 3)},
         {view.extent.width / 2, view.extent.height / 3}},
        0,
        1};
    vkCmdClearAttachments(commands, 2, clears, 1, &rectangle);
    vkCmdEndRendering(commands);
}

/// Of pixels beside an edge a followed ray may hit or miss: of whole rows, where the far island's edges lie
/// along them.
constexpr double followedRays = 1.5e-3;
constexpr double followedRaysElsewhere = 2.5e-3; // where multiply-adds are fused

TEST_P(Tilts, StillWaterIsAsLevelWaterIs) {
    const double strays = limitOnDriver(followedRays, followedRaysElsewhere);
    expectSame(both(0, SurfaceOutput::shaded, scene()), "sky");
    desc_.reflection = &reflection_;
    for (const auto& [technique, name] : {std::pair(ReflectionTechnique::sspr, "sspr"),
                                          {ReflectionTechnique::ssr, "ssr"},
                                          {ReflectionTechnique::hybrid, "hybrid"}}) {
        reflection_.technique = technique;
        expectSame(both(0, SurfaceOutput::shaded, scene()), name,
                   technique == ReflectionTechnique::sspr ? 0 : strays);
    }
    reflection_.technique = ReflectionTechnique::sspr;
    for (const auto& [output, name] : {std::pair(SurfaceOutput::reflection, "reflection"),
                                       {SurfaceOutput::reflectionClass, "class"},
                                       {SurfaceOutput::reflectionSource, "source"}})
        expectSame(both(0, output, scene()), name, strays);
}

TEST_P(Tilts, WavesAreAsOnLevelWater) {
    addWaves();
    sea_.windSpeed = 12;
    sea_.fetch = 100e3f;
    foam_.bias = 0.3f;
    desc_.foam = &foam_;
    desc_.reflection = &reflection_;
    refraction_.scattering = 5;
    desc_.shading.waveShadowSteps = 4;
    camera_.eye.y = 1.5; // low, where they mirror most
    camera_.target.y = 1;
    expectSame(both(7, SurfaceOutput::shaded, scene()), "shaded");
}

TEST_P(Tilts, NormalsAreTheWorlds) {
    addWaves();
    const Pair pair = both(7, SurfaceOutput::normal, scene());
    const glm::dmat3 turn(worldFromLevel_);
    double worst = 0;
    for (size_t i = 0; i < pair.level.depth.size(); ++i) {
        if (!pair.level.covered(i)) continue;
        const float *a = &pair.level.color[i * 4], *b = &pair.turned.color[i * 4];
        const glm::dvec3 expected = turn * glm::dvec3(a[0], a[1], a[2]);
        worst = std::max(worst, glm::length(glm::dvec3(b[0], b[1], b[2]) - expected));
    }
    std::printf("normals off by %.6f at most\n", worst);
    EXPECT_LT(worst, 1e-3);
}

TEST_P(Tilts, HeightsAndSlopesAreAlongThePlanesNormal) {
    addWaves();
    for (const SurfaceOutput output : {SurfaceOutput::height, SurfaceOutput::slopes}) {
        const Pair pair = both(7, output, scene());
        double worst = 0, greatest = 0;
        for (size_t i = 0; i < pair.level.depth.size(); ++i)
            for (size_t c = 0; c < 2 && pair.level.covered(i); ++c) {
                const double a = double{pair.level.color[i * 4 + c]};
                greatest = std::max(greatest, std::abs(a));
                worst = std::max(worst, std::abs(a - double{pair.turned.color[i * 4 + c]}));
            }
        EXPECT_GT(greatest, 0.1);
        EXPECT_LT(worst, 1e-3);
    }
}

TEST_P(Tilts, ExtentsLieInThePlane) {
    addWaves();
    const double corners[] = {-3, 2, 5, 1, 3, -8, -4, -9};
    const uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
    ExtentDesc& extent = desc_.extent;
    extent.center[0] = 1;
    extent.center[1] = -3;
    extent.size[0] = 7;
    extent.size[1] = 9;
    extent.yaw = 0.4;
    extent.points = corners;
    extent.pointCount = 4;
    extent.indices = triangles;
    extent.indexCount = 6;
    desc_.reflection = &reflection_;
    for (const auto& [shape, name] : {std::pair(ExtentShape::rectangle, "rectangle"),
                                      {ExtentShape::polygon, "polygon"},
                                      {ExtentShape::mesh, "mesh"}}) {
        extent.shape = shape;
        expectSame(both(3, SurfaceOutput::shaded, scene()), name);
    }
}

TEST_P(Tilts, PlanarViewsAreTurnedAndSeeTheBodyAlone) {
    desc_.reflection = &reflection_;
    reflection_.technique = ReflectionTechnique::planar;
    reflection_.distortion = 0.5f;
    addWaves();
    desc_.extent.shape = ExtentShape::rectangle;
    desc_.extent.center[1] = -2;
    desc_.extent.size[0] = desc_.extent.size[1] = 12;
    PlanarView mirrored[2];
    alsoChange = [&](ViewDesc& view, Body* body, bool inTurned) {
        PlanarView& out = mirrored[inTurned];
        ASSERT_EQ(planarView(body, &view, &out), Status::ok) << message();
        ASSERT_TRUE(out.visible);
        frame([&](VkCommandBuffer commands) { drawMirrored(commands, out); });
    };
    expectSame(both(3, SurfaceOutput::shaded, scene()), "planar");
    const glm::dmat4 levelFromWorld = glm::inverse(worldFromLevel_);
    glm::dmat4 level, turned;
    std::memcpy(&level, mirrored[0].view, sizeof level);
    std::memcpy(&turned, mirrored[1].view, sizeof turned);
    const glm::dmat4 off = level * levelFromWorld - turned;
    for (int i = 0; i < 16; ++i) {
        EXPECT_NEAR(off[i / 4][i % 4], 0, 1e-9);
        EXPECT_NEAR(mirrored[0].projection[i], mirrored[1].projection[i], 1e-9);
    }
    // Turned to where the body is out of sight, though a box along the world's axes around it would not be.
    camera_.target = {3 + 10, 4 - 1.2, 7};
    camera_.fovDegrees = 20;
    Body* const both[] = {makeBody(desc_), makeBody(this->turned(desc_))};
    for (int i = 0; i < 2; ++i) {
        ViewDesc view = viewDesc(camera_);
        if (i == 1) turn(view);
        PlanarView out;
        ASSERT_EQ(planarView(both[i], &view, &out), Status::ok) << message();
        EXPECT_FALSE(out.visible);
    }
}

TEST_P(Tilts, RaysFollowTheSurfacesNormals) {
    desc_.reflection = &reflection_;
    reflection_.technique = ReflectionTechnique::ssr;
    addWaves();
    sea_.amplitude = 0.3f;
    const Pair normals = both(3, SurfaceOutput::normal, scene());
    demos::Image held;
    Image handed;
    alsoChange = [&](ViewDesc& view, Body*, bool inTurned) {
        std::vector<float> values = (inTurned ? normals.turned : normals.level).color;
        for (float& value : values)
            if (value == WaterPicture::untouched) value = 0;
        held = uploadFloats(camera_.width, camera_.height, 4, values);
        handed = asSeaglass(held);
        view.surfaceNormals = &handed;
    };
    expectSame(both(3, SurfaceOutput::shaded, scene()), "normals", 10 * followedRays);
}

TEST_P(Tilts, EyesInTheWaterSeeTheSame) {
    addWaves();
    sea_.amplitude = 0.3f;
    desc_.underwater = &underwater_;
    desc_.reflection = &reflection_;
    camera_.eye = {2, -3, 3};
    camera_.target = {1, 0, -1};
    expectSame(both(5, SurfaceOutput::shaded, scene()), "below", followedRays);
    camera_.eye.y = camera_.target.y = 0.05;
    expectSame(both(5, SurfaceOutput::shaded, scene()), "straddling", followedRays);
}

TEST_P(Tilts, CausticsFallAlongTheSunInThePlanesAxes) {
    addWaves();
    desc_.caustics = &caustics_;
    drawsCaustics = true;
    camera_.target = {1, -6, -4};
    Pair pair = both(5, SurfaceOutput::shaded, scene());
    for (WaterPicture* p : {&pair.level, &pair.turned})
        for (float& value : p->color) value /= WaterPicture::untouched;
    expectSame(pair, "caustics");
    // Under a sun that is up, but not over the plane, there are none.
    const glm::dvec3 sun = glm::dmat3(worldFromLevel_) * glm::normalize(glm::dvec3(0.3, -0.05, 0.2));
    for (int i = 0; i < 3; ++i) lighting.toSun[i] = sun[i];
    changeView = [&](ViewDesc& view) { turn(view); };
    spiedCalls().clear();
    Body* const body = makeBody(turned(desc_));
    drawCausticsOf(body);
    picture({body}, camera_, 5, SurfaceOutput::shaded, scene());
    EXPECT_EQ(countSpied("CmdDraw"), 0u);
}

TEST_P(Tilts, MotionIsTheSame) {
    addWaves();
    desc_.motion = true;
    const auto [level, tilted] = bodies();
    both(level, tilted, 5, SurfaceOutput::motion, scene());
    camera_.eye += glm::dvec3(0.3, -0.1, -0.2);
    camera_.rollDegrees = 3;
    const Pair pair = both(level, tilted, 5.1, SurfaceOutput::motion, scene());
    double worst = 0, greatest = 0;
    for (size_t i = 0; i < pair.level.depth.size(); ++i) {
        if (!pair.level.covered(i)) continue;
        const float *a = &pair.level.color[i * 4], *b = &pair.turned.color[i * 4];
        greatest = std::max(greatest, std::hypot(double{a[0]}, double{a[1]}));
        worst = std::max(worst, std::hypot(double{a[0]} - double{b[0]}, double{a[1]} - double{b[1]}));
    }
    std::printf("motion up to %.2f pixels, off by %.5f at most\n", greatest, worst);
    EXPECT_GT(greatest, 1);
    EXPECT_LT(worst, 0.01);
}

TEST_P(Tilts, HistoriesAreFollowedAlongThePlane) {
    desc_.reflection = &reflection_;
    reflection_.temporal = 0.9f;
    const Camera start = camera_;
    const auto lastOf = [&](bool inTurned, Body* body, int frames) {
        WaterPicture p;
        for (int i = 0; i < frames; ++i) {
            camera_ = start;
            camera_.eye.x += 0.05 * (i - frames);
            camera_.rollDegrees = i - frames;
            p = seen(inTurned, body, 0, SurfaceOutput::reflection, scene());
        }
        return p;
    };
    const auto [level, tilted] = bodies();
    const Pair pair{lastOf(false, level, 5), lastOf(true, tilted, 5)};
    expectSame(pair, "histories", followedRays);
    const WaterPicture alone = lastOf(true, makeBody(turned(desc_)), 1);
    size_t kept = 0;
    for (size_t i = 0; i < alone.color.size(); i += 4)
        kept += std::abs(shown(alone.color[i]) - shown(pair.turned.color[i])) > 1.5 / 255;
    std::printf("%zu pixels are others than those of one frame\n", kept);
    EXPECT_GT(kept, 200u);
}

TEST_P(Tilts, TheOverlayShowsTheSame) {
    desc_.reflection = &reflection_;
    const auto [level, tilted] = bodies();
    const SceneBehind behind = scene();
    const demos::Image color = uploadFloats(camera_.width, camera_.height, 4, behind.color);
    const demos::Image depth = uploadFloats(camera_.width, camera_.height, 1, behind.depth);
    const demos::Image target = overlayTarget({camera_.width, camera_.height});
    const auto overlay = [&](bool inTurned, Body* body, OverlayKind kind) {
        ViewDesc view = viewDesc(camera_);
        view.sceneColor = asSeaglass(color);
        view.sceneDepth = asSeaglass(depth);
        if (inTurned) turn(view);
        OverlayDesc desc;
        desc.kind = kind;
        desc.target = described(target);
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &body, 1, &view), Status::ok) << message();
            toGeneral(commands, target);
            EXPECT_EQ(recordOverlay(commands, body, &view, &desc), Status::ok) << message();
            toSampled(commands, target);
        });
        return download(target.image.get(), target.format, target.extent);
    };
    for (const auto& [kind, name] : {std::pair(OverlayKind::depth, "depth"),
                                     {OverlayKind::plane, "plane"},
                                     {OverlayKind::classes, "classes"},
                                     {OverlayKind::confidence, "confidence"},
                                     {OverlayKind::hitDistance, "distance"}}) {
        const std::vector<float> a = overlay(false, level, kind), b = overlay(true, tilted, kind);
        size_t off = 0;
        float lowest = 1, highest = 0;
        for (size_t i = 0; i < a.size(); i += 4) {
            double difference = 0;
            for (size_t c = i; c < i + 3; ++c)
                difference = std::max(difference, std::abs(double{a[c]} - double{b[c]}));
            off += difference > 0.01;
            lowest = std::min(lowest, a[i]);
            highest = std::max(highest, a[i]);
        }
        std::printf("%s: %zu of %zu pixels differ\n", name, off, a.size() / 4);
        EXPECT_LE(static_cast<double>(off), followedRays * static_cast<double>(a.size()) / 4) << name;
        EXPECT_GT(highest - lowest, 0.1f) << name;
    }
}

TEST_P(Tilts, ExclusionVolumesStayWhereTheyAreInTheWorld) {
    addWaves();
    desc_.underwater = &underwater_;
    ExclusionVolume volume = {
        {{1, 0, 0, -2.5}, {-1, 0, 0, -0.5}, {0, 0, 2, -2}, {0, 0, -1, -5}, {0, -1, 0, -2}}};
    const auto [level, tilted] = bodies();
    ASSERT_EQ(setExclusionVolumes(level, &volume, 1), Status::ok) << message();
    for (auto& plane : volume.planes) {
        const glm::dvec4 turned =
            glm::dvec4(plane[0], plane[1], plane[2], plane[3]) * glm::inverse(worldFromLevel_);
        for (int i = 0; i < 4; ++i) plane[i] = turned[i];
    }
    ASSERT_EQ(setExclusionVolumes(tilted, &volume, 1), Status::ok) << message();
    const Pair pair = both(level, tilted, 3, SurfaceOutput::shaded, scene());
    expectSame(pair, "a volume");
    const Pair whole = both(3, SurfaceOutput::shaded, scene());
    size_t dry = 0;
    for (size_t i = 0; i < pair.level.depth.size(); ++i)
        dry += whole.level.covered(i) && !pair.level.covered(i);
    EXPECT_GT(dry, 500u);
    camera_.eye = {1, -1, -1}; // in the volume, and below the water beside it
    camera_.target = {1, -1.2, -6};
    expectSame(both(level, tilted, 3, SurfaceOutput::shaded, scene()), "an eye in it");
}

/// (u, v) of a point of the plane, as seaglass/sea.h has it.
std::array<double, 2> onPlane(const double (&plane)[4], const glm::dvec3& p) {
    const double share = (p.y - plane[3]) / (1 + plane[1]);
    return {p.x - plane[0] * share, p.z - plane[2] * share};
}

TEST_P(Tilts, HeightQueriesAnswerForPlacesInThePlane) {
    sea_.windSpeed = 12;
    sea_.fetch = 50e3f;
    sea_.cascades = 1; // longer than the mesh's cells
    sea_.largestPatch = 200;
    sea_.samples = 128;
    addWaves();
    const BodyDesc desc = turned(desc_);
    Body* const body = makeBody(desc);
    const WaterPicture p = seen(true, body, 5, SurfaceOutput::height, {});
    const glm::dvec3 normal(desc.plane[0], desc.plane[1], desc.plane[2]);
    double worst = 0, greatest = 0;
    for (uint32_t y = 5; y < p.height; y += 9)
        for (uint32_t x = 5; x < p.width; x += 11) {
            if (!p.covered(size_t{y} * p.width + x)) continue;
            const glm::dvec3 level = worldAt(camera_, p, x, y);
            if (glm::length(level - camera_.eye) > 25) continue;
            const glm::dvec3 world(worldFromLevel_ * glm::dvec4(level, 1));
            const double height = glm::dot(normal, world) + desc.plane[3];
            const auto at = onPlane(desc.plane, world - height * normal);
            HeightSample sample;
            sampleHeights(*sea(body), 5, at.data(), 1, &sample);
            worst = std::max(worst, std::abs(double{sample.height} - height));
            greatest = std::max(greatest, std::abs(height));
        }
    std::printf("heights up to %.3f m, off by %.4f at most\n", greatest, worst);
    EXPECT_GT(greatest, 0.1);
    EXPECT_LT(worst, 0.05 * significantWaveHeight(*sea(body)));
}

/// A thousand kilometres away the same waves come again, and nothing trembles.
TEST_P(Tilts, FarFromTheOriginThePictureIsTheSame) {
    sea_.cascades = 1;
    sea_.largestPatch = 100;
    sea_.warp = 0; // the same sea lies there
    addWaves();
    desc_.reflection = &reflection_;
    desc_.extent.shape = ExtentShape::rectangle;
    desc_.extent.size[0] = desc_.extent.size[1] = 15;
    Body* const level = makeBody(desc_);
    const double patch = cascade(*sea(level), 0).patch;
    const glm::dvec3 far(patch * std::floor(8e5 / patch), 1234.5, -patch * std::floor(6e5 / patch));
    worldFromLevel_ = worldFromLevel_ * glm::translate(glm::dmat4(1), far);
    desc_.extent.center[0] += far.x;
    desc_.extent.center[1] += far.z;
    Body* const tilted = makeBody(turned(desc_));
    expectSame(both(level, tilted, 5, SurfaceOutput::shaded, scene()), "far away");
}

INSTANTIATE_TEST_SUITE_P(All, Tilts,
                         testing::Values(Turn{"AFew", 12, {0.6, 0, 0.8}}, Turn{"Much", 60, {-0.28, 0, 0.96}}),
                         [](const auto& each) { return each.param.name; });

class TiltedPlanes : public WaterTest {};

TEST_F(TiltedPlanes, ThatDoNotFaceUpAreRefusedBeforeAnythingIsMade) {
    const double planes[][4] = {{1, 0, 0, 0},      {0, 0, 1, 2},        {0, -1, 0, 0},
                                {0.6, -0.8, 0, 0}, {0, 0, 0, 1},        {0, NAN, 0, 0},
                                {0, 1, 0, NAN},    {INFINITY, 1, 0, 0}, {1, 6e-17, 0, 0}};
    for (const auto& plane : planes) {
        BodyDesc desc;
        std::memcpy(desc.plane, plane, sizeof plane);
        Body* body = nullptr;
        spiedCalls().clear();
        EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument)
            << plane[0] << ' ' << plane[1];
        EXPECT_EQ(body, nullptr);
        EXPECT_NE(message().find("plane"), std::string::npos) << message();
        Estimate estimated;
        EXPECT_EQ(estimate(context(), &desc, {64, 64}, &estimated), Status::invalidArgument);
        EXPECT_TRUE(spiedCalls().empty());
    }
}

} // namespace
