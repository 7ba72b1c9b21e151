#include "water/body/body_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "water/body/body.h"
#include "water/body/lighting.h"
#include "water/body/sky_colors.h"
#include "water/sea/sea.h"

namespace seaglass {

namespace {

glm::vec4 color(const float (&values)[3]) {
    return {values[0], values[1], values[2], 0};
}

/// Where `position` lies in its tile, in tiles, 0..1: taken in double, since a float far from the origin
/// cannot say.
double inTile(double position, double tile) {
    const double tiles = position / tile;
    return tiles - std::floor(tiles);
}

void setWaves(BodyBlock& u, const Sea& sea, const WaveMaps& maps, const glm::dvec3& eye) {
    u.seaCascades = static_cast<int32_t>(maps.cascades);
    u.maxMip = static_cast<float>(maps.mipLevels - 1);
    const SlopeCovariance rough = roughness(sea);
    const double whole = std::sqrt((resolvedSlopeVariance(sea) + unresolvedSlopeVariance(sea)) / 2);
    u.roughness = glm::vec4(rough.uu, rough.vv, rough.uv, whole);
    for (uint32_t i = 0; i < maps.cascades; ++i) {
        const double patch = cascade(sea, i).patch;
        // Maps hold samples at i * patch / samples, textures at half a texel more.
        const double half = 0.5 / maps.samples;
        u.cascade[i] = glm::vec4(inTile(eye.x, patch) + half, inTile(eye.z, patch) + half, 1 / patch,
                                 maps.samples / patch);
    }
}

void setShore(BodyBlock& u, const Shore& shore, const ShoreMap& map, const glm::dvec3& eye) {
    const ShoreSignal& signal = map.signal();
    const double spacing = shore.spacing();
    const glm::dvec2 samples(shore.samples()[0], shore.samples()[1]);
    const glm::dvec2 fromFirst =
        (glm::dvec2(eye.x, eye.z) - glm::dvec2(shore.origin()[0], shore.origin()[1])) / spacing;
    u.shorePlace = glm::vec4((fromFirst + 0.5) / samples, 1.0 / (samples * spacing));
    u.shoreSignal = {signal.rowsPerSecond, signal.offset, signal.count, spacing};
    u.shoreForm = {shore.peak() / (2 * std::numbers::pi), shore.carried(), map.last().offset, 0};
}

void setFoam(BodyBlock& u, const Foam& foam, const Sea& sea, const glm::dvec3& eye) {
    const FoamStreak streak = foamStreakOf(description(sea));
    double placeU = eye.x, placeV = eye.z;
    streak.apply(placeU, placeV);
    u.foam = glm::vec4(foam.past(), foam.albedo(), inTile(placeU, foamRepeat) * foamRepeat,
                       inTile(placeV, foamRepeat) * foamRepeat);
    u.foamStreak = {streak.u, streak.v};
}

void setCaustics(BodyBlock& u, const Caustics& caustics, const CausticGrid& grid) {
    const SunInWater sun = sunInWater(glm::dvec3(u.toSun));
    u.sunInWater = glm::vec4(glm::vec3(sun.from), 0);
    u.sunTurned = glm::vec4(sun.turnedAlong, sun.turnedAcross, 0, 0);
    u.caustics.x = caustics.strength();
    u.causticGrid = {grid.step, grid.margin, grid.rowLength, grid.firstRow};
    static_assert(sizeof u.lostSlopes == sizeof(LostSlopes));
    std::memcpy(u.lostSlopes, caustics.lostSlopes().data(), sizeof u.lostSlopes);
}

void setFog(BodyBlock& u, const FogBlock& fog) {
    u.fogColor = glm::make_vec4(fog.color);
    u.fogForm = glm::make_vec4(fog.form);
    u.fogReach = glm::make_vec4(fog.reach);
}

void setExclusionVolumes(BodyBlock& u, const std::vector<ExclusionPlanes>& volumes, const glm::dvec3& eye) {
    std::fill_n(u.exclusionPlanes, volumesPacked(volumes) * size_t{exclusionVolumePlanes},
                glm::vec4(0, 0, 0, 1)); // holding nothing
    vec4* out = u.exclusionPlanes;
    for (const ExclusionPlanes& volume : volumes)
        for (const glm::dvec4& plane : volume)
            *out++ = glm::vec4(glm::vec3(plane), plane.w + glm::dot(glm::dvec3(plane), eye));
}

} // namespace

void setBed(BodyBlock& u, const BedPicture& bed, const glm::dvec3& eye) {
    glm::dmat4 moved(1);
    moved[3] = glm::dvec4(eye - bed.camera.eye, 1);
    const glm::dmat4 pixelFromRelative = scenePixelFromRelative(bed.camera) * moved;
    u.bedFromRelative = glm::mat4(pixelFromRelative);
    u.relativeFromBed = glm::mat4(glm::inverse(pixelFromRelative));
    u.bedSize = {bed.camera.regionSize, 0, 0};
}

BodyBlock bodyBlock(const Body& body, const ViewGeometry& geometry, const LightingDesc& lighting) {
    BodyBlock u{};
    u.bedFromRelative = u.relativeFromBed = mat4(1);
    u.sight.w = 1;
    u.covered = {-1e9f, -1e9f, 1e9f, 1e9f};
    u.reflectionScale = 1;
    u.clipFromRelative = glm::mat4(geometry.clipFromRelative);
    u.pixelFromRelative = glm::mat4(geometry.pixelFromRelative);
    u.relativeFromPixel = glm::mat4(relativeFromScenePixel(geometry));
    u.plane = glm::vec4(glm::vec3(body.plane), body.heightOf(geometry.eye));
    if (geometry.parallel) u.sight = glm::vec4(glm::vec3(geometry.sight), 0);
    u.toSun = glm::vec4(glm::vec3(body.toSun(lighting)), 0);
    u.worldFromBody = glm::mat3x4(body.frame.worldFromBody);
    u.sunIrradiance = color(lighting.sunIrradiance);
    u.skyIrradiance = glm::vec4(glm::vec3(skyIrradiance(lighting, body.frame.worldFromBody[1])), 0);
    if (!lighting.skyCube) {
        u.skyZenith = color(lighting.skyZenith);
        u.skyHorizon = color(lighting.skyHorizon);
        u.skyGround = color(lighting.skyGround);
    }
    const bool sunShines = u.toSun.y > 0 && glm::vec3(u.sunIrradiance) != glm::vec3(0);
    if (lighting.shadow && sunShines) setSunShadow(u, *lighting.shadow, body.frame, geometry.eye);
    if (lighting.fog) setFog(u, fogBlock(*lighting.fog, (body.frame.worldFromBody * geometry.eye).y));
    u.skyMips = static_cast<float>(lighting.skyCubeMipLevels);
    u.sceneShift = glm::vec2(geometry.sceneShift);
    u.region = glm::ivec4(geometry.regionOrigin, geometry.regionSize);
    u.farDepth = static_cast<float>(geometry.farDepth);
    u.depthSign = geometry.reversedDepth ? 1.0f : -1.0f;
    u.reflectionDistortion = body.reflectionDistortion;
    if (body.reflector) {
        const ReflectionDesc& reflection = body.reflection;
        u.reflectionScale = static_cast<float>(sizedFor(reflection, extentOf(geometry)).downscale);
        u.reflectionLook = {reflection.clearDistance, reflection.scatter, reflection.skyFadeDistance, 0};
    }
    if (body.waves) setWaves(u, *body.sea, body.waves->maps(), geometry.eye);
    if (body.shore) setShore(u, *body.sea->shore, *body.shore, geometry.eye);
    if (body.hostMesh) {
        const glm::dvec2 origin = body.hostMesh->origin - glm::dvec2(geometry.eye.x, geometry.eye.z);
        u.extent = glm::vec4(glm::vec2(origin), 0, 0);
    }
    if (body.outline && body.sea)
        u.extent.z = static_cast<float>(1 / pinnedWithin(largestDisplacement(*body.sea)));
    u.extent.w = static_cast<float>(body.globe.curvature);
    if (body.foam) setFoam(u, *body.foam, *body.sea, geometry.eye);
    if (body.refraction) {
        u.absorption = glm::vec4(glm::vec3(color(body.refraction->absorption)), body.refraction->scattering);
        u.backscatter = color(body.refraction->backscatter);
        u.refractionDistortion = body.refraction->distortion;
    }
    u.within.x = static_cast<float>(body.cellNearEye(geometry));
    if (body.sea) u.within.z = static_cast<float>(significantWaveHeight(*body.sea) / 4);
    if (body.underwater) u.within.y = body.underwater->meniscus / 2;
    if (body.outline) u.covered = body.outline->boxFrom({geometry.eye.x, geometry.eye.z}).packed();
    setExclusionVolumes(u, body.exclusionVolumes, geometry.eye);
    if (body.caustics)
        setCaustics(u, *body.caustics, causticGrid(body.shading, geometry, body.heightOf(geometry.eye)));
    return u;
}

} // namespace seaglass
