// The quality presets, and the samples that they set.
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr Quality qualities[] = {Quality::low, Quality::medium, Quality::high, Quality::highest};

ReflectionTechnique chosen(Quality quality, ReflectionTechnique before) {
    ReflectionDesc reflection;
    reflection.technique = before;
    setQuality(quality, nullptr, &reflection);
    return reflection.technique;
}

TEST(QualityPresets, EachStepLooksNoLessThanTheOneBefore) {
    BodyDesc last;
    ReflectionDesc lastReflection;
    setQuality(Quality::low, &last, &lastReflection);
    for (const Quality quality : qualities) {
        BodyDesc body;
        ReflectionDesc reflection;
        setQuality(quality, &body, &reflection);
        EXPECT_GE(body.mesh.cellsPerLevel, last.mesh.cellsPerLevel);
        EXPECT_GE(body.shading.reflectionSamples, last.shading.reflectionSamples);
        EXPECT_GE(body.shading.refractionSamples, last.shading.refractionSamples);
        EXPECT_LE(body.shading.bedDownscale, last.shading.bedDownscale);
        EXPECT_GE(body.shading.slopeSamples, last.shading.slopeSamples);
        EXPECT_GE(body.shading.waveShadowSteps, last.shading.waveShadowSteps);
        EXPECT_GE(body.shading.parallax, last.shading.parallax);
        EXPECT_LE(reflection.downscale, lastReflection.downscale);
        EXPECT_GE(reflection.marchSteps, lastReflection.marchSteps);
        EXPECT_GE(reflection.overhangSamples, lastReflection.overhangSamples);
        last = body;
        lastReflection = reflection;
    }
    EXPECT_GT(lastReflection.overhangSamples, 0u);
    EXPECT_NE(chosen(Quality::low, ReflectionTechnique::ssr),
              chosen(Quality::highest, ReflectionTechnique::ssr));
}

TEST(QualityPresets, HasTheBedDrawnButAtItsLowest) {
    const BedDesc bed;
    for (const Quality quality : qualities) {
        BodyDesc body;
        setQuality(quality, &body, nullptr);
        EXPECT_EQ(body.bed, nullptr);
        body.bed = &bed;
        setQuality(quality, &body, nullptr);
        EXPECT_EQ(body.bed, quality == Quality::low ? nullptr : &bed);
    }
}

TEST(QualityPresets, LeavesWhatIsModelled) {
    const SeaDesc waves;
    for (const Quality quality : qualities) {
        EXPECT_EQ(chosen(quality, ReflectionTechnique::sky), ReflectionTechnique::sky);
        EXPECT_EQ(chosen(quality, ReflectionTechnique::planar), ReflectionTechnique::planar);
        BodyDesc body;
        body.waves = &waves;
        body.mesh.cellSize = 0.77f;
        body.shading.fresnel = Fresnel::schlick;
        ReflectionDesc reflection;
        reflection.edgeFade = 0.33f;
        reflection.temporal = 0.5f;
        setQuality(quality, &body, &reflection);
        EXPECT_EQ(body.waves, &waves);
        EXPECT_EQ(body.foam, nullptr);
        EXPECT_EQ(body.mesh.cellSize, 0.77f);
        EXPECT_EQ(body.shading.fresnel, Fresnel::schlick);
        EXPECT_EQ(reflection.edgeFade, 0.33f);
        EXPECT_EQ(reflection.temporal, 0.5f);
        setQuality(quality, nullptr, nullptr);
    }
}

class ShadingSamples : public WaterTest {
  protected:
    Body* bodyWith(const ShadingDesc& shading, const RefractionDesc* refraction = nullptr,
                   const MeshDesc& mesh = {}) {
        SeaDesc sea;
        sea.windSpeed = 10;
        sea.samples = 128;
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.refraction = refraction;
        desc.shading = shading;
        desc.mesh = mesh;
        return makeBody(desc);
    }
    /// Seen low over the water, where pixels are long.
    static Camera low() {
        Camera camera;
        camera.eye = {3, 6, 7};
        camera.target = {3, 3, -30};
        camera.width = 192;
        camera.height = 108;
        return camera;
    }
};

/// Means of the squared slopes that pixels show, and of the variance that they keep as roughness.
struct Slopes {
    double shown = 0, within = 0;
};

Slopes slopesOf(const WaterPicture& p) {
    Slopes sum;
    double count = 0;
    for (size_t i = 0; i < p.color.size(); i += 4) {
        if (!p.covered(i / 4)) continue;
        sum.shown += std::pow(double{p.color[i]}, 2) + std::pow(double{p.color[i + 1]}, 2);
        sum.within += double{p.color[i + 2]} + double{p.color[i + 3]};
        ++count;
    }
    return {sum.shown / count, sum.within / count};
}

// Samples along a long pixel see slopes that one, as wide as it is long, takes for roughness.
TEST_F(ShadingSamples, AlongAPixelShowMoreSlopesAndLoseNone) {
    Slopes one, four;
    for (const uint32_t samples : {1u, 4u}) {
        Body* const body = bodyWith({.slopeSamples = samples});
        (samples == 1 ? one : four) = slopesOf(picture({body}, low(), 50, SurfaceOutput::slopes));
    }
    std::printf("shown %.5f and within %.5f by one sample, %.5f and %.5f by four\n", one.shown, one.within,
                four.shown, four.within);
    EXPECT_GT(four.shown, 1.05 * one.shown);
    EXPECT_NEAR(four.shown + four.within, one.shown + one.within, 0.02 * (one.shown + one.within));
}

/// Root mean square of how far apart the shown slopes are where both pictures have water.
double slopesApart(const WaterPicture& a, const WaterPicture& b) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < a.color.size(); i += 4) {
        if (!a.covered(i / 4) || !b.covered(i / 4)) continue;
        for (const size_t axis : {i, i + 1})
            sum += std::pow(double{a.color[axis]} - double{b.color[axis]}, 2);
        ++count;
    }
    return std::sqrt(sum / count);
}

// A mesh whose cells are longer than waves shows their near and far sides as wide as each other. With
// parallax it comes nearer to a mesh that has those waves.
TEST_F(ShadingSamples, ParallaxStandsInForAFinerMesh) {
    Camera camera = low();
    camera.eye = {0, 18, 0}; // what is near has finer cells than are asked for
    camera.target = {0, 0, -180};
    camera.fovDegrees = 5;
    const auto slopes = [&](const MeshDesc& mesh, bool parallax) {
        Body* const body = bodyWith({.slopeSamples = 4, .parallax = parallax}, nullptr, mesh);
        return picture({body}, camera, 50, SurfaceOutput::slopes);
    };
    constexpr MeshDesc coarse = {1, 128};
    const WaterPicture fine = slopes({0.04f, 1024}, false);
    const double flat = slopesApart(slopes(coarse, false), fine);
    const double parallax = slopesApart(slopes(coarse, true), fine);
    std::printf("slopes off by %.4f without parallax, %.4f with it\n", flat, parallax);
    EXPECT_LT(parallax, 0.8 * flat);
}

double meanOf(const WaterPicture& p) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < p.color.size(); i += 4) {
        if (!p.covered(i / 4)) continue;
        sum += double{p.color[i]};
        ++count;
    }
    return sum / count;
}

// Under one sky all slopes mirror the same: only Fresnel's mean may differ by how they are told apart.
TEST_F(ShadingSamples, AtWhatIsMirroredAgreeUnderAnEvenSky) {
    for (const Fresnel formula : {Fresnel::exact, Fresnel::schlick}) {
        const double two = meanOf(picture({bodyWith({.fresnel = formula})}, low(), 50));
        for (const uint32_t samples : {1u, 4u}) {
            const ShadingDesc shading = {.reflectionSamples = samples, .fresnel = formula};
            EXPECT_NEAR(meanOf(picture({bodyWith(shading)}, low(), 50)) / two, 1, 0.011) << samples;
        }
    }
}

TEST_F(ShadingSamples, OutOfRangeAreNamed) {
    const auto refused = [&](const ShadingDesc& shading) {
        BodyDesc desc;
        desc.shading = shading;
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument);
        EXPECT_EQ(body, nullptr);
        return message();
    };
    for (const uint32_t bad : {0u, 3u, 8u}) {
        EXPECT_NE(refused({.reflectionSamples = bad}).find("ShadingDesc.reflectionSamples"),
                  std::string::npos);
        EXPECT_NE(refused({.slopeSamples = bad}).find("ShadingDesc.slopeSamples"), std::string::npos);
    }
    for (const uint32_t bad : {0u, 17u})
        EXPECT_NE(refused({.refractionSamples = bad}).find("ShadingDesc.refractionSamples"),
                  std::string::npos);
    EXPECT_NE(refused({.fresnel = static_cast<Fresnel>(2)}).find("ShadingDesc.fresnel"), std::string::npos);
}

/// A bed striped along the line of sight, as the picture shows it.
SceneBehind stripedBed(const Camera& camera, double bed) {
    SceneBehind behind = planeBelow(camera, bed, 2);
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const double u = camera.eye.x + (bed - camera.eye.y) / ray.y * ray.x;
            const float radiance = std::fmod(std::floor(u / 0.35), 2) == 0 ? 1.0f : 3.0f;
            std::fill_n(&behind.color[(size_t{y} * camera.width + x) * 4], 3, radiance);
        }
    return behind;
}

/// Deviation along a row of the picture.
double contrastOf(const WaterPicture& p, uint32_t row) {
    double sum = 0, squares = 0;
    for (uint32_t x = 0; x < p.width; ++x) {
        const double value = double{p.color[(size_t{row} * p.width + x) * 4]};
        sum += value;
        squares += value * value;
    }
    const double mean = sum / p.width;
    return std::sqrt(std::max(squares / p.width - mean * mean, 0.0)) / mean;
}

// Where the bent ray leaves the picture, what it would meet is not known: neither the border's pixels drawn
// out into streaks, nor a mirror image of what lies inside.
TEST_F(ShadingSamples, BeyondTheBorderSeeTheBedsMeanAndNoStreaks) {
    const RefractionDesc clear = {{0, 0, 0}, {0, 0, 0}, 1};
    BodyDesc desc;
    desc.refraction = &clear;
    Body* const body = makeBody(desc);
    Camera camera = low();
    camera.eye = {0, 2.2, 6};
    camera.target = {0, 1.6, -14};
    const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::shaded, stripedBed(camera, -3));
    const double inside = contrastOf(p, camera.height * 2 / 3), beyond = contrastOf(p, camera.height - 1);
    std::printf("contrast %.3f inside, %.3f beyond\n", inside, beyond);
    EXPECT_GT(inside, 0.2);
    EXPECT_LT(beyond, 0.8 * inside);
}

/// A level bed, and on it round black stones that the picture's lower border cuts off.
SceneBehind stonesAtTheBorder(const Camera& camera, double bed) {
    SceneBehind behind = planeBelow(camera, bed, 2);
    const glm::dvec3 border = rayThrough(camera, camera.width / 2, camera.height - 1);
    const glm::dvec3 middle = camera.eye + border * ((bed - camera.eye.y) / border.y) + glm::dvec3(0, 0, 1.5);
    for (int stone = -3; stone <= 3; ++stone) {
        const glm::dvec3 radii = glm::dvec3(0.7, 1, 1) * (1 + 0.15 * stone);
        const glm::dvec3 from = (camera.eye - middle - glm::dvec3(2.5 * stone, 0, 0)) / radii;
        behind = drawnOver(camera, behind, 0, [&](const glm::dvec3& ray) {
            const glm::dvec3 along = ray / radii;
            const double half = glm::dot(along, from), squared = glm::dot(along, along);
            const double root = half * half - squared * (glm::dot(from, from) - 1);
            return root < 0 ? -1 : (-half - std::sqrt(root)) / squared;
        });
    }
    return behind;
}

/// A level bed, and on it bright thin posts where the picture's lower border cuts them off.
SceneBehind postsAtTheBorder(const Camera& camera, double bed) {
    const glm::dvec3 border = rayThrough(camera, camera.width / 2, camera.height - 1);
    const double z = camera.eye.z + border.z * ((bed + 1 - camera.eye.y) / border.y);
    return drawnOver(camera, planeBelow(camera, bed, 2), 20, [&](const glm::dvec3& ray) {
        const double distance = (z - camera.eye.z) / ray.z;
        const glm::dvec3 met = camera.eye + distance * ray;
        const bool hits = met.y > bed && met.y < bed + 1.2 && met.x - std::floor(met.x) < 0.1;
        return hits ? distance : -1;
    });
}

/// A level bed with narrow cracks, as bright and 2 m deep, where the picture's lower border cuts them off.
SceneBehind cracksAtTheBorder(const Camera& camera, double bed) {
    const glm::dvec3 border = rayThrough(camera, camera.width / 2, camera.height - 1);
    const double z = camera.eye.z + border.z * ((bed - camera.eye.y) / border.y);
    return drawnOver(camera, planeBelow(camera, bed - 2, 2), 2, [&](const glm::dvec3& ray) {
        const double distance = ray.y < 0 ? (bed - camera.eye.y) / ray.y : -1;
        const glm::dvec3 met = camera.eye + distance * ray;
        return met.z > z - 0.7 && met.x - std::floor(met.x) < 0.1 ? -1 : distance;
    });
}

/// Of a bed on which things stand that the picture's lower border cuts off: the lowest row's light, of that
/// of the bare bed, pixel by pixel.
class ShadingSamplesBeyondTheBorder : public ShadingSamples {
  protected:
    std::vector<float> lowestRow(SceneBehind (*thingsOn)(const Camera&, double)) {
        const RefractionDesc absorbing = {{0.3f, 0.3f, 0.3f}, {0, 0, 0}, 1};
        BodyDesc desc;
        desc.refraction = &absorbing;
        Camera camera = low();
        camera.eye = {0, 2.2, 6};
        camera.target = {0, 1.6, -14};
        camera.width = 384;
        camera.height = 216;
        Body* const body = makeBody(desc);
        const WaterPicture bare =
            picture({body}, camera, 0, SurfaceOutput::shaded, planeBelow(camera, -3, 2));
        const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::shaded, thingsOn(camera, -3));
        std::vector<float> row;
        for (uint32_t x = 0; x < p.width; ++x) {
            const size_t i = (size_t{p.height - 1} * p.width + x) * 4;
            row.push_back(p.color[i] / bare.color[i]);
        }
        return row;
    }
};

// A stone that the picture's border cuts off is no bed that goes on: it would be drawn out to a dark wall.
TEST_F(ShadingSamplesBeyondTheBorder, SeeTheBedAndNoStoneOnIt) {
    const auto dark = std::ranges::count_if(lowestRow(stonesAtTheBorder), [](float of) { return of < 0.9f; });
    std::printf("%td pixels of the lowest row are dark\n", dark);
    EXPECT_LE(dark, 2);
}

// Nor is a post, by how high it stands: it would be drawn out to a streak of the light that falls into
// shallow water.
TEST_F(ShadingSamplesBeyondTheBorder, DrawOutNoPosts) {
    const auto off =
        std::ranges::count_if(lowestRow(postsAtTheBorder), [](float of) { return std::abs(of - 1) > 0.1f; });
    std::printf("%td pixels of the lowest row are a streak's\n", off);
    EXPECT_LE(off, 4);
}

// Nor is a crack, by how low it lies: the median of heights beside it is the bed's.
TEST_F(ShadingSamplesBeyondTheBorder, DrawOutNoCracks) {
    const auto off =
        std::ranges::count_if(lowestRow(cracksAtTheBorder), [](float of) { return std::abs(of - 1) > 0.1f; });
    std::printf("%td pixels of the lowest row are a streak's\n", off);
    EXPECT_LE(off, 4);
}

} // namespace
