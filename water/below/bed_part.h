// The picture of its own that a body's bed has, where it has one.
#pragma once

#include "water/below/bed.h"
#include "water/body/part.h"

namespace seaglass {

struct BedPart {
    Bed bed;

    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc& desc, const Sea*) { return desc.bed; }
    static Status addCost(const AskedBody& asked, Estimate& sum);
    /// Of a description with a bed.
    static VkExtent2D pictureExtent(const BodyDesc& desc, VkExtent2D view);
    Status create(Body& body, const BodyDesc& desc);
    /// bedView()
    Status handOut(Body& body, const ViewDesc& view, PlanarView& out);
    Status reflect(Body& body, VkCommandBuffer commands, SceneOfCall& scene);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const;
    Status bind(Body& body, const BodyView& view, Resources& out);

  private:
    /// Null where the view has none in this frame, or looks at none.
    const BedPicture* seen(const Body& body, const BodyView& view) const;
};

} // namespace seaglass
