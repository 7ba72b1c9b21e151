// The settings of fog.h as a table: see rows.h.
#pragma once

#include "gpu/interface/fields/rows.h"
#include "seaglass/fog.h"

namespace seaglass {

inline constexpr Field fogFieldRows[] = {
    field<&FogDesc::shape>("shape", fogShapes, "How it grows with distance.", 1),
    field<&FogDesc::density>("density", 0, 1000, "1/m", "How thick it is; of height at its base.")
        .onlyFor(FogShape::exponential, FogShape::exponentialSquared, FogShape::height),
    field<&FogDesc::start>("start", 0, 1e9, "m", "Where it begins.").onlyFor(FogShape::linear),
    field<&FogDesc::end>("end", 0, 1e9, "m", "Where it hides all.").onlyFor(FogShape::linear),
    field<&FogDesc::falloff>("falloff", 0, 10, "1/m", "How fast it thins out upwards.")
        .onlyFor(FogShape::height),
    field<&FogDesc::baseHeight>("baseHeight", -1e6, 1e6, "m", "Where it has its density.")
        .onlyFor(FogShape::height),
    field<&FogDesc::color>("color", 0, mostFinite, "", "Radiance of endless fog: red, green, blue."),
    field<&FogDesc::fromSky>("fromSky", 0, 1, "", "Share of its colour that is the sky's own instead."),
    field<&FogDesc::most>("most", 0, 1, "", "Share of light that it takes at most."),
    field<&FogDesc::overSky>("overSky", "It lies before the sky, too."),
};
inline constexpr FieldTable fogFields = fieldTable("FogDesc", fogFieldRows);

} // namespace seaglass
