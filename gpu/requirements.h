// What a physical device lacks, if anything.
#pragma once

#include "gpu/dispatch.h"
#include "seaglass/host.h"

namespace seaglass::gpu {

/// Writes the first thing missing into `text` and returns false, or returns true.
bool supported(const InstanceTable& vk, VkPhysicalDevice physicalDevice, char* text, size_t size);

} // namespace seaglass::gpu
