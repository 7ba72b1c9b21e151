// What a body lets through of the scene in it.
#pragma once

#include "water/body/part.h"

namespace seaglass {

struct RefractionPart {
    RefractionDesc desc;
    std::shared_ptr<SingleSamples> singleSamples; ///< null until it sees through a view with many

    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc& desc, const Sea*) { return desc.refraction; }
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& of);
    /// Of a multisampled scene, which draw() cannot make single-sampled inside a pass.
    Status reflect(Body& body, VkCommandBuffer commands, SceneOfCall& scene);
    /// Gives `read` single-sampled images for the host's own, if those are not.
    Status standIn(Context& context, const ViewDesc& view, ViewDesc& read) const;
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const;
    Status bind(Body& body, const BodyView& view, Resources& out);
    Status prepare(const Body& body, const PrepareCall& call) const;
};

/// The kernels that a multisampled view needs.
Status prepareSamples(const Body& body, const PrepareCall& call);

} // namespace seaglass
