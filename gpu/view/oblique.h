// The oblique near plane: a projection whose near plane is the mirror, so that a mirrored view holds nothing
// of what lies behind the mirror. After E. Lengyel, "Oblique View Frustum Depth Projection and Clipping",
// Journal of Game Development 1(2), 2005, written for depth 0..1 that runs either way, with a finite far
// plane or none.
//
// With C the plane as a row that is positive on the kept side and w the projection's fourth row, the third
// row becomes a C where depth grows away from the eye (near: z = 0) and w - a C where it grows towards it
// (near: z = w). Over clip space C/w is linear, so it is greatest in a corner of the far end; a gives that
// corner the far plane's depth, and all that was seen before the far plane stays within range.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace seaglass {

struct ObliqueProjection {
    glm::dmat4 projection{1};
    bool oblique = false; ///< false: the projection as it was
};

/// `plane` in view space, positive where things are kept; any scale. The projection stays as it was where the
/// plane cannot serve as a near plane: the eye lies so close to it that depth would keep less than a 64th of
/// its resolution, or nothing before the far plane lies on its kept side. `farthest` is the depth, as the
/// projection has it, of what is to be drawn still: the far plane's or beyond.
ObliqueProjection obliqueProjection(const glm::dmat4& projection, bool reversedDepth, const glm::dvec4& plane,
                                    double farthest);
/// As far as the far plane.
inline ObliqueProjection obliqueProjection(const glm::dmat4& projection, bool reversedDepth,
                                           const glm::dvec4& plane) {
    return obliqueProjection(projection, reversedDepth, plane, reversedDepth ? 0 : 1);
}

} // namespace seaglass
