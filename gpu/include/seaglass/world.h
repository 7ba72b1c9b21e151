// Hosts whose world is not right-handed with +Y up, in metres: turns what they say into Seaglass's, and back.
// Apart: no other header includes it. Any thread.
//
// A view is turned so that it shows the same picture: clip space, viewport and images stay the host's. Which
// way y runs there, by the projection or by a viewport of negative height, is no matter of this.
#pragma once

#include "seaglass/host.h"

namespace seaglass {

/// Of the host's own axes the one that points up.
enum class WorldUp : uint32_t { y = 0, minusY, z };

/// How the host has its world. Any of its x is Seaglass's.
///
/// | host | here |
/// |---|---|
/// | y up, right-handed | (x, y, z) |
/// | y up, left-handed | (x, y, -z) |
/// | y down, right-handed | (x, -y, -z) |
/// | y down, left-handed | (x, -y, z) |
/// | z up, right-handed | (x, z, -y) |
/// | z up, left-handed | (x, z, y) |
struct World {
    WorldUp up = WorldUp::y;  ///< the table's first half
    bool leftHanded = false;  ///< likewise
    double unitsPerMetre = 1; ///< 100 in centimetres; greater than 0
    /// The camera looks along its view's +z, as by left-handed view matrices and such with y down; else along
    /// its -z.
    bool sightAlongZ = false;
};

/// Seaglass's direction of the host's.
void directionFrom(const World& world, const double (&host)[3], double (&out)[3]);

/// Seaglass's point of the host's.
void pointFrom(const World& world, const double (&host)[3], double (&out)[3]);

/// Seaglass's plane of the host's, n.p + d = 0 in both: BodyDesc::plane, ExclusionVolume::planes.
void planeFrom(const World& world, const double (&host)[4], double (&out)[4]);

/// A matrix that takes the host's points, to one that takes Seaglass's.
void matrixFrom(const World& world, const double (&host)[16], double (&out)[16]);

/// A projection of lengths `scale` times as long: w stays the distance ahead, or 1 by parallel lines of
/// sight.
void scaleProjection(double (&projection)[16], double scale);

/// Turns a view that is filled in as the host has it.
void worldFrom(const World& world, ViewDesc* view);

/// Turns the sun's direction and, where there is one, `shadow`, which `lighting->shadow` may point at.
void worldFrom(const World& world, LightingDesc* lighting, SunShadow* shadow = nullptr);

/// The other way: the host's point of Seaglass's.
void pointTo(const World& world, const double (&point)[3], double (&host)[3]);

/// The matrices of planarView() or bedView(), of a view that was turned, as the host draws by them: `view`
/// takes its world's points, `projection` follows it.
void worldTo(const World& world, const double (&turnedView)[16], const double (&turnedProjection)[16],
             double (&view)[16], double (&projection)[16]);

} // namespace seaglass
