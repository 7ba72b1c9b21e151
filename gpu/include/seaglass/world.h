// For hosts whose world is not right-handed with +Y up, in metres: turns what they say, and back. Any thread.
// A turned view shows the same picture: clip space, viewport and images stay.
#pragma once

#include "seaglass/host.h"

namespace seaglass {

/// Of the host's own axes the one that points up.
enum class WorldUp : uint32_t { y = 0, minusY, z };

/// How the host has its world; its x is Seaglass's.
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
    bool sightAlongZ = false; ///< views look along +z, as left-handed ones and those with y down do; else -z
};

/// The host's direction, point or plane (n.p + d = 0 in both) as Seaglass has it.
/// @{
void directionFrom(const World& world, const double (&host)[3], double (&out)[3]);
void pointFrom(const World& world, const double (&host)[3], double (&out)[3]);
void planeFrom(const World& world, const double (&host)[4], double (&out)[4]);
/// @}

/// Turns a view that is filled in as the host has it.
void worldFrom(const World& world, ViewDesc* view);
/// Turns the sun's direction, and `shadow`, which `lighting->shadow` may point at; null: none.
void worldFrom(const World& world, LightingDesc* lighting, SunShadow* shadow = nullptr);

/// The host's point of Seaglass's.
void pointTo(const World& world, const double (&point)[3], double (&host)[3]);
/// The matrices of planarView() or bedView(), of a turned view, that take the host's points.
void worldTo(const World& world, const double (&turnedView)[16], const double (&turnedProjection)[16],
             double (&view)[16], double (&projection)[16]);

} // namespace seaglass
