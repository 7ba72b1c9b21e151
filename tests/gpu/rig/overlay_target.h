// What recordOverlay() draws into.
#pragma once

#include "host/vulkan/resources.h"
#include "seaglass/reflection.h"

namespace tests {

demos::Image overlayTarget(VkExtent2D extent);
/// As OverlayDesc::target has it.
seaglass::Image described(const demos::Image& target);
void toGeneral(VkCommandBuffer commands, const demos::Image& target);
void toSampled(VkCommandBuffer commands, const demos::Image& target);

} // namespace tests
