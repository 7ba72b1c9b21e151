#include "reflection/mirror.h"

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

} // namespace

const char* readPlane(const double (&plane)[4], glm::dvec4& out) {
    for (const double value : plane)
        if (!std::isfinite(value)) return "plane is not finite";
    const glm::dvec4 p(plane[0], plane[1], plane[2], plane[3]);
    const double length = glm::length(glm::dvec3(p));
    if (!(length > 1e-12)) return "plane has no normal: its first three numbers are zero";
    out = p / length;
    return nullptr;
}

glm::dvec4 planeFacingEye(const glm::dvec4& worldPlane, const glm::dvec3& eye) {
    const glm::dvec3 normal(worldPlane);
    const double height = glm::dot(normal, eye) + worldPlane.w;
    return height < 0 ? glm::dvec4(-normal, -height) : glm::dvec4(normal, height);
}

glm::dmat4 householder(const glm::dvec4& plane) {
    const glm::dvec4 normal(glm::dvec3(plane), 0);
    return glm::dmat4(1) - 2.0 * glm::outerProduct(normal, plane);
}

uint32_t keyScale(const ReflectionDesc& desc) {
    return std::max(desc.downscale, desc.coarseKeys ? 2u : 1u);
}

ScreenMirror screenMirror(const ViewGeometry& view, const glm::dvec4& plane) {
    ScreenMirror mirror;
    const glm::dmat4 relativeFromScene = relativeFromScenePixel(view);
    mirror.pixelFromPixel = view.pixelFromRelative * householder(plane) * relativeFromScene;
    mirror.sceneFromPixel = scenePixelFromRelative(view) * householder(plane) * view.relativeFromPixel;
    mirror.heightRow = plane * relativeFromScene;
    mirror.weightRow = row(relativeFromScene, 3);
    return mirror;
}

MirrorUniforms mirrorUniforms(const ViewGeometry& view, const glm::dvec4& worldPlane,
                              const ReflectionDesc& desc, const Bounds& bounds) {
    const glm::dvec4 plane = planeFacingEye(worldPlane, view.eye);
    const ScreenMirror mirror = screenMirror(view, plane);
    MirrorUniforms out;
    out.screenMirror = glm::mat4(mirror.pixelFromPixel);
    out.sceneFromPixel = glm::mat4(mirror.sceneFromPixel);
    out.relativeFromPixel = glm::mat4(view.relativeFromPixel);
    out.heightRow = glm::vec4(mirror.heightRow);
    out.weightRow = glm::vec4(mirror.weightRow);
    out.depthRow =
        glm::vec4(row(mirror.sceneFromPixel, 2) - view.infinityDepth * row(mirror.sceneFromPixel, 3));
    out.plane = glm::vec4(plane);
    out.region = glm::ivec4(view.regionOrigin, view.regionSize);
    // Lookups that are bent stray from where the mirror shows.
    out.shown = desc.distortion > 0 ? glm::ivec4(0, 0, view.regionSize) : pixelsThatMayShow(bounds, view);
    out.farDepth = static_cast<float>(view.farDepth);
    out.infinityDepth = static_cast<float>(view.infinityDepth);
    out.depthSign = view.reversedDepth ? 1.0f : -1.0f;
    out.edgeFadePixels = desc.edgeFade * static_cast<float>(view.regionSize.y);
    out.bent = desc.distortion > 0 ? 1 : 0;
    out.pixelShift = std::countr_zero(desc.downscale);
    out.keyShift = std::countr_zero(keyScale(desc));
    out.contactPerMetre = static_cast<float>(contactPerMetre(mirror, view.depthStep));
    out.depthStep = static_cast<float>(view.depthStep);
    out.followed = desc.technique == ReflectionTechnique::hybrid ? 1 : 0;
    return out;
}

} // namespace seaglass
