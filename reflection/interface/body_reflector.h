// What the water library does with the reflector of a body, beside the calls of seaglass/reflection.h.
#pragma once

#include <memory>

#include <glm/mat3x3.hpp>

#include "gpu/view/single_sample.h"
#include "seaglass/reflection.h"

namespace seaglass {

/// Held by the body alone. Its bounds lie along `axes`, in the world.
Status createReflector(Context& context, const ReflectorDesc& desc, const glm::dmat3& axes,
                       std::shared_ptr<Reflector>& out);

/// What it mirrors next lies that much above its plane [m].
void raiseMirror(Reflector& reflector, double by);

/// Of a scene that all who read it in one call share.
Status reflect(VkCommandBuffer commands, Reflector& reflector, SceneOfCall& scene);

/// With the downscale that its height asks for in a view of this size.
ReflectionDesc sizedFor(const ReflectionDesc& desc, VkExtent2D extent);

/// Pixels of a view to one of its reflection, each way; null: of a view that is not known yet, of which no
/// height is a fraction.
uint32_t downscaleFor(const ReflectionDesc& desc, const VkExtent2D* view);

/// Its colour is of the view's images; else the host draws it.
bool readsScene(const ReflectionDesc& desc);

} // namespace seaglass
