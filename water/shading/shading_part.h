// The surface: found first and shaded once, in shade(); draw() then places what that made.
#pragma once

#include <array>
#include <map>

#include "gpu/view/limits.h"
#include "water/body/part.h"
#include "water/shading/shaded_surface.h"

namespace seaglass {

struct SeenSurface;

struct ShadingPart {
    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc&, const Sea*) { return true; }
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& desc);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const;
    Status prepare(const Body& body, const PrepareCall& call) const;

    Status shade(Body& body, VkCommandBuffer commands, const ViewDesc& view, const LightingDesc& lighting,
                 SurfaceOutput output);
    /// Draws what shade() left over the host's pass. `seen`: as it was read for this call.
    Status place(Body& body, const DrawCall& call, SeenSurface& seen) const;

    /// In views of so many pixels tiles are shaded by kernels without what they do not need; in smaller ones
    /// all by the same.
    uint64_t sortedFromPixels = 0;
    /// What shines through and what is mirrored is looked up by kernels of their own.
    bool bySteps = false;
    /// As shade() left them of SurfaceOutput::shaded.
    const ShadedSurface& shaded(uint32_t viewIndex) const {
        return views_[viewIndex].find(SurfaceOutput::shaded)->second.shaded;
    }

  private:
    /// What shade() was given that a BodyBlock does not hold.
    struct Sources {
        VkImageView sceneColor = VK_NULL_HANDLE, sceneDepth = VK_NULL_HANDLE, skyCube = VK_NULL_HANDLE,
                    shadow = VK_NULL_HANDLE;
        bool operator==(const Sources&) const = default;
    };
    static Sources sourcesOf(const ViewDesc& view, const LightingDesc& lighting);
    struct Picture {
        FoundSurface found;
        ShadedSurface shaded; ///< but of motion
        uint64_t frame = 0;   ///< in which it was shaded last; 0: never
        bool shows = false;   ///< anything of the body
        BodyBlock block{};    ///< as it was shaded by
        Sources sources;
    };
    Status fit(Context& context, VkExtent2D region, SurfaceOutput output, const ShadedBy& kernels,
               Picture& picture) const;
    /// What shade() was given the same for before; else refused.
    Status find(const Body& body, const BodyView& view, const Picture*& out) const;
    static void bindPicture(const Context& context, const Picture& picture, SurfaceOutput output,
                            Resources& out);
    Status placeView(Body& body, const DrawCall& call, const BodyView& view, const Picture& picture) const;
    Status placeSamples(Body& body, const DrawCall& call, SeenSurface& seen, const Picture& picture) const;
    Status getKernels(const SurfaceVariant& variant, bool sorted, ShadedBy& out) const;
    Status prepareShading(const Body& body, const PrepareCall& call, SurfaceVariant& variant) const;
    Status record(Body& body, VkCommandBuffer commands, const SeenSurface& seen, Picture& picture);

    std::shared_ptr<FoundPasses> passes_;
    std::shared_ptr<SurfaceTilesKernels> tiles_;
    std::shared_ptr<ShadingKernels> kernels_;
    std::shared_ptr<CompletingKernels> completing_;
    std::array<std::map<SurfaceOutput, Picture>, maxViews> views_; ///< of what was asked for
};

} // namespace seaglass
