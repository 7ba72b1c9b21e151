// What a body mirrors: its reflector, and how its surface looks that up.
#pragma once

#include <array>
#include <optional>

#include "reflection/interface/body_reflector.h"
#include "water/body/part.h"
#include "water/reflection/mirrored_level.h"

namespace seaglass {

struct ReflectionPart {
    ReflectionDesc desc; ///< the reflector's
    std::shared_ptr<Reflector> reflector;
    float distortion = 0;
    /// In what frame a view was last reflected, and last drawn with what was: so that what comes too late is
    /// named.
    std::array<uint64_t, maxViews> reflectedIn{}, mirroredIn{};
    mutable std::optional<EyeOverWaves> eyeOverWaves;

    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc& desc, const Sea*);
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& of);
    /// Tells the reflector where to mirror for a view.
    void aim(const Body& body, const ViewDesc& view);
    Status reflect(Body& body, VkCommandBuffer commands, SceneOfCall& scene);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const;
    Status bind(Body& body, const BodyView& view, Resources& out);
    Status prepare(const Body& body, const PrepareCall& call) const;
};

} // namespace seaglass
