// What a host's matrices say: where the eye is, which way depth runs, how pixels map to space. All in double
// and relative to the eye, so that nothing depends on how far from the origin the camera stands.
#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/fields.h"
#include "seaglass/host.h"

namespace seaglass {

struct ViewGeometry {
    glm::dvec3 eye{0};              ///< world
    glm::dmat4 clipFromRelative{1}; ///< relative to the eye, in world axes
    glm::dmat4 pixelFromRelative{
        1}; ///< homogeneous (x, y, depth, w), pixels counted from the region's corner
    glm::dmat4 relativeFromPixel{1};
    glm::dvec3 forward{0}; ///< unit, world
    glm::dvec3 sight{0};   ///< unit, world: the lines of sight's, where those are parallel
    bool reversedDepth = false;
    double farDepth = 1;      ///< depth value of the far plane, infinite or not
    double infinityDepth = 1; ///< depth value of points at infinity, a little past a finite far plane
    bool parallel = false;    ///< lines of sight: nothing lies at infinity, and the far plane stands for it
    /// From a point's pixel to that of the scene which shows it: a multisampled pixel is sampled off its
    /// middle.
    glm::dvec2 sceneShift{0};
    double depthStep = 0;       ///< scene depths closer than this may be held as one
    glm::ivec2 regionOrigin{0}; ///< the viewport's top left corner in the scene images
    glm::ivec2 regionSize{0};
    glm::dvec2 jitter{0}; ///< by which the picture is moved [pixel]
};

/// Of the region [pixel].
inline VkExtent2D extentOf(const ViewGeometry& view) {
    return {static_cast<uint32_t>(view.regionSize.x), static_cast<uint32_t>(view.regionSize.y)};
}

inline glm::dvec4 row(const glm::dmat4& m, int index) {
    return {m[0][index], m[1][index], m[2][index], m[3][index]};
}

/// Whether either of the scene's images is there: then both must be.
inline bool hasScene(const ViewDesc& view) {
    return view.sceneColor.view || view.sceneDepth.view;
}

/// What is wrong with `view`, if anything. Fills `out`.
FieldError readView(const ViewDesc& view, ViewGeometry& out);

/// The same for a view whose scene images are not read.
FieldError readCamera(const ViewDesc& view, ViewGeometry& out);

/// To and from pixels of the scene: as their namesakes in ViewGeometry, moved by its sceneShift.
glm::dmat4 scenePixelFromRelative(const ViewGeometry& view);
glm::dmat4 relativeFromScenePixel(const ViewGeometry& view);

glm::dmat4 toMatrix(const double (&values)[16]);
void toValues(const glm::dmat4& m, double (&values)[16]);
bool allFinite(const glm::dmat4& m);

} // namespace seaglass
