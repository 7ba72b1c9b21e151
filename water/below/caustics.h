// Sunlight that waves gather on what lies below them: rays are cast from the pixels of a view, and what they
// leave of light is gathered in a picture and blurred by what they do not know of; caustics.frag reads that.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gpu/context.h"
#include "gpu/memory/buffer.h"
#include "gpu/memory/image.h"
#include "gpu/memory/mip_chain.h"
#include "gpu/pipeline/kernel.h"
#include "gpu/view/limits.h"
#include "gpu/view/view.h"
#include "seaglass/water.h"

namespace seaglass {

/// Deviation along any axis of the slopes that a mean over 2^i / 128 metres leaves out.
using LostSlopes = std::array<float, 8>;
LostSlopes lostSlopesOf(const Sea& sea);

/// Its ray through calm water, and what waves make of that.
struct SunInWater {
    glm::dvec3 from{0, 1, 0}; ///< where it comes from, unit
    /// How far a slope of 1 would turn it sideways on each metre down, at the rate of small ones: along the
    /// sun's own direction on the plane, and across it. 1 - 1/n of a sun straight above.
    double turnedAlong = 0, turnedAcross = 0;
};

/// Of a sun above the surface; `toSun` is unit, in the body's axes.
SunInWater sunInWater(const glm::dvec3& toSun);

struct BodyBlock;
/// Of the block's sun, which shaders then find there as it shines in the water.
SunInWater fillSunInWater(BodyBlock& block);

/// How rays are cast on a view, in its pixels.
struct CausticGrid {
    int step = 1;      ///< from one ray to the next, each way; as wide is a texel of light
    int margin = 0;    ///< around the view, from where rays come too: whole steps
    int rowLength = 0; ///< of the buffer, in texels
    /// Rows of texels, some of them in the margin, that may show what is below the horizon; one of the view
    /// at the least.
    int firstRow = 0, endRow = 0;
};

/// `height` is the eye's above the plane.
CausticGrid causticGrid(const ShadingDesc& shading, const ViewGeometry& view, double height);

struct CastKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};
struct CastOnShoreKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};
struct GatherKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};
struct CausticBlurKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};
struct ShadowedCausticBlurKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

struct CausticInputs {
    std::vector<gpu::Bound> resources; ///< all that some shader of the body reads
    uint32_t viewIndex = 0;
    bool inShadow = false; ///< there is a map of what hides the sun
    glm::ivec2 region{0};
    CausticGrid grid;

    /// The body's, and these.
    std::vector<gpu::Bound> with(std::initializer_list<gpu::Bound> own) const {
        std::vector<gpu::Bound> all = resources;
        all.insert(all.end(), own);
        return all;
    }
};

/// Of one body: a picture for each view index, as large as the largest view of that index so far.
class Caustics {
  public:
    Status create(Context& context, const Sea& sea, const CausticsDesc& desc);
    float strength() const { return strength_; }
    const LostSlopes& lostSlopes() const { return lostSlopes_; }

    /// Leaves the light of one view to be read.
    Status record(Context& context, VkCommandBuffer commands, const CausticInputs& inputs);
    /// Light, and what it would be under calm water; null unless it was cast in this frame, last for a view
    /// of this size.
    VkBuffer lightOf(const Context& context, uint32_t viewIndex, const glm::ivec2& region) const;

    static constexpr uint32_t dispatches = 3;
    /// Of one view, and of its bed where the body has one.
    static VkDeviceSize bytes(const gpu::Device& device, const BodyDesc& desc, VkExtent2D view);

  private:
    struct Picture {
        gpu::Buffer sums; ///< then what is copied to the image, and in the end the light blurred
        gpu::OwnedImage gathered;
        uint64_t frame = 0;
        glm::ivec2 region{0};
    };
    Status fit(Context& context, VkExtent2D texels, Picture& picture) const;
    Status recordCast(Context& context, VkCommandBuffer commands, const CausticInputs& inputs,
                      const Picture& picture) const;
    Status recordGather(Context& context, VkCommandBuffer commands, const CausticInputs& inputs,
                        const Picture& picture) const;
    Status recordBlur(Context& context, VkCommandBuffer commands, const CausticInputs& inputs,
                      const Picture& picture);
    const gpu::Kernel& castKernel() const { return castOnShore_ ? castOnShore_->kernel : cast_->kernel; }

    float strength_ = 1;
    LostSlopes lostSlopes_{};
    std::shared_ptr<CastKernel> cast_;
    std::shared_ptr<CastOnShoreKernel> castOnShore_; ///< instead of that
    std::shared_ptr<GatherKernel> gather_;
    std::shared_ptr<CausticBlurKernel> blur_;
    std::shared_ptr<ShadowedCausticBlurKernel> blurInShadow_; ///< from the first shadow map on
    gpu::MipChain mips_;
    std::array<Picture, maxViews> views_;
};

} // namespace seaglass
