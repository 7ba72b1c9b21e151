#include "reflection/view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "reflection/limits.h"

namespace seaglass {

namespace {

bool allFinite(const glm::dmat4& m) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(m[i / 4][i % 4])) return false;
    return true;
}

/// Depth grows towards the viewer when d(depth)/dz > 0; z/w is a Moebius function of view-space z, so one
/// determinant tells, for perspective, infinite and orthographic matrices alike.
bool depthIsReversed(const glm::dmat4& p) {
    return p[2][2] * p[3][3] - p[3][2] * p[2][3] > 0;
}

const char* badImage(const Image& image, const VkViewport& viewport, const char* nullText,
                     const char* smallText) {
    if (!image.view) return nullText;
    const double right = std::max(viewport.x, viewport.x + viewport.width);
    const double bottom = std::max(viewport.y, viewport.y + viewport.height);
    if (right > image.extent.width || bottom > image.extent.height) return smallText;
    return nullptr;
}

const char* badViewport(const VkViewport& v) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.width) || !std::isfinite(v.height))
        return "ViewDesc.viewport is not finite";
    if (v.width < 1 || std::abs(v.height) < 1) return "ViewDesc.viewport is smaller than one pixel";
    if (v.x < 0 || std::min(v.y, v.y + v.height) < 0)
        return "ViewDesc.viewport begins left of or above the image";
    if (v.minDepth != 0 || v.maxDepth != 1) return "ViewDesc.viewport has a depth range other than 0 to 1";
    return nullptr;
}

/// Viewport transform on homogeneous clip coordinates, relative to the region's corner.
glm::dmat4 pixelFromClip(const VkViewport& v, const glm::ivec2& origin) {
    glm::dmat4 s(1);
    s[0][0] = v.width * 0.5;
    s[1][1] = v.height * 0.5;
    s[3][0] = v.x + v.width * 0.5 - origin.x;
    s[3][1] = v.y + v.height * 0.5 - origin.y;
    return s;
}

} // namespace

glm::dmat4 toMatrix(const double (&values)[16]) {
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = values[i];
    return m;
}

const char* readView(const ViewDesc& view, ViewGeometry& out) {
    if (const char* bad = readCamera(view, out)) return bad;
    if (const char* bad = badImage(view.sceneDepth, view.viewport, "ViewDesc.sceneDepth.view is null",
                                   "ViewDesc.sceneDepth is smaller than the viewport"))
        return bad;
    if (const char* bad = badImage(view.sceneColor, view.viewport, "ViewDesc.sceneColor.view is null",
                                   "ViewDesc.sceneColor is smaller than the viewport"))
        return bad;
    if (!view.surfaceNormals) return nullptr;
    return badImage(*view.surfaceNormals, view.viewport, "ViewDesc.surfaceNormals.view is null",
                    "ViewDesc.surfaceNormals is smaller than the viewport");
}

const char* readCamera(const ViewDesc& view, ViewGeometry& out) {
    const glm::dmat4 viewMatrix = toMatrix(view.view);
    const glm::dmat4 projection = toMatrix(view.projection);
    if (!allFinite(viewMatrix)) return "ViewDesc.view is not finite";
    if (!allFinite(projection)) return "ViewDesc.projection is not finite";
    if (const char* bad = badViewport(view.viewport)) return bad;
    if (view.viewIndex >= maxViews) return "ViewDesc.viewIndex is out of range, expected 0 to 7";

    const glm::dmat4 worldFromView = glm::inverse(viewMatrix);
    if (!allFinite(worldFromView)) return "ViewDesc.view is singular";
    out.eye = glm::dvec3(worldFromView[3]);
    out.forward = -glm::normalize(glm::dvec3(worldFromView[2]));

    glm::dmat4 rotation = viewMatrix;
    rotation[3] = glm::dvec4(0, 0, 0, 1);
    out.clipFromRelative = projection * rotation;
    out.reversedDepth = depthIsReversed(projection);
    out.farDepth = out.reversedDepth ? 0.0 : 1.0;
    // Under an orthographic projection nothing lies at infinity; the far plane stands for it.
    const bool perspective = projection[2][3] != 0;
    out.infinityDepth = perspective ? projection[2][2] / projection[2][3] : out.farDepth;

    const VkViewport& v = view.viewport;
    const double top = std::min(v.y, v.y + v.height);
    out.regionOrigin = {static_cast<int>(std::floor(v.x)), static_cast<int>(std::floor(top))};
    out.regionSize = {static_cast<int>(std::ceil(v.x + v.width)) - out.regionOrigin.x,
                      static_cast<int>(std::ceil(top + std::abs(v.height))) - out.regionOrigin.y};
    out.pixelFromRelative = pixelFromClip(v, out.regionOrigin) * out.clipFromRelative;
    out.relativeFromPixel = glm::inverse(out.pixelFromRelative);
    if (!allFinite(out.relativeFromPixel)) return "ViewDesc.view times ViewDesc.projection is singular";
    return nullptr;
}

} // namespace seaglass
