// The waves of a body: the maps of its sea.
#pragma once

#include "water/body/part.h"
#include "water/waves/waves.h"

namespace seaglass {

/// Who computes a body's waves on the CPU; null: compute shaders do.
const WavesBackend* chosenBackend(const gpu::Device& device, const BodyDesc& desc);

struct WavesPart {
    Waves waves;

    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc&, const Sea* sea) { return sea; }
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& desc);
    Status simulate(Body& body, VkCommandBuffer commands, double time);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const;
    Status bind(Body& body, const BodyView& view, Resources& out);
};

} // namespace seaglass
