// The shore of a body: what its shaders read of it.
#pragma once

#include "water/body/part.h"
#include "water/shore/shore_map.h"

namespace seaglass {

struct ShorePart {
    ShoreMap map;
    double decayTime = double{FoamDesc{}.decayTime}; ///< of breakers' foam [s]
    /// Of the trains, until the frame ends.
    gpu::Resource rows;
    uint64_t rowsOf = 0;   ///< that frame
    bool rowsMove = false; ///< those of the last frame are there, too

    static bool wanted(const BodyDesc& desc, const Sea* sea);
    static Status addCost(const AskedBody& asked, Estimate& sum);
    Status create(Body& body, const BodyDesc& desc);
    Status simulate(Body& body, VkCommandBuffer commands, double time);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const;
    Status bind(Body& body, const BodyView& view, Resources& out);

  private:
    Status uploadRows(Context& context, bool move);
};

} // namespace seaglass
