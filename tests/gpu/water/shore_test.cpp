// Water at a shore as it is drawn: that it stands where the height queries say, from above, for an eye in it,
// in motion and in the light on the bed; where it is white, and that a sea without a bed knows nothing of it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <span>

#include "gpu/pipeline/kernel.h"
#include "seaglass/shore.h"
#include "seaglass/waves_fftw.h"
#include "spirv/wet_sand.comp.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/near_plane.h"
#include "tests/gpu/rig/water_rig.h"
#include "tests/unit/sea/statistics.h"
#include "water/body/body.h"
#include "water/sea/sea.h"
#include "water/shore/shore_part.h"

namespace {

using namespace seaglass;
using namespace tests;

class ShoreOnGpu : public WaterTest {
  protected:
    static constexpr double slope = 1.0 / 20;

    void SetUp() override {
        WaterTest::SetUp();
        shore_.samples[0] = 104; // whole rows of 64 bytes: no padding in memory
        shore_.samples[1] = 301;
        shore_.origin[0] = -52;
        shore_.origin[1] = -270;
        for (uint32_t j = 0; j < shore_.samples[1]; ++j)
            bed_.insert(bed_.end(), shore_.samples[0], static_cast<float>(slope * (shore_.origin[1] + j)));
        shore_.bed = bed_.data();
        sea_.windSpeed = 4;
        sea_.windDirection = static_cast<float>(std::numbers::pi / 2);
        sea_.fetch = 3e3f;
        sea_.swells[0] = {0.5f, 5.0f, sea_.windDirection, 0.1f, 50};
        sea_.samples = 128;
        sea_.shore = &shore_;
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
        desc_.mesh.cellSize = 0.1f;
    }

    /// Towards the water's edge from the sea.
    static Camera camera(double aside = 0) {
        Camera camera;
        camera.eye = {aside, 5, -24};
        camera.target = {0, 0, -8};
        camera.width = 320;
        camera.height = 180;
        return camera;
    }

    /// What hosts' shaders are told of the sand at each of `places`: (u, v) from the block's eye, height.
    std::vector<glm::vec2> toldAt(const Sea& sea, const ShoreBlock& block, const std::vector<float>& rows,
                                  const std::vector<glm::vec4>& places);

    std::vector<float> bed_;
    ShoreDesc shore_;
    SeaDesc sea_;
    FoamDesc foam_;
    BodyDesc desc_;
};

gpu::Buffer filledBuffer(const gpu::Device& device, std::span<const std::byte> first,
                         std::span<const std::byte> then) {
    gpu::Buffer out;
    EXPECT_EQ(out.createMapped(device, first.size() + then.size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                               "what is told"),
              Status::ok);
    std::memcpy(out.mapped(), first.data(), first.size());
    std::memcpy(static_cast<std::byte*>(out.mapped()) + first.size(), then.data(), then.size());
    return out;
}

std::vector<glm::vec2> ShoreOnGpu::toldAt(const Sea& sea, const ShoreBlock& block,
                                          const std::vector<float>& rows,
                                          const std::vector<glm::vec4>& places) {
    const gpu::Device& device = context()->device;
    uint32_t texels[2];
    shoreSamples(sea, texels);
    std::vector<float> map(size_t{4} * texels[0] * texels[1]);
    EXPECT_TRUE(shoreTexels(sea, map.data()));
    const demos::Image image = uploadFloats(texels[0], texels[1], 4, map);
    const gpu::Buffer given =
        filledBuffer(device, std::as_bytes(std::span(&block, 1)), std::as_bytes(std::span(places)));
    const gpu::Buffer heldRows = filledBuffer(device, std::as_bytes(std::span(rows)), {});
    std::vector<glm::vec2> told(places.size());
    const gpu::Buffer left = filledBuffer(device, std::as_bytes(std::span(told)), {});
    gpu::Kernel kernel;
    EXPECT_EQ(kernel.create(device, wet_sand_comp, "wet sand"), Status::ok) << message();
    frame([&](VkCommandBuffer commands) {
        const gpu::Bound resources[] = {
            {0, gpu::storageBuffer(given.handle())},
            {1, gpu::storageBuffer(heldRows.handle())},
            {2, gpu::sampledImage(context()->samplers.nearestClamp(), asSeaglass(image).view)},
            {3, gpu::storageBuffer(left.handle())}};
        VkDescriptorSet set = VK_NULL_HANDLE;
        EXPECT_EQ(context()->frame().allocateSet(kernel.layout(), resources, set), Status::ok) << message();
        kernel.dispatchAlong(commands, set, static_cast<uint32_t>(places.size()));
        gpu::recordBarrier(device, commands,
                           {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                           {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
    });
    std::memcpy(told.data(), left.mapped(), told.size() * sizeof told[0]);
    return told;
}

TEST_F(ShoreOnGpu, HostsShadersFindTheSandAsWetAsTheCpuDoes) {
    sea_.swells[0] = {1.2f, 9.0f, sea_.windDirection + 0.4f, 0.1f, 50};
    const std::unique_ptr<Sea, void (*)(Sea*)> beach(createSea(&sea_, nullptr), destroySea);
    constexpr double dryingTime = 45, eye[2] = {3.5, -7.25};
    std::vector<float> rows(size_t{4} * shoreRowCount(*beach, dryingTime));
    size_t damp = 0, thin = 0;
    double worst = 0;
    for (const double time : {31.4, 71.3}) {
        const ShoreBlock block = shoreRows(*beach, time, dryingTime, eye, rows.data());
        std::vector<glm::vec4> places;
        for (int u = -8; u < 8; ++u)
            for (int v = -20; v < 60; ++v)
                for (const float over : {-0.05f, 0.0f, 0.03f}) {
                    const glm::vec2 at(1.7f * static_cast<float>(u), 0.31f * static_cast<float>(v));
                    places.emplace_back(at, static_cast<float>(slope * (double{at.y} + eye[1])) + over, 0);
                }
        const std::vector<glm::vec2> told = toldAt(*beach, block, rows, places);
        for (size_t i = 0; i < places.size(); ++i) {
            const ShoreWetness expected = shoreWetness(*beach, block, rows.data(), double{places[i].x},
                                                       double{places[i].y}, double{places[i].z});
            damp += expected.wet > 0.05 && expected.wet < 0.95;
            thin += expected.under > 0.05 && expected.under < 0.95;
            worst = std::max({worst, std::abs(double{told[i].x} - expected.wet),
                              std::abs(double{told[i].y} - expected.under)});
        }
    }
    std::printf("%zu damp places, %zu under a film, off by %.5f at most\n", damp, thin, worst);
    EXPECT_GT(damp, 100u);
    EXPECT_GT(thin, 20u);
    EXPECT_LT(worst, 1e-3);
}

TEST_F(ShoreOnGpu, TheSurfaceStandsWhereHeightQueriesSay) {
    Body* body = makeBody(desc_);
    const double time = 31.4;
    const WaterPicture p = picture({body}, camera(), time, SurfaceOutput::height);
    std::vector<double> points, drawn;
    for (uint32_t y = 0; y < p.height; y += 5)
        for (uint32_t x = 0; x < p.width; x += 11) {
            if (!p.covered(size_t{y} * p.width + x)) continue;
            const glm::dvec3 world = worldAt(camera(), p, x, y);
            // What lies on the sand as a film is not water's height.
            if (glm::length(world - camera().eye) > 22 || world.y < slope * world.z + 0.06) continue;
            points.insert(points.end(), {world.x, world.z});
            drawn.push_back(world.y);
        }
    ASSERT_GT(drawn.size(), 200u);
    std::vector<HeightSample> samples(drawn.size());
    sampleHeights(*sea(body), time, points.data(), samples.size(), samples.data());
    double worst = 0, highest = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
        worst = std::max(worst, std::abs(drawn[i] - double{samples[i].height}));
        highest = std::max(highest, drawn[i]);
    }
    std::printf("worst difference %.4f m, highest wave %.2f m\n", worst, highest);
    EXPECT_LT(worst, 0.05);
    EXPECT_GT(highest, 0.1);
}

// Of a swell that comes aslant, so that no axis is like the other.
TEST_F(ShoreOnGpu, NormalsAreThoseOfHeightQueries) {
    sea_.windSpeed = 0;
    sea_.swells[0].height = 0.8f;
    sea_.swells[0].peakPeriod = 3.5f;
    sea_.swells[0].direction += 0.9f;
    Body* const body = makeBody(desc_);
    Camera seenBy = camera();
    seenBy.eye = {0, 6, -40};
    seenBy.target = {0, 0, -34};
    double apart = 0, steep = 0;
    for (const double time : {31.4, 33.0}) {
        const WaterPicture places = picture({body}, seenBy, time, SurfaceOutput::height),
                           normals = picture({body}, seenBy, time, SurfaceOutput::normal);
        for (uint32_t y = 0; y < seenBy.height; y += 7)
            for (uint32_t x = 0; x < seenBy.width; x += 11) {
                const size_t i = size_t{y} * seenBy.width + x;
                const glm::dvec3 world = worldAt(seenBy, places, x, y);
                if (!places.covered(i) || glm::length(world - seenBy.eye) > 18) continue;
                const double point[] = {world.x, world.z};
                HeightSample sample;
                sampleHeights(*sea(body), time, point, 1, &sample);
                for (const size_t axis : {size_t{0}, size_t{2}}) {
                    const double expected = double{sample.normal[axis]} / double{sample.normal[1]};
                    const double off =
                        double{normals.color[4 * i + axis]} / double{normals.color[4 * i + 1]} - expected;
                    apart += off * off;
                    steep += expected * expected;
                }
            }
    }
    std::printf("slopes are off by %.4f of what they are\n", std::sqrt(apart / steep));
    EXPECT_LT(std::sqrt(apart / steep), 0.02);
}

// Where water has run up and back, a film is left on the sand: by 12 mm, and 1 % of what the mesh shows as
// one.
TEST_F(ShoreOnGpu, WetSandBearsAFilm) {
    Body* const body = makeBody(desc_);
    size_t film = 0;
    for (const double time : {30.0, 33.0, 36.0}) {
        const WaterPicture p = picture({body}, camera(), time, SurfaceOutput::height);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                if (!p.covered(size_t{y} * p.width + x)) continue;
                const glm::dvec3 world = worldAt(camera(), p, x, y);
                const double over = world.y - slope * world.z; // [m]
                film += over > 0.0125 && over < 0.016;
            }
    }
    std::printf("%zu pixels of film\n", film);
    EXPECT_GT(film, 250u);
}

/// The sand of the map, and a wall on it at `wallZ`, of these radiances.
SceneBehind wallOnTheSand(const Camera& camera, double slope, double wallZ, float sand, float wall) {
    const auto toSand = [&](const glm::dvec3& ray) {
        return (slope * camera.eye.z - camera.eye.y) / (ray.y - slope * ray.z);
    };
    const auto toWall = [&](const glm::dvec3& ray) {
        const double t = (wallZ - camera.eye.z) / ray.z, sandAt = toSand(ray);
        return sandAt > 0 && sandAt < t ? -1 : t;
    };
    return drawnOver(camera, drawnOver(camera, nothingBehind(camera), sand, toSand), wall, toWall);
}

TEST_F(ShoreOnGpu, WetSandIsAsLevelAsTheSandUnderIt) {
    Body* const body = makeBody(desc_);
    double off = 0;
    size_t film = 0;
    for (const double time : {30.0, 33.0, 36.0}) {
        const WaterPicture p = picture({body}, camera(), time, SurfaceOutput::height),
                           slopes = picture({body}, camera(), time, SurfaceOutput::slopes);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                const glm::dvec3 world = worldAt(camera(), p, x, y);
                const double over = world.y - slope * world.z; // [m]
                if (!p.covered(i) || over < 0.0125 || over > 0.016) continue;
                off += std::hypot(double{slopes.color[4 * i]}, double{slopes.color[4 * i + 1]} - slope);
                ++film;
            }
    }
    std::printf("%zu pixels of film, off by %.4f in the mean\n", film, off / static_cast<double>(film));
    EXPECT_GT(film, 250u);
    EXPECT_LT(off / static_cast<double>(film), 0.01);
}

// Black sand under a sky: what it sends is the film's.
TEST_F(ShoreOnGpu, WetSandShinesThoughTheSandIsSeenThroughIt) {
    const RefractionDesc clear = {{0.3f, 0.1f, 0.1f}, {0, 0, 0}, 1};
    desc_.refraction = &clear;
    Body* const body = makeBody(desc_);
    const Camera seenBy = camera();
    const SceneBehind sand = drawnOver(seenBy, nothingBehind(seenBy), 0, [&](const glm::dvec3& ray) {
        return (slope * seenBy.eye.z - seenBy.eye.y) / (ray.y - slope * ray.z);
    });
    size_t film = 0, shining = 0;
    for (const double time : {30.0, 33.0, 36.0}) {
        const WaterPicture p = picture({body}, seenBy, time, SurfaceOutput::height, sand),
                           shaded = picture({body}, seenBy, time, SurfaceOutput::shaded, sand);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                const glm::dvec3 world = worldAt(seenBy, p, x, y);
                const double over = world.y - slope * world.z; // [m]
                if (!p.covered(i) || over < 0.0125 || over > 0.016) continue;
                shining += shaded.color[4 * i] > 0.01f;
                ++film;
            }
    }
    std::printf("%zu pixels of film, %zu shine\n", film, shining);
    EXPECT_GT(film, 250u);
    EXPECT_GT(shining, film / 2);
}

TEST_F(ShoreOnGpu, WetSandMirrorsWhatStandsOnIt) {
    const RefractionDesc refraction;
    const ReflectionDesc reflection;
    desc_.refraction = &refraction;
    desc_.reflection = &reflection;
    Camera up;
    up.eye = {0, 1.6, -6};
    up.target = {0, 1.2, 4};
    up.width = 160;
    up.height = 90;
    const float wall = 30;
    const SceneBehind behind = wallOnTheSand(up, slope, 7, 0.5f, wall);
    Body* const body = makeBody(desc_);
    size_t films = 0, mirrors = 0;
    for (const double time : {20.0, 22.5}) {
        const WaterPicture p = picture({body}, up, time, SurfaceOutput::reflection, behind);
        const WaterPicture at = picture({body}, up, time, SurfaceOutput::shaded, behind);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                if (!p.covered(i)) continue;
                const glm::dvec3 world = worldAt(up, at, x, y);
                if (world.z > 6 || std::abs(world.y - slope * world.z) > 0.03 || world.y < 0.05) continue;
                ++films;
                mirrors += p.color[4 * i] > 0.8f * wall ? 1 : 0;
            }
    }
    std::printf("%zu pixels of film, %zu mirror the wall\n", films, mirrors);
    ASSERT_GT(films, 300u);
    EXPECT_GT(static_cast<double>(mirrors), 0.9 * static_cast<double>(films));
}

/// In the surf, looking up, so that no ray from above meets the water.
Camera straddling() {
    Camera camera;
    camera.eye = {3, -0.3, -14};
    camera.target = {3, 30, -2};
    camera.near = 0.4;
    camera.fovDegrees = 60;
    return camera;
}

TEST_F(ShoreOnGpu, TheWaterlineIsThatOfTheWavesOverTheBed) {
    const RefractionDesc refraction{{0, 0, 0}, {0, 0, 0}, 1};
    UnderwaterDesc underwater;
    underwater.meniscus = 0;
    desc_.refraction = &refraction;
    desc_.underwater = &underwater;
    sea_.warp = 0;      // strays beyond what is unsure are so few that each sea has its own number of them
    sea_.samples = 256; // finer, so that the maps' interpolation leaves little open
    Body* const body = makeBody(desc_);
    const Camera camera = straddling();
    NearPlaneCount all;
    for (const double time : {20.75, 21.5, 23.0}) { // when water crosses the near plane
        constexpr double unsure = 0.004;
        const NearPlaneCount now =
            countNearPlane(picture({body}, camera, time), camera, *sea(body), time, unsure);
        all.wet += now.wet;
        all.dry += now.dry;
        all.wrong += now.wrong;
    }
    std::printf("%zu wet, %zu dry, %zu wrong\n", all.wet, all.dry, all.wrong);
    EXPECT_GT(all.wet, 1000u);
    EXPECT_GT(all.dry, 1000u);
    EXPECT_EQ(all.wrong, 0u);
}

TEST_F(ShoreOnGpu, TheMeniscusLiesAtTheWaterlineAlone) {
    const RefractionDesc refraction;
    UnderwaterDesc underwater;
    desc_.refraction = &refraction;
    desc_.underwater = &underwater;
    const auto drawn = [&](float meniscus) {
        underwater.meniscus = meniscus;
        return picture({makeBody(desc_)}, straddling(), 20.75); // water crosses the near plane then
    };
    const WaterPicture with = drawn(0.01f), without = drawn(0);
    size_t drawnAt = 0, astray = 0;
    const int width = static_cast<int>(with.width), height = static_cast<int>(with.height), apart = 4;
    const auto covered = [&](int x, int y) { return without.covered(static_cast<size_t>(y * width + x)); };
    for (int y = apart; y + apart < height; ++y)
        for (int x = apart; x + apart < width; ++x) {
            const size_t i = static_cast<size_t>(y * width + x) * 4;
            if (with.color[i] == without.color[i]) continue;
            ++drawnAt;
            astray += covered(x, y - apart) == covered(x, y + apart) &&
                      covered(x - apart, y) == covered(x + apart, y);
        }
    EXPECT_GT(drawnAt, 100u);
    EXPECT_EQ(astray, 0u);
}

TEST_F(ShoreOnGpu, MotionIsThatOfTheWavesOverTheBed) {
    desc_.motion = true;
    Body* const body = makeBody(desc_);
    const double before = 31.4, now = 31.45;
    const Camera seenBy = camera();
    const auto motionOf = [&](Body* moving) {
        picture({moving}, seenBy, before, SurfaceOutput::motion);
        return picture({moving}, seenBy, now, SurfaceOutput::motion);
    };
    const WaterPicture p = motionOf(body);
    const glm::dmat4 clipFromWorld = projectionMatrix(seenBy) * viewMatrix(seenBy);
    const auto pixelOf = [&](const glm::dvec3& world) {
        const glm::dvec4 clip = clipFromWorld * glm::dvec4(world, 1);
        return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(seenBy.width, seenBy.height);
    };
    std::vector<double> off;
    double greatest = 0;
    for (uint32_t y = 0; y < p.height; y += 5)
        for (uint32_t x = 0; x < p.width; x += 11) {
            const size_t i = size_t{y} * p.width + x;
            if (!p.covered(i)) continue;
            const glm::dvec3 world = worldAt(seenBy, p, x, y);
            // What lies on the sand as a film does not move with the water.
            if (glm::length(world - seenBy.eye) > 22 || world.y < slope * world.z + 0.06) continue;
            const double point[] = {world.x, world.z};
            HeightSample sample;
            sampleHeights(*sea(body), (before + now) / 2, point, 1, &sample);
            const glm::dvec3 velocity(sample.velocity[0], sample.velocity[1], sample.velocity[2]);
            const glm::dvec2 expected = pixelOf(world) - pixelOf(world - velocity * (now - before));
            off.push_back(glm::length(glm::dvec2(p.color[i * 4], p.color[i * 4 + 1]) - expected));
            greatest = std::max(greatest, glm::length(expected));
        }
    ASSERT_GT(off.size(), 200u);
    std::printf("motion up to %.2f pixels, off by %.3f in the mean and %.3f at most\n", greatest, meanOf(off),
                *std::ranges::max_element(off));
    EXPECT_GT(greatest, 0.5);
    EXPECT_LT(meanOf(off), 0.05 * greatest);
    EXPECT_LT(*std::ranges::max_element(off), 0.25 * greatest);
    // And of a body that ends far away.
    desc_.extent.shape = ExtentShape::rectangle;
    desc_.extent.size[0] = desc_.extent.size[1] = 400;
    const WaterPicture outlined = motionOf(makeBody(desc_));
    double apart = 0;
    for (size_t i = 0; i < p.depth.size(); ++i)
        if (p.depth[i] > seenBy.near / 22)
            apart = std::max(apart, std::abs(double{outlined.color[i * 4]} - double{p.color[i * 4]}));
    EXPECT_LT(apart, 0.01);
}

TEST_F(ShoreOnGpu, SunlightGathersBelowTheWavesOverTheBed) {
    const RefractionDesc refraction{{0, 0, 0}, {0, 0, 0}, 1};
    const CausticsDesc caustics;
    sea_.windSpeed = 0; // the swell alone, which the bed changes most
    desc_.refraction = &refraction;
    desc_.caustics = &caustics;
    Body* const body = makeBody(desc_);
    lighting.toSun[0] = 0;
    lighting.toSun[1] = 1;
    lighting.toSun[2] = 0;
    for (float& channel : lighting.sunIrradiance) channel = 5;
    for (float& channel : lighting.skyIrradiance) channel = 0;
    const double time = 31.4, depth = 3;
    // 16 m from side to side of what lies under the waves that a bed guides.
    constexpr double side = 16, middle = -20;
    Camera seenBy;
    seenBy.eye = {0, 40 - depth, middle};
    seenBy.target = {0, 0, middle};
    seenBy.fovDegrees = 2 * std::atan(side / 2 / 40) * 180 / std::numbers::pi;
    seenBy.width = seenBy.height = 256;
    drawCausticsOf(body);
    const WaterPicture p =
        picture({body}, seenBy, time, SurfaceOutput::shaded, planeBelow(seenBy, -depth, 1));
    // Photons through the surface on a net, each refracted at the normal there.
    constexpr int cells = 16, net = 180;
    constexpr double reach = 20;
    std::vector<double> points;
    for (int j = 0; j < net; ++j)
        for (int i = 0; i < net; ++i)
            points.insert(points.end(), {(i + 0.5) * reach / net - reach / 2,
                                         middle + (j + 0.5) * reach / net - reach / 2});
    std::vector<HeightSample> samples(points.size() / 2);
    const std::unique_ptr<HeightGrid, void (*)(HeightGrid*)> grid(createHeightGrid(*sea(body), time),
                                                                  destroyHeightGrid);
    sampleHeights(*grid, points.data(), samples.size(), samples.data());
    std::vector<double> fallen(cells * cells), drawn(cells * cells);
    // Each lights as much of the bed as its part of the net, so that still water lights all of it alike.
    constexpr double half = cells * reach / net / side / 2;
    const auto light = [&](double u, double v) {
        const auto share = [](double c, double cell) {
            return (std::min(c + half, cell + 1) - std::max(c - half, cell)) / (2 * half);
        };
        for (double row = std::floor(v - half); row < v + half; ++row)
            for (double column = std::floor(u - half); column < u + half; ++column)
                if (std::min(row, column) >= 0 && std::max(row, column) < cells)
                    fallen[static_cast<size_t>(row) * cells + static_cast<size_t>(column)] +=
                        share(u, column) * share(v, row);
    };
    for (size_t i = 0; i < samples.size(); ++i) {
        const glm::dvec3 normal(samples[i].normal[0], samples[i].normal[1], samples[i].normal[2]);
        const double ratio = 1 / 1.333;
        const double along = ratio * normal.y - std::sqrt(1 - ratio * ratio * (1 - normal.y * normal.y));
        const glm::dvec3 ray = glm::dvec3(0, -ratio, 0) + normal * along;
        const double t = (depth + double{samples[i].height}) / -ray.y;
        light(((points[2 * i] + ray.x * t) / side + 0.5) * cells,
              ((points[2 * i + 1] + ray.z * t - middle) / side + 0.5) * cells);
    }
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x)
            drawn[(y * cells / p.height) * cells + x * cells / p.width] +=
                double{p.color[(size_t{y} * p.width + x) * 4 + 1]} / double{WaterPicture::untouched};
    const double correlation = correlationOf(fallen, drawn);
    const double contrast = deviationOf(drawn) / meanOf(drawn) / (deviationOf(fallen) / meanOf(fallen));
    std::printf("correlation with photons %.3f, contrast %.2f of theirs\n", correlation, contrast);
    EXPECT_GT(correlation, 0.8);
    EXPECT_NEAR(contrast, 1, 0.3);
}

TEST_F(ShoreOnGpu, FoamIsWhereTheWaterThinsAndNotWhereItIsDeep) {
    desc_.foam = &foam_;
    Body* body = makeBody(desc_);
    constexpr int across = 24;
    // Of each metre from side to side and along, or less than nothing where hardly a pixel shows it.
    const auto foamAt = [&](const Camera& seenBy, int from, int to) {
        const WaterPicture p = picture({body}, seenBy, 40, SurfaceOutput::foam);
        std::vector<double> sums(static_cast<size_t>(across * (to - from))), counts(sums.size());
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                if (!p.covered(i)) continue;
                const glm::dvec3 world = worldAt(seenBy, p, x, y);
                const int column = static_cast<int>(std::floor(world.x)) + across / 2,
                          row = static_cast<int>(std::floor(world.z)) - from;
                if (column < 0 || column >= across || row < 0 || row >= to - from) continue;
                const auto place = static_cast<size_t>(row * across + column);
                sums[place] += double{p.color[4 * i]};
                ++counts[place];
            }
        for (size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] < 4 ? -1 : sums[i] / counts[i];
        return sums;
    };
    const auto meanCover = [&](std::vector<double> places) {
        std::erase_if(places, [](double cover) { return cover < 0; });
        EXPECT_GT(places.size(), 200u);
        return meanOf(places);
    };
    const std::vector<double> here = foamAt(camera(), -16, -2);
    Camera offshore = camera();
    offshore.eye.z = -214;
    offshore.target.z = -200;
    const double surf = meanCover(here), deep = meanCover(foamAt(offshore, -206, -190));
    std::printf("cover in the surf %.3f, 10 m deep %.4f\n", surf, deep);
    EXPECT_GT(surf, 0.1);
    EXPECT_LT(deep, 0.005);
    // It lies on the water, whoever looks at it: on each metre, since other views show more of others.
    for (const double aside : {-3.0, 3.0}) {
        const std::vector<double> seenAside = foamAt(camera(aside), -16, -2);
        std::vector<double> changes, sizes;
        for (size_t i = 0; i < here.size(); ++i) {
            if (here[i] < 0 || seenAside[i] < 0) continue;
            changes.push_back(seenAside[i] - here[i]);
            sizes.push_back(std::abs(changes.back()));
        }
        std::printf("from %g m aside %.4f more, off by %.4f a metre\n", aside, meanOf(changes),
                    meanOf(sizes));
        EXPECT_GT(changes.size(), 250u);
        EXPECT_NEAR(meanOf(changes), 0, 0.005);
        EXPECT_LT(meanOf(sizes), 0.02);
    }
}

// Under an even sky: one looks into what rises to a wall, and along what is level.
TEST_F(ShoreOnGpu, FacesDarkenBeforeTheyBreak) {
    sea_.windSpeed = 0;
    sea_.swells[0] = {1.6f, 9.0f, sea_.windDirection, 0.1f, 30};
    desc_.foam = &foam_;
    const RefractionDesc refraction{{0.345f, 0.062f, 0.025f}, {0.001f, 0.002f, 0.003f}, 1};
    desc_.refraction = &refraction;
    Body* const body = makeBody(desc_);
    Camera seenBy = camera();
    seenBy.eye = {0, 3, -45};
    seenBy.target = {0, 0.8, -75};
    seenBy.fovDegrees = 30;
    seenBy.width = 160;
    seenBy.height = 90;
    double light[2] = {}, count[2] = {}; // of faces, and of what is level around them
    for (const double time : {27.5, 29.0, 36.5}) {
        const WaterPicture normals = picture({body}, seenBy, time, SurfaceOutput::normal),
                           foam = picture({body}, seenBy, time, SurfaceOutput::foam),
                           shown = picture({body}, seenBy, time);
        for (uint32_t y = 0; y < seenBy.height; ++y)
            for (uint32_t x = 0; x < seenBy.width; ++x) {
                const size_t i = size_t{y} * seenBy.width + x;
                if (!shown.covered(i) || foam.color[4 * i] > 0.05f) continue;
                const double z = worldAt(seenBy, normals, x, y).z;
                if (z < -95 || z > -55) continue;
                const double rise = double{normals.color[4 * i + 2]} / double{normals.color[4 * i + 1]};
                if (rise < 0.5 && std::abs(rise) > 0.03) continue;
                const size_t kind = rise < 0.5 ? 1 : 0;
                light[kind] += double{shown.color[4 * i + 1]};
                ++count[kind];
            }
    }
    for (size_t i = 0; i < 2; ++i) light[i] /= std::max(count[i], 1.0);
    std::printf("faces %.3f (%.0f pixels), level %.3f (%.0f)\n", light[0], count[0], light[1], count[1]);
    EXPECT_GT(count[0], 300);
    EXPECT_LT(light[0], 0.35 * light[1]);
}

// The mirror's plane lies in the sand there.
TEST_F(ShoreOnGpu, WaterOnTheSandMirrorsTheSkyAndNotTheSand) {
    Body* const ofSkyAlone = makeBody(desc_);
    const ReflectionDesc reflection;
    desc_.reflection = &reflection;
    Body* const body = makeBody(desc_);
    const Camera seenBy = camera();
    SceneBehind black = planeBelow(seenBy, 0, 0);
    for (uint32_t y = 0; y < seenBy.height; ++y)
        for (uint32_t x = 0; x < seenBy.width; ++x) {
            const glm::dvec3 ray = rayThrough(seenBy, x, y);
            const double distance = (slope * seenBy.eye.z - seenBy.eye.y) / (ray.y - slope * ray.z);
            const double along = distance * glm::dot(ray, glm::normalize(seenBy.target - seenBy.eye));
            black.depth[size_t{y} * seenBy.width + x] =
                distance > 0 ? static_cast<float>(seenBy.near / along) : 0;
        }
    double sum = 0, ofSky = 0, count = 0;
    for (const double time : {30.0, 33.0, 36.0}) {
        const auto mirrored = [&](Body* of) {
            return picture({of}, seenBy, time, SurfaceOutput::reflection, black);
        };
        const WaterPicture p = mirrored(body), sky = mirrored(ofSkyAlone);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                if (!p.covered(i)) continue;
                const glm::dvec3 world = worldAt(seenBy, p, x, y);
                if (world.y < 0.05 || world.y > slope * world.z + 0.1) continue;
                sum += double{p.color[4 * i]};
                ofSky += double{sky.color[4 * i]};
                ++count;
            }
    }
    std::printf("of the sky's light %.3f\n", sum / ofSky);
    EXPECT_GT(count, 500);
    EXPECT_GT(sum, 0.75 * ofSky); // 0.3 with the sand
}

/// Behind the edge of a shelf, which hides it, the map alone knows of the bed.
TEST_F(ShoreOnGpu, ABedThatFallsAwayOutOfSightIsSeenThroughTheWater) {
    constexpr double edge = -60, falls = 0.35, deepest = 30;
    const auto depthAt = [&](double z) {
        return z > edge ? -slope * z : std::min(-slope * edge + falls * (edge - z), deepest);
    };
    for (uint32_t j = 0; j < shore_.samples[1]; ++j)
        std::fill_n(bed_.begin() + j * shore_.samples[0], shore_.samples[0],
                    static_cast<float>(-depthAt(shore_.origin[1] + j)));
    sea_.windSpeed = 0;
    sea_.swells[0].height = 0.005f;
    const float extinction = 0.1f;
    const RefractionDesc refraction{{extinction, extinction, extinction}, {0, 0, 0}, 1};
    desc_.refraction = &refraction;
    Body* const body = makeBody(desc_);
    Camera seenBy = camera();
    seenBy.eye = {0, 4, -30};
    seenBy.target = {0, 0, edge};
    const glm::dvec3 forward = glm::normalize(seenBy.target - seenBy.eye);
    // As the host sees it: what lies behind the edge is nowhere in its picture.
    const auto seen = [&](float radiance) {
        SceneBehind behind;
        for (uint32_t y = 0; y < seenBy.height; ++y)
            for (uint32_t x = 0; x < seenBy.width; ++x) {
                const glm::dvec3 ray = rayThrough(seenBy, x, y);
                const double t = (slope * seenBy.eye.z - seenBy.eye.y) / (ray.y - slope * ray.z);
                const bool hit = t > 0 && seenBy.eye.z + t * ray.z > edge;
                behind.depth.push_back(
                    static_cast<float>(hit ? seenBy.near / (t * glm::dot(ray, forward)) : 0));
                behind.color.insert(behind.color.end(), 4, hit ? radiance : 0);
            }
        return picture({body}, seenBy, 20, SurfaceOutput::shaded, behind);
    };
    const WaterPicture bright = seen(8), dark = seen(0);
    size_t checked = 0;
    double worst = 0;
    for (uint32_t y = 0; y < bright.height; y += 2)
        for (uint32_t x = 40; x <= 280; x += 20) {
            const glm::dvec3 ray = rayThrough(seenBy, x, y);
            const glm::dvec3 at = seenBy.eye - ray * (seenBy.eye.y / ray.y);
            if (ray.y > 0 || at.z < edge - 20 || at.z > edge + 20) continue;
            // Where rays pass the edge itself, the map's slope above is not that of the bed that they meet.
            if (at.z > edge && at.z < edge + 5) continue;
            // Snell's law, and where it meets the bed.
            const glm::dvec3 bent = glm::refract(ray, glm::dvec3(0, 1, 0), 1 / waterIndex);
            double low = 0, high = 2 * deepest;
            for (int i = 0; i < 40; ++i) {
                const double middle = (low + high) / 2;
                (-bent.y * middle < depthAt(at.z + bent.z * middle) ? low : high) = middle;
            }
            const double through = (1 - reflectance(-ray.y, Fresnel::exact)) / (waterIndex * waterIndex);
            const double expected = 8 * through * std::exp(-double{extinction} * low);
            const size_t i = (size_t{y} * bright.width + x) * 4 + 1;
            worst = std::max(worst, std::abs(double{bright.color[i] - dark.color[i]} / expected - 1));
            ++checked;
        }
    std::printf("off by %.3f at most, of %zu\n", worst, checked);
    EXPECT_GT(checked, 100u);
    EXPECT_LT(worst, 0.03);
}

TEST_F(ShoreOnGpu, ASeaWithoutABedHasNothingOfIt) {
    desc_.foam = &foam_;
    desc_.wavesOn = WavesOn::cpu;
    const auto costs = [&](const ShoreDesc* shore, size_t& images, Estimate& estimated) {
        sea_.shore = shore;
        EXPECT_EQ(estimate(context(), &desc_, {320, 180}, &estimated), Status::ok) << message();
        spiedCalls().clear();
        Body* const body = makeBody(desc_);
        images = countSpied("CreateImage");
        EXPECT_EQ(bytesSpied(), estimated.bytes);
        EXPECT_EQ(body->find<ShorePart>() != nullptr, shore != nullptr);
        EXPECT_EQ(sea(body)->shore.has_value(), shore != nullptr);
    };
    makeBody(desc_); // what all bodies with foam share
    size_t with = 0, without = 0;
    Estimate dear, cheap;
    costs(&shore_, with, dear);
    costs(nullptr, without, cheap);
    EXPECT_EQ(with, without + 1);
    EXPECT_GE(dear.bytes - cheap.bytes, 2u * 104 * 301 * 48);
}

} // namespace
