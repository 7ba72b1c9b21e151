// What a part is to a body: something that its description may ask for, and all that this takes. Each lies in
// a folder of its own; parts.cpp lists them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gpu/context.h"
#include "gpu/fields.h"
#include "gpu/type_erased.h"
#include "gpu/view/single_sample.h"
#include "gpu/view/view.h"
#include "seaglass/water.h"
#include "shaders/shared/body_block.h"
#include "water/surface/surface.h"

namespace seaglass {

struct Body;
struct Target;

/// A body that is not made yet.
struct AskedBody {
    Context& context;
    const BodyDesc& desc;       ///< a usable one
    const Sea* sea = nullptr;   ///< null: flat
    VkExtent2D extent = {0, 0}; ///< of a view
    SceneSamples samples;       ///< likewise
};

/// What the host hands in to draw.
struct DrawCall {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    Target& target;
    const ViewDesc& view;
    const LightingDesc& lighting;
};

/// The same to make pipelines ahead of that.
struct PrepareCall {
    Target& target;
    const ViewDesc* view = nullptr; ///< null: any
    const LightingDesc& lighting;
    SurfaceOutput output = SurfaceOutput::shaded;
    bool sceneIsEncoded = false;
};
/// The surface of what will be drawn, as it is seen from above.
SurfaceDraw drawnAhead(const PrepareCall& call);

/// A view of a body, read and found usable.
struct BodyView {
    const ViewDesc* given = nullptr; ///< the host's
    ViewDesc read;                   ///< with single-sampled images in the place of others
    ViewGeometry geometry;           ///< in the body's axes
    const LightingDesc* lighting = nullptr;
    const SurfaceDraw* surface = nullptr; ///< null: another pass than the surface's
};

/// When parts draw that are not of the surface.
enum class DrawMoment { beforeSurfaces, afterSurfaces };

using Resources = std::vector<gpu::Bound>;

/// An image of the host's, texel by texel.
inline gpu::Resource sampledTexels(const Context& context, const Image& image) {
    return gpu::sampledImage(context.samplers.nearestClamp(), image.view, image.layout);
}

/// What is null a part has not.
struct Part {
    const void* tag = nullptr; ///< of the type of its state
    /// The field of BodyDesc without which draw() can do without the scene's images.
    const char* needsScene = nullptr;
    /// What is wrong with its own of a description, or missing of others'.
    FieldError (*validate)(const BodyDesc& desc) = nullptr;
    /// Of a usable description. `sea`: null where it is flat.
    bool (*wanted)(const BodyDesc& desc, const Sea* sea) = nullptr;
    /// Of a part that is wanted: adds memory and dispatches.
    Status (*addCost)(const AskedBody& asked, Estimate& sum) = nullptr;
    Status (*create)(Body& body, const BodyDesc& desc, std::shared_ptr<void>& out) = nullptr;
    Status (*simulate)(void* state, Body& body, VkCommandBuffer commands, double time) = nullptr;
    /// What it makes of the scene before any surface is drawn.
    Status (*reflect)(void* state, Body& body, VkCommandBuffer commands, SceneOfCall& scene) = nullptr;
    /// Fills what shaders read of it.
    void (*fill)(const void* state, const Body& body, const BodyView& view, BodyBlock& block) = nullptr;
    /// Switches the surface's code for it on. Beside calls that record on another thread: reads nothing that
    /// they write.
    void (*vary)(const void* state, const Body& body, const SurfaceDraw& draw,
                 SurfaceVariant& variant) = nullptr;
    /// Adds what shaders sample of it.
    Status (*bind)(void* state, Body& body, const BodyView& view, Resources& out) = nullptr;
    /// Draws over the view.
    Status (*draw)(const void* state, Body& body, const DrawCall& call, DrawMoment moment) = nullptr;
    /// Makes what that, and others but the surface, will want. Beside other calls as `vary`.
    Status (*prepare)(const void* state, const Body& body, const PrepareCall& call) = nullptr;
};

/// In the order in which they are made, simulated and recorded.
std::span<const Part> parts();

/// Its address is a type's own.
template<typename T>
inline constexpr char partTag = 0;

/// Of a type with `wanted`, and with those of the other functions that it needs.
template<typename T>
constexpr Part partFrom() {
    Part part;
    part.tag = &partTag<T>;
    part.wanted = T::wanted;
    part.create = [](Body& body, const BodyDesc& desc, std::shared_ptr<void>& out) {
        [[maybe_unused]] T& made = gpu::makeShared<T>(out);
        if constexpr (requires { &T::create; }) return made.create(body, desc);
        return Status::ok;
    };
    if constexpr (requires { &T::validate; }) part.validate = T::validate;
    if constexpr (requires { &T::addCost; }) part.addCost = T::addCost;
    if constexpr (requires { &T::simulate; })
        part.simulate = [](void* state, Body& body, VkCommandBuffer commands, double time) {
            return static_cast<T*>(state)->simulate(body, commands, time);
        };
    if constexpr (requires { &T::reflect; })
        part.reflect = [](void* state, Body& body, VkCommandBuffer commands, SceneOfCall& scene) {
            return static_cast<T*>(state)->reflect(body, commands, scene);
        };
    if constexpr (requires { &T::fill; })
        part.fill = [](const void* state, const Body& body, const BodyView& view, BodyBlock& block) {
            static_cast<const T*>(state)->fill(body, view, block);
        };
    if constexpr (requires { &T::vary; })
        part.vary = [](const void* state, const Body& body, const SurfaceDraw& draw,
                       SurfaceVariant& variant) { static_cast<const T*>(state)->vary(body, draw, variant); };
    if constexpr (requires { &T::bind; })
        part.bind = [](void* state, Body& body, const BodyView& view, Resources& out) {
            return static_cast<T*>(state)->bind(body, view, out);
        };
    if constexpr (requires { &T::draw; })
        part.draw = [](const void* state, Body& body, const DrawCall& call, DrawMoment moment) {
            return static_cast<const T*>(state)->draw(body, call, moment);
        };
    if constexpr (requires { &T::prepare; })
        part.prepare = [](const void* state, const Body& body, const PrepareCall& call) {
            return static_cast<const T*>(state)->prepare(body, call);
        };
    return part;
}

/// What is wrong with what a description points at, if it does and anything is.
FieldError badAsked(const FieldTable& table, const void* asked);

} // namespace seaglass
