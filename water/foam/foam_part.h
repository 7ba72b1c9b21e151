// The foam of a body whose waves break: its history, and the pattern that it breaks up into.
#pragma once

#include <memory>

#include "water/body/part.h"
#include "water/foam/foam.h"
#include "water/foam/foam_pattern.h"

namespace seaglass {

struct FoamPart {
    Foam foam;
    std::shared_ptr<FoamPattern> pattern;

    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc& desc, const Sea* sea);
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& desc);
    Status simulate(Body& body, VkCommandBuffer commands, double time);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const;
    Status bind(Body& body, const BodyView& view, Resources& out);
};

} // namespace seaglass
