#include "host/water/bent_sun.h"

#include "scene/scene.h"

#include <algorithm>
#include <cmath>

#include "host/water/extent.h"
#include "scene/water_plane.h"

namespace demos {
namespace {

constexpr double waterIndex = 1.333;
/// Of the sun's direction and the normal: along the surface no light comes in, and none has to be placed.
constexpr double leastCosine = 1e-3;
/// By which walls may stand in what the water covers [m].
constexpr double margin = 0.1;
/// Of a sea's significant height: three deviations.
constexpr double troughDepth = 0.75;

bool boxOf(const ExtentDesc& desc, BentSun& out, Error& error) {
    SceneExtent extent;
    if (!extentOf(desc, extent, error)) return false;
    if (extent.desc.shape == seaglass::ExtentShape::rectangle) {
        const double c = std::abs(std::cos(extent.desc.yaw)), s = std::abs(std::sin(extent.desc.yaw));
        const double u = extent.desc.size[0] / 2, v = extent.desc.size[1] / 2;
        out.middle = {extent.desc.center[0], extent.desc.center[1]};
        out.half = {c * u + s * v, s * u + c * v};
    } else {
        glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
        for (size_t i = 0; i + 1 < extent.points.size(); i += 2) {
            const glm::dvec2 point(extent.points[i], extent.points[i + 1]);
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        out.middle = (low + high) / 2.0;
        out.half = (high - low) / 2.0;
    }
    out.half += margin;
    return true;
}

/// alongPlane() is linear: what it says of the axes of space makes up the rows of u and v.
void setAxes(const Plane& plane, BentSun& out) {
    for (int i = 0; i < 3; ++i) {
        Vec3 axis{};
        axis[static_cast<size_t>(i)] = 1;
        const Vec3 turned = alongPlane({plane[0], plane[1], plane[2], 0}, axis);
        out.across[i] = turned[0];
        out.along[i] = turned[2];
    }
}

/// Less what a ray runs along the surface on each metre of depth in the water: what it would run on in air.
glm::dvec3 shearOf(const glm::dvec3& normal, const glm::dvec3& toSun, double cosine) {
    const double below = std::sqrt(1 - (1 - cosine * cosine) / (waterIndex * waterIndex));
    const glm::dvec3 aside = toSun - cosine * normal;
    return aside / (waterIndex * below) - aside / cosine;
}

/// How far along the surface a ray runs on each metre of depth, through facets that lean by `lean`.
glm::dvec3 straysBy(const glm::dvec3& normal, const glm::dvec3& toSun, const glm::dvec3& lean) {
    const glm::dvec3 ray = glm::refract(-toSun, glm::normalize(normal - lean), 1 / waterIndex);
    const double down = -glm::dot(ray, normal);
    return (ray + down * normal) / down;
}

/// Most along the sun's own direction.
std::array<glm::dvec3, 2> straysOf(const BentSun& sun, const glm::dvec3& toSun, double slopeVariance) {
    constexpr double step = 0.01; // of slope
    const double deviation = std::sqrt(slopeVariance / 2);
    const glm::dvec3 aside = toSun - glm::dot(sun.normal, toSun) * sun.normal;
    const double length = glm::length(aside);
    const glm::dvec3 along = length > 1e-6 ? aside / length : sun.across;
    std::array<glm::dvec3, 2> strays;
    for (size_t i = 0; i < 2; ++i) {
        const glm::dvec3 lean = step * (i ? glm::cross(sun.normal, along) : along);
        strays[i] = (straysBy(sun.normal, toSun, lean) - straysBy(sun.normal, toSun, -lean)) *
                    (deviation / (2 * step));
    }
    return strays;
}

/// So that what the water covers has -1 to 1.
glm::vec4 scaledAxis(const glm::dvec3& axis, double middle, double half, const glm::dvec3& eye) {
    return glm::vec4(glm::dvec4(axis, glm::dot(axis, eye) - middle) / half);
}

} // namespace

bool bentSunOf(const WaterDesc& water, const glm::dvec3& toSun, const BendingWaves& waves, BentSun& out,
               Error& error) {
    const Plane plane = waterPlane(water);
    BentSun sun;
    sun.normal = {plane[0], plane[1], plane[2]};
    sun.offset = plane[3];
    setAxes(plane, sun);
    if (water.extent && !boxOf(*water.extent, sun, error)) return false;
    const double cosine = glm::dot(sun.normal, toSun);
    sun.bends = toSun.y > 0 && cosine > leastCosine;
    if (sun.bends) {
        sun.shear = shearOf(sun.normal, toSun, cosine);
        sun.strays = straysOf(sun, toSun, waves.slopeVariance);
        sun.troughs = troughDepth * waves.height;
    }
    out = sun;
    return true;
}

BentShare shareOf(const BentSun& sun, std::span<const glm::dvec3, 8> corners) {
    if (!sun.bends) return {};
    // Beyond a side of the box in which rays are bent, and within it: the surface, and two sides each of u
    // and v.
    bool out[5] = {true, true, true, true, true}, in = true;
    for (const glm::dvec3& corner : corners) {
        const double u = glm::dot(sun.across, corner) - sun.middle.x,
                     v = glm::dot(sun.along, corner) - sun.middle.y;
        const double inside[5] = {sun.depthOf(corner), sun.half.x - u, sun.half.x + u, sun.half.y - v,
                                  sun.half.y + v};
        for (size_t side = 0; side < 5; ++side) {
            out[side] = out[side] && inside[side] <= 0;
            in = in && inside[side] > 0;
        }
    }
    return {std::none_of(std::begin(out), std::end(out), [](bool beyond) { return beyond; }), in};
}

glm::dmat4 shearFromEye(const BentSun& sun, const glm::dvec3& eye) {
    glm::dmat4 shear(1);
    for (int i = 0; i < 3; ++i) shear[i] -= glm::dvec4(sun.shear * sun.normal[i], 0);
    shear[3] += glm::dvec4(sun.shear * sun.depthOf(eye), 0);
    return shear;
}

void setBentUniforms(const BentSun& sun, const glm::dvec3& eye, FrameUniforms& uniforms) {
    if (!sun.bends) return; // a plane of zeros has nothing below it
    uniforms.waterPlane = glm::vec4(glm::dvec4(sun.normal, -sun.depthOf(eye)));
    uniforms.waterAcross = scaledAxis(sun.across, sun.middle.x, sun.half.x, eye);
    uniforms.waterAlong = scaledAxis(sun.along, sun.middle.y, sun.half.y, eye);
    uniforms.sunShear = glm::vec4(glm::vec3(sun.shear), static_cast<float>(sun.troughs));
    for (size_t i = 0; i < 2; ++i)
        uniforms.sunStrays[i] = glm::vec4(glm::dvec4(sun.strays[i], glm::length(sun.strays[i])));
}

void moveBentUniforms(const glm::dvec3& step, FrameUniforms& uniforms) {
    for (glm::vec4* const plane : {&uniforms.waterPlane, &uniforms.waterAcross, &uniforms.waterAlong})
        plane->w += static_cast<float>(glm::dot(glm::dvec3(*plane), step));
}

} // namespace demos
