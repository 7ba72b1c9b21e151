// The surface's mesh: a quadtree of equal grid patches around the eye (Strugar 2009, "Continuous
// Distance-Dependent Level of Detail"). Patches lie on a lattice fixed in the plane, so nothing swims;
// vertices glide onto the next coarser lattice before it takes over, so nothing pops and no crack opens.
// Seen by parallel lines of sight all patches are of one level, and glide as the view widens.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "water/body/parallel_view.h"
#include "water/mesh/extent.h"
#include "water/mesh/globe.h"
#include "water/waves/wave_detail.h"

namespace seaglass {

struct MeshPatch;

constexpr uint32_t patchCells = 16; ///< across a patch, at the most; the shader's patchCells
constexpr uint32_t fewestCells = 2; ///< of which every other vertex still glides
constexpr uint32_t fewestInRange =
    128;                             ///< cells until the next level takes over; see glideBegins of the shader
constexpr double nearestCell = 0.01; ///< [m]: waves that are shorter than two of these are ripples

/// What a view's patches lie on. A vertex is so many cells from one point for all patches that share it, so
/// it has the same bits in each: no pixel falls between them.
struct MeshLattice {
    double cell;       ///< edge of the finest cells that patches may have [m]
    glm::dvec2 origin; ///< one of its points, relative to the eye [m]

    /// Relative to the eye [m].
    glm::dvec2 cornerOf(const MeshPatch& patch) const;
};

/// One patch as the vertex shader reads it.
struct MeshPatch {
    int32_t corner[2]; ///< lowest (u, v), from the lattice's origin [cells of the lattice]
    float cell;        ///< edge of a cell [m]
    float range;       ///< distance within which this level is used [m]; negative: the sea ends with it
};

/// One patch of a body with an outline.
struct OutlinedPatch {
    MeshPatch patch;
    uint32_t firstEdge; ///< of those that decide what of the patch lies within
    uint32_t edgeCount; ///< 0: all of it
};

/// What is to be drawn of a body with an outline.
struct OutlinedPatches {
    std::vector<OutlinedPatch> patches;
    std::vector<glm::vec4> edges; ///< (u, v) of both ends, relative to the eye [m]
};

struct MeshView {
    glm::dvec2 eye{0};    ///< (u, v) [m]
    double eyeHeight = 0; ///< above the calm surface [m]
    std::array<glm::dvec4, 5>
        frustum{};           ///< planes facing inwards over (u, height, v) relative to the eye's foot
    double displacement = 0; ///< the most that waves move a vertex in any axis [m]
    Globe globe;             ///< that a sea without an outline lies on
    bool farthestFirst = false;
    const WaveDetail* waves = nullptr; ///< null: patches have all their cells
    double pixel = 0;                  ///< from one pixel to the next [rad], as far away as `parallel` says
    std::optional<ParallelLines> parallel; ///< none: lines of sight come from the eye
};

/// Inward planes (left, right, bottom, top, near) of a clip matrix over its input space.
std::array<glm::dvec4, 5> frustumPlanes(const glm::dmat4& clip, bool reversedDepth);

/// Whether a view may see something of what lies in a box relative to its eye.
bool inSight(const MeshView& view, const OutlineBox& box);

/// Edge of the cells that waves get where they touch the eye [m]. What is nearer than 64 finest cells is
/// meshed finer than those, in levels as short as may be, so that the water's line across a lens has its
/// waves.
double cellNearEye(double displacement, double finestCell);

MeshLattice meshLattice(const MeshView& view, double finestCell, double rangeInCells);

/// Patches from fine to coarse, or from far to near, out to the horizon; those out of sight left out. Returns
/// how many cells are across each: no more than it takes to leave out of the waves 0.31 of a pixel.
uint32_t selectPatches(const MeshView& view, double finestCell, double rangeInCells,
                       std::vector<MeshPatch>& out);

/// Patches that touch what an outline encloses, likewise. Each that comes within `pinned` metres of an edge
/// has a list of edges: a point of the patch lies within where an odd number of them crosses the ray from it
/// towards -u, and no other edge is nearer than `pinned`.
uint32_t selectPatches(const MeshView& view, double finestCell, double rangeInCells, const Outline& outline,
                       double pinned, OutlinedPatches& out);

/// Two triangles a cell over the first of (patchCells + 1)^2 vertices, row by row: for patches of fewestCells
/// cells across, then twice as many, up to patchCells.
std::vector<uint16_t> patchIndices();
/// The first of those for so many cells.
constexpr uint32_t firstPatchIndex(uint32_t cells) {
    return 2 * (cells * cells - fewestCells * fewestCells);
}

} // namespace seaglass
