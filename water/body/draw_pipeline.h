// Graphics pipelines that draw into a host's pass.
#pragma once

#include <span>

#include "gpu/made_once.h"
#include "gpu/pipeline/binding.h"
#include "gpu/view/view.h"
#include "seaglass/water.h"

namespace seaglass {

/// What becomes of what is drawn.
enum class Drawing {
    solid,    ///< depth tested and, if the target wants it, written; no blending
    over,     ///< replaces the colour, whatever the depth
    blended,  ///< the same by its alpha; the target's alpha stays
    floating, ///< depth tested, not written, and blended likewise
    scaled,   ///< multiplies the colour; the target's alpha stays
    added,    ///< to the colour, whatever the depth; the target's alpha stays
};

struct DrawPipeline {
    gpu::Layout layout;
    VkPipeline handle = VK_NULL_HANDLE;
};

struct DrawShaders {
    std::span<const uint32_t> vertex;
    std::span<const uint32_t> fragment;
    std::span<const uint32_t> constants; ///< of both shaders, number 0 first
};

void bindDraw(const gpu::Device& device, VkCommandBuffer commands, const DrawPipeline& pipeline,
              VkDescriptorSet set, uint32_t viewIndex);

struct BodyView;
struct DrawCall;

/// Triangles over a view, which their vertex shader places by number. `pass` names them; `resources`: all
/// that the pipeline's shaders read.
Status recordTriangles(Context& context, const DrawCall& call, const BodyView& view,
                       const DrawPipeline& pipeline, const char* pass, uint32_t triangles,
                       std::span<const gpu::Bound> resources);

/// The view's, over its region alone.
void setViewport(const gpu::Device& device, VkCommandBuffer commands, const ViewDesc& view,
                 const ViewGeometry& geometry);

/// Triangles seen from both sides. Shaders of multiview passes are told by a push constant which view is
/// drawn.
Status createDrawPipeline(const gpu::Device& device, const TargetDesc& target, const DrawShaders& shaders,
                          Drawing drawing, const char* what, DrawPipeline& out);

/// Those of one target, each made when it is first asked for, by the buildPipeline() of its variants. Any
/// thread may ask.
template<typename Variant>
class DrawPipelines {
  public:
    DrawPipelines() = default;
    ~DrawPipelines() {
        pipelines_.forEach([&](const DrawPipeline& pipeline) {
            device_->vk().DestroyPipeline(device_->handle(), pipeline.handle, device_->allocator());
        });
    }
    DrawPipelines(const DrawPipelines&) = delete;
    DrawPipelines& operator=(const DrawPipelines&) = delete;

    void init(const gpu::Device& device, const TargetDesc& target) {
        device_ = &device;
        target_ = target;
    }

    Status get(const Variant& variant, const DrawPipeline*& out) {
        return pipelines_.get(
            variant, [&](DrawPipeline& made) { return buildPipeline(*device_, target_, variant, made); },
            out);
    }

  private:
    const gpu::Device* device_ = nullptr;
    TargetDesc target_;
    gpu::MadeOnce<Variant, DrawPipeline> pipelines_;
};

} // namespace seaglass
