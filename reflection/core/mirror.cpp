#include "reflection/core/mirror.h"

#include "reflection/core/technique.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace seaglass {

namespace {

/// Of what lies on the plane, the share that grows with the distance: 20 micrometres a metre, and what the
/// depth's format cannot tell apart. Height is affine in depth before it is divided by the weight.
double contactPerMetre(const ScreenMirror& mirror, double depthStep) {
    return 2e-5 + depthStep * std::abs(mirror.heightRow.z);
}

/// Mirror images lie behind the mirror, and so may be farther than the far plane. Where nothing is at
/// infinity that is common: their depths are those of the scene, moved and scaled until all lie between 0
/// and 1.
glm::dmat4 imageDepth(const ViewGeometry& view, const glm::dvec4& plane) {
    const double farthest = farthestImage(view, plane);
    glm::dmat4 depth(1);
    depth[2][2] = 1 / (view.reversedDepth ? 1 - farthest : std::max(farthest, 1.0));
    depth[3][2] = view.reversedDepth ? -farthest * depth[2][2] : 0;
    return depth;
}

/// From a pixel (x, y, 1) to where the far end of its mirrored ray shows: its vanishing point or, of parallel
/// views, where it leaves through the far plane. w <= 0: nowhere.
glm::dmat3x4 skyFromPixel(const ViewGeometry& view, const glm::dmat4& sceneFromPixel) {
    const glm::dmat4& m = sceneFromPixel;
    if (!view.parallel) return {m[0], m[1], m[2] * view.infinityDepth + m[3]};
    // It comes back to where the view comes from.
    if (!(m[2].z > 1e-9)) return glm::dmat3x4(0);
    const glm::dvec4 perDepth = m[2] / m[2].z;
    return {m[0] - perDepth * m[0].z, m[1] - perDepth * m[1].z, m[3] + perDepth * (view.farDepth - m[3].z)};
}

} // namespace

glm::dvec4 planeFacingEye(const glm::dvec4& worldPlane, const glm::dvec3& eye) {
    const glm::dvec3 normal(worldPlane);
    const double height = glm::dot(normal, eye) + worldPlane.w;
    return height < 0 ? glm::dvec4(-normal, -height) : glm::dvec4(normal, height);
}

glm::dvec4 planeFacing(const glm::dvec4& worldPlane, const ViewGeometry& view) {
    const glm::dvec3 normal(worldPlane);
    const glm::dvec4 plane(normal, glm::dot(normal, view.eye) + worldPlane.w);
    if (!view.parallel) return planeFacingEye(worldPlane, view.eye);
    return glm::dot(normal, view.sight) > 0 ? -plane : plane;
}

glm::dmat4 householder(const glm::dvec4& plane) {
    const glm::dvec4 normal(glm::dvec3(plane), 0);
    return glm::dmat4(1) - 2.0 * glm::outerProduct(normal, plane);
}

uint32_t keyScale(const ReflectionDesc& desc) {
    return std::max(desc.downscale, desc.coarseKeys ? 2u : 1u);
}

bool looksForOverhangs(const ReflectionDesc& desc) {
    return desc.overhangSamples > 0;
}

double farthestImage(const ViewGeometry& view, const glm::dvec4& plane) {
    double farthest = view.farDepth;
    if (!view.parallel) return farthest;
    const glm::dmat4 mirror = view.pixelFromRelative * householder(plane) * view.relativeFromPixel;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 corner(i & 1 ? view.regionSize.x : 0, i & 2 ? view.regionSize.y : 0, i & 4 ? 1 : 0,
                                1);
        const double depth = (mirror * corner).z;
        farthest = view.reversedDepth ? std::min(farthest, depth) : std::max(farthest, depth);
    }
    return farthest;
}

ScreenMirror screenMirror(const ViewGeometry& view, const glm::dvec4& plane) {
    ScreenMirror mirror;
    const glm::dmat4 relativeFromScene = relativeFromScenePixel(view);
    const glm::dmat4 depth = imageDepth(view, plane);
    mirror.relativeFromPixel = view.relativeFromPixel * glm::inverse(depth);
    mirror.pixelFromPixel = depth * view.pixelFromRelative * householder(plane) * relativeFromScene;
    mirror.sceneFromPixel = scenePixelFromRelative(view) * householder(plane) * mirror.relativeFromPixel;
    mirror.heightRow = plane * relativeFromScene;
    mirror.weightRow = row(relativeFromScene, 3);
    return mirror;
}

MirrorBlock mirrorBlock(const ViewGeometry& view, const glm::dvec4& worldPlane, const ReflectionDesc& desc,
                        const glm::ivec4& shown) {
    const glm::dvec4 plane = planeFacing(worldPlane, view);
    const ScreenMirror mirror = screenMirror(view, plane);
    MirrorBlock out{};
    out.screenMirror = glm::mat4(mirror.pixelFromPixel);
    out.sceneFromPixel = glm::mat4(mirror.sceneFromPixel);
    out.relativeFromPixel = glm::mat4(mirror.relativeFromPixel);
    out.skyFromPixel = glm::mat3x4(skyFromPixel(view, mirror.sceneFromPixel));
    out.heightRow = glm::vec4(mirror.heightRow);
    out.weightRow = glm::vec4(mirror.weightRow);
    out.depthRow =
        glm::vec4(row(mirror.sceneFromPixel, 2) - view.infinityDepth * row(mirror.sceneFromPixel, 3));
    out.plane = glm::vec4(plane);
    out.region = glm::ivec4(view.regionOrigin, view.regionSize);
    // Lookups that are bent stray from where the mirror shows.
    out.shown = desc.distortion > 0 ? glm::ivec4(0, 0, view.regionSize) : shown;
    out.farDepth = static_cast<float>(view.farDepth);
    out.infinityDepth = static_cast<float>(view.infinityDepth);
    out.depthSign = view.reversedDepth ? 1.0f : -1.0f;
    out.edgeFadePixels = desc.edgeFade * static_cast<float>(view.regionSize.y);
    out.edgeFadeApart = desc.edgeFadeAround ? 0 : 1e9f;
    out.bent = desc.distortion > 0 ? 1 : 0;
    out.pixelShift = std::countr_zero(desc.downscale);
    out.keyShift = std::countr_zero(keyScale(desc));
    out.contactPerMetre = static_cast<float>(contactPerMetre(mirror, view.depthStep));
    out.depthStep = static_cast<float>(view.depthStep);
    out.undersideLight = desc.undersideLight;
    out.overhangSamples = desc.overhangSamples;
    out.followed = techniqueOf(desc.technique).followsRays ? 1 : 0;
    return out;
}

} // namespace seaglass
