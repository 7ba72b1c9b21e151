#include "gpu/view/view.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "gpu/interface/fields/host.h"
#include "gpu/view/encoding.h"
#include "gpu/view/limits.h"
#include "gpu/view/scene_formats.h"

namespace seaglass {

namespace {

/// Columns that lie in one plane to within rounding, whatever their lengths: near planes make some very
/// short.
template<typename Matrix>
bool isSingular(const Matrix& m) {
    double lengths = 1;
    for (int i = 0; i < Matrix::length(); ++i) lengths *= glm::length(m[i]);
    return !(std::abs(glm::determinant(m)) > 1e-12 * lengths);
}

/// Which way along the view's z the camera looks: where w grows. Parallel lines do not tell.
double aheadAlongZ(const glm::dmat4& p) {
    return p[2][3] > 0 ? 1 : -1;
}

/// Depth falls ahead; z/w is a Moebius function of view-space z, so one determinant tells, for perspective,
/// infinite and orthographic matrices alike.
bool depthIsReversed(const glm::dmat4& p) {
    return aheadAlongZ(p) * (p[2][2] * p[3][3] - p[3][2] * p[2][3]) < 0;
}

const char* badViewMatrix(const glm::dmat4& m) {
    if (!allFinite(m)) return "ViewDesc.view is not finite";
    if (isSingular(glm::dmat3(m))) return "ViewDesc.view is singular";
    // To within what an inverse in float leaves there.
    if (glm::distance(glm::row(m, 3), glm::dvec4(0, 0, 0, 1)) > 1e-4)
        return "ViewDesc.view has a last row other than 0, 0, 0, 1, expected it column-major";
    constexpr double drift = 0.01; // of what is turned again and again in float
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 axis(m[i]), next(m[(i + 1) % 3]);
        if (!(std::abs(glm::length(axis) - 1) < drift))
            return "ViewDesc.view scales, expected 1: for units other than metres see seaglass/world.h";
        if (!(std::abs(glm::dot(axis, next)) < drift))
            return "ViewDesc.view shears, expected it to turn and move alone";
    }
    return nullptr;
}

bool parallelLines(const glm::dmat4& p) {
    return p[0][3] == 0 && p[1][3] == 0 && p[2][3] == 0;
}

const char* badProjection(const glm::dmat4& p) {
    if (!allFinite(p)) return "ViewDesc.projection is not finite";
    if (isSingular(p)) return "ViewDesc.projection is singular";
    if (parallelLines(p)) return nullptr;
    // Where x, y and w are nothing, lines of sight meet: in the eye, or beside it as some have two eyes' lie.
    constexpr double farthest = 0.5; // [m]
    const glm::dmat4 rows = glm::transpose(p);
    const glm::dmat3 linear = glm::transpose(glm::dmat3(rows[0], rows[1], rows[3]));
    const glm::dvec3 centre = -glm::inverse(linear) * glm::dvec3(p[3].x, p[3].y, p[3].w);
    if (!(glm::length(centre) < farthest))
        return "ViewDesc.projection has its centre beside the eye, expected view to clip, of last row 0, 0, "
               "-1, 0 or the like: is it times the view?";
    return nullptr;
}

static_assert(viewFieldRows[0].high == maxViews - 1);

/// What is demanded of one of a view's images.
struct ImageRules {
    const char* name;
    bool (*holds)(VkFormat);
    const char* isOfOtherFormat; ///< said behind the format's name
};

constexpr ImageRules depthRules = {"ViewDesc.sceneDepth", holdsDepth, holdsNoDepth};

constexpr ImageRules colorRules = {
    "ViewDesc.sceneColor", holdsColor,
    " holds no colour that can be read, expected R16G16B16A16_SFLOAT, R32G32B32A32_SFLOAT, "
    "B10G11R11_UFLOAT_PACK32, or 8-bit RGBA, BGRA or ABGR, UNORM or SRGB"};

constexpr ImageRules normalsRules = {
    "ViewDesc.surfaceNormals", holdsNormals,
    " holds no normals that can be read, expected R16G16B16A16_SFLOAT, R32G32B32A32_SFLOAT or "
    "R8G8B8A8_SNORM"};

FieldError badImage(const Image& image, const VkViewport& viewport, const ImageRules& rules) {
    FieldError line(rules.name);
    if (!image.view) return line.add(".view is null");
    if (!rules.holds(image.format)) return line.add(".format").add(rules.isOfOtherFormat);
    if (!sampledIn(image.layout, rules.holds == holdsDepth))
        return line.add(".layout is none to sample from, expected GENERAL or one that is read-only");
    if (const FieldError bad = badField(imageFields, &image, rules.name, isOf<&Image::samples>)) return bad;
    const double right = std::max(viewport.x, viewport.x + viewport.width);
    const double bottom = std::max(viewport.y, viewport.y + viewport.height);
    if (right > image.extent.width || bottom > image.extent.height)
        return line.add(" is smaller than the viewport");
    return {};
}

const char* badViewport(const VkViewport& v) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.width) || !std::isfinite(v.height))
        return "ViewDesc.viewport is not finite";
    if (v.width < 1 || std::abs(v.height) < 1) return "ViewDesc.viewport is smaller than one pixel";
    if (v.x < 0 || std::min(v.y, v.y + v.height) < 0)
        return "ViewDesc.viewport begins left of or above the image";
    constexpr float farthest = 1 << 24; // where floats tell pixels apart
    if (v.x + v.width > farthest || std::max(v.y, v.y + v.height) > farthest)
        return "ViewDesc.viewport ends beyond 2^24 pixels";
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

glm::dmat4 scenePixelFromRelative(const ViewGeometry& view) {
    return glm::translate(glm::dmat4(1), glm::dvec3(view.sceneShift, 0)) * view.pixelFromRelative;
}

glm::dmat4 relativeFromScenePixel(const ViewGeometry& view) {
    return view.relativeFromPixel * glm::translate(glm::dmat4(1), glm::dvec3(-view.sceneShift, 0));
}

glm::dmat4 toMatrix(const double (&values)[16]) {
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = values[i];
    return m;
}

void toValues(const glm::dmat4& m, double (&values)[16]) {
    for (int i = 0; i < 16; ++i) values[i] = m[i / 4][i % 4];
}

bool allFinite(const glm::dmat4& m) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(m[i / 4][i % 4])) return false;
    return true;
}

FieldError readView(const ViewDesc& view, ViewGeometry& out) {
    if (const FieldError bad = readCamera(view, out)) return bad;
    if (const FieldError bad = badImage(view.sceneDepth, view.viewport, depthRules)) return bad;
    if (const FieldError bad = badImage(view.sceneColor, view.viewport, colorRules)) return bad;
    if (isEncoded(view.sceneColor) && appliesSrgb(view.sceneColor.format))
        return "ViewDesc.sceneColor.encoding is srgb, which ViewDesc.sceneColor.format applies by itself";
    const VkSampleCountFlagBits samples = view.sceneColor.samples;
    if (samples != VK_SAMPLE_COUNT_1_BIT && samples != view.sceneDepth.samples)
        return "ViewDesc.sceneColor.samples is neither 1 nor that of ViewDesc.sceneDepth";
    if (view.surfaceNormals && view.surfaceNormals->samples != VK_SAMPLE_COUNT_1_BIT)
        return "ViewDesc.surfaceNormals.samples is not 1";
    if (view.surfaceNormals)
        if (const FieldError bad = badImage(*view.surfaceNormals, view.viewport, normalsRules)) return bad;
    out.sceneShift = glm::dvec2(0.5) - samplePlace(view.sceneDepth.samples);
    out.depthStep = depthStep(view.sceneDepth.format, out.reversedDepth);
    return {};
}

FieldError readCamera(const ViewDesc& view, ViewGeometry& out) {
    const glm::dmat4 viewMatrix = toMatrix(view.view);
    const glm::dmat4 projection = toMatrix(view.projection);
    if (const char* bad = badViewMatrix(viewMatrix)) return bad;
    if (const char* bad = badProjection(projection)) return bad;
    if (const char* bad = badViewport(view.viewport)) return bad;
    if (const FieldError bad = badField(viewFields, &view)) return bad;
    if (const FieldError bad =
            badField(imageFields, &view.sceneColor, colorRules.name, isOf<&Image::encoding>))
        return bad;
    out.jitter = {view.jitter[0], view.jitter[1]};

    const glm::dmat4 worldFromView = glm::inverse(viewMatrix);
    if (!allFinite(worldFromView)) return "ViewDesc.view is singular";
    out.eye = glm::dvec3(worldFromView[3]);
    out.forward = aheadAlongZ(projection) * glm::normalize(glm::dvec3(worldFromView[2]));

    glm::dmat4 rotation = viewMatrix;
    rotation[3] = glm::dvec4(0, 0, 0, 1);
    out.clipFromRelative = projection * rotation;
    out.reversedDepth = depthIsReversed(projection);
    out.farDepth = out.reversedDepth ? 0.0 : 1.0;
    out.parallel = parallelLines(projection);
    out.infinityDepth = out.parallel ? out.farDepth : projection[2][2] / projection[2][3];

    const VkViewport& v = view.viewport;
    const double top = std::min(v.y, v.y + v.height);
    out.regionOrigin = {static_cast<int>(std::floor(v.x)), static_cast<int>(std::floor(top))};
    out.regionSize = {static_cast<int>(std::ceil(v.x + v.width)) - out.regionOrigin.x,
                      static_cast<int>(std::ceil(top + std::abs(v.height))) - out.regionOrigin.y};
    out.pixelFromRelative = pixelFromClip(v, out.regionOrigin) * out.clipFromRelative;
    out.relativeFromPixel = glm::inverse(out.pixelFromRelative);
    if (!allFinite(out.relativeFromPixel)) return "ViewDesc.view times ViewDesc.projection is singular";
    const double ahead = out.reversedDepth ? -1 : 1;
    out.sight = ahead * glm::normalize(glm::dvec3(out.relativeFromPixel[2]));
    return {};
}

} // namespace seaglass
