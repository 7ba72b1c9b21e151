// A surface that is found first and shaded once, in shade(); draw() then places what that made.
#pragma once

#include <array>

#include "gpu/view/limits.h"
#include "water/body/part.h"
#include "water/deferred/shaded_surface.h"

namespace seaglass {

struct SeenSurface;

struct DeferredPart {
    static bool wanted(const BodyDesc& desc, const Sea*) { return desc.shading.deferred; }
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& desc);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    Status prepare(const Body& body, const PrepareCall& call) const;

    Status shade(Body& body, VkCommandBuffer commands, const ViewDesc& view, const LightingDesc& lighting);
    /// Whether that is shaded this way: the surface from above, and nothing else.
    static bool shades(const SurfaceDraw& drawn);
    /// Draws what shade() left over the host's pass. `seen`: as it was read for this call.
    Status place(Body& body, const DrawCall& call, SeenSurface& seen) const;

    /// Tiles are shaded by kernels without what they do not need; false: all by the same, for comparison.
    bool sortsTiles = true;
    /// As shade() left them.
    const SurfaceTiles& tiles(uint32_t viewIndex) const { return views_[viewIndex].shaded.tiles; }

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
        ShadedSurface shaded;
        uint64_t frame = 0; ///< in which it was shaded last; 0: never
        bool shows = false; ///< anything of the body
        BodyBlock block{};  ///< as it was shaded by
        Sources sources;
    };
    Status fit(Context& context, VkExtent2D region, Picture& picture) const;
    /// Refused unless shade() was given the same before.
    Status check(const Body& body, const BodyView& view) const;
    Status placeView(Body& body, const DrawCall& call, const BodyView& view) const;
    Status placeSamples(Body& body, const DrawCall& call, SeenSurface& seen) const;
    Status getKernels(const SurfaceVariant& variant, const TilesKernels*& listing,
                      ListedKernels& shading) const;
    Status record(Body& body, VkCommandBuffer commands, const SeenSurface& seen, Picture& picture);

    std::shared_ptr<FoundPass> pass_;
    std::shared_ptr<SurfaceTilesKernels> tiles_;
    std::shared_ptr<ShadingKernels> kernels_;
    std::array<Picture, maxViews> views_;
};

} // namespace seaglass
