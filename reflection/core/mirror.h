// The plane as a mirror: the Householder reflection, and what it does to a picture of the scene.
//
// A mirrored pixel needs one matrix-vector product. With VP the view-projection, S the viewport transform and
// R the mirror, H = S VP R (S VP)^-1 maps (x, y, depth, 1) of a scene pixel to the pixel and depth where the
// plane shows it. R is its own inverse, so H is too, up to scale: the same matrix leads from a mirrored pixel
// back to its source. Built in double and relative to the eye; a float world-space path is wrong by a pixel
// 100 km from the origin.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "gpu/view/view.h"
#include "seaglass/reflection.h"
#include "shaders/shared/mirror_block.h"

namespace seaglass {

/// The plane as seen from `eye`: relative to it, and facing it (a positive distance at the eye).
glm::dvec4 planeFacingEye(const glm::dvec4& worldPlane, const glm::dvec3& eye);
/// As a view sees it: where lines of sight are parallel, the side that they come from.
glm::dvec4 planeFacing(const glm::dvec4& worldPlane, const ViewGeometry& view);

/// I - 2 n pi^T for a plane with a unit normal.
glm::dmat4 householder(const glm::dvec4& plane);

/// The depth of the farthest mirror image that the view may show. With an infinite far plane, and by
/// perspective, that of the far plane is taken.
double farthestImage(const ViewGeometry& view, const glm::dvec4& plane);

struct ScreenMirror {
    glm::dmat4 pixelFromPixel{1}; ///< H, from a scene's pixel to one of the reflection
    glm::dmat4 sceneFromPixel{1}; ///< and back: the same matrix where the scene's pixels show their middles
    glm::dmat4 relativeFromPixel{1}; ///< from one of the reflection to the mirror image there
    glm::dvec4 heightRow{0}; ///< of a scene's pixel p = (x, y, depth, 1): height is heightRow.p / weightRow.p
    glm::dvec4 weightRow{0};
};

/// `plane` relative to the eye and facing it.
ScreenMirror screenMirror(const ViewGeometry& view, const glm::dvec4& plane);

/// Pixels of the view to one SSPR key, each way.
uint32_t keyScale(const ReflectionDesc& desc);

/// Whether SSPR looks for what hangs over the mirror.
bool looksForOverhangs(const ReflectionDesc& desc);

/// `shown`: the pixels that may show the mirror.
MirrorBlock mirrorBlock(const ViewGeometry& view, const glm::dvec4& worldPlane, const ReflectionDesc& desc,
                        const glm::ivec4& shown);

} // namespace seaglass
