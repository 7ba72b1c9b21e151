// The settings of host.h as tables: see rows.h.
#pragma once

#include "gpu/interface/fields/rows.h"
#include "seaglass/host.h"

namespace seaglass {

inline constexpr Field deviceFieldRows[] = {
    field<&DeviceDesc::framesInFlight>("framesInFlight", 1, 4, "",
                                       "Frame slots that may be pending at once."),
};
inline constexpr FieldTable deviceFields = fieldTable("DeviceDesc", deviceFieldRows);

inline constexpr Field imageFieldRows[] = {
    field<&Image::samples>("samples", 1, 16, "", "Of each pixel.").powersOfTwo(),
    field<&Image::encoding>("encoding", encodings, "How colour is held."),
};
inline constexpr FieldTable imageFields = fieldTable("Image", imageFieldRows);

inline constexpr Field viewFieldRows[] = {
    field<&ViewDesc::viewIndex>("viewIndex", 0, 7, "", "Which view of the frame it is."),
    field<&ViewDesc::jitter>("jitter", -16, 16, "pixel", "How far the picture is moved, right and down."),
    field<&ViewDesc::cut>("cut", "The last frame tells nothing of this one."),
};
/// Of ViewDesc, but its matrices.
inline constexpr FieldTable viewFields = fieldTable("ViewDesc", viewFieldRows);

inline constexpr Field sunShadowFieldRows[] = {
    field<&SunShadow::cascadeCount>("cascadeCount", 1, 4, "", "Finest first."),
    field<&SunShadow::reversedDepth>("reversedDepth", "What is nearer to the sun is greater."),
};
/// Of SunShadow, but what each cascade has.
inline constexpr FieldTable sunShadowFields = fieldTable("SunShadow", sunShadowFieldRows);

inline constexpr Field lightingFieldRows[] = {
    field<&LightingDesc::sunIrradiance>("sunIrradiance", 0, mostFinite, "", "On a plane facing the sun."),
    field<&LightingDesc::skyIrradiance>("skyIrradiance", 0, mostFinite, "",
                                        "On the water's plane, without the sun."),
    field<&LightingDesc::skyCubeMipLevels>("skyCubeMipLevels", 1, 16, "", "Of the sky's cube."),
    field<&LightingDesc::skyZenith>("skyZenith", 0, mostFinite, "", "Without a cube: radiance straight up."),
    field<&LightingDesc::skyHorizon>("skyHorizon", 0, mostFinite, "", "Without a cube: at the horizon."),
    field<&LightingDesc::skyGround>("skyGround", 0, mostFinite, "", "Without a cube: straight down."),
};
/// Of LightingDesc, but `toSun`, which is a unit vector.
inline constexpr FieldTable lightingFields = fieldTable("LightingDesc", lightingFieldRows);

} // namespace seaglass
