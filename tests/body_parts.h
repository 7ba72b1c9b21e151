// A body's description and all that it may point to, for tests that take parts in and leave them out.
#pragma once

#include <array>

#include "seaglass/water.h"

namespace tests {

/// As new: a still body of no parts.
struct BodyParts {
    BodyParts() = default;
    // The description points to its neighbours.
    BodyParts(const BodyParts&) = delete;
    BodyParts& operator=(const BodyParts&) = delete;

    /// But the shore's bed, over which nothing is shaded at its own height.
    void addAll() {
        desc.waves = &sea;
        desc.foam = &foam;
        desc.refraction = &refraction;
        desc.reflection = &reflection;
        desc.underwater = &underwater;
        desc.caustics = &caustics;
        desc.spray = &spray;
        desc.bed = &bed;
    }
    /// A slope of 1 in 20 that meets the calm plane 16 m from the middle of its 128 m.
    void addShore() {
        for (size_t i = 0; i < heights.size(); ++i) heights[i] = -4 + 0.4f * static_cast<float>(i % 16);
        shore.bed = heights.data();
        shore.samples[0] = shore.samples[1] = 16;
        shore.spacing = 8;
        shore.origin[0] = shore.origin[1] = -64;
        sea.shore = &shore;
    }

    seaglass::SeaDesc sea;
    seaglass::FoamDesc foam;
    seaglass::RefractionDesc refraction;
    seaglass::ReflectionDesc reflection;
    seaglass::UnderwaterDesc underwater;
    seaglass::CausticsDesc caustics;
    seaglass::SprayDesc spray;
    seaglass::BedDesc bed;
    seaglass::ShoreDesc shore;
    std::array<float, 256> heights{};
    seaglass::BodyDesc desc;
};

} // namespace tests
