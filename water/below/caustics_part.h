// The caustics that a body's waves cast on what lies below: castCaustics() and drawCaustics().
#pragma once

#include "water/below/caustics.h"
#include "water/body/part.h"

namespace seaglass {

struct CausticsPart {
    Caustics caustics;

    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc& desc, const Sea* sea) { return desc.caustics && sea; }
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& desc);
    Status cast(Body& body, VkCommandBuffer commands, const ViewDesc& view, const LightingDesc& lighting);
    Status drawLight(Body& body, const DrawCall& call) const;
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    Status prepare(const Body& body, const PrepareCall& call) const;
};

} // namespace seaglass
