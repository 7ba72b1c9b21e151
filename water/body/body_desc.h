// What a body's description may say.
#pragma once

#include "gpu/device.h"
#include "gpu/fields.h"
#include "seaglass/water.h"

namespace seaglass {

/// What is wrong with it, if anything is.
FieldError badField(const BodyDesc& desc);

/// What is asked for of a reflection, but for what still water would not show: nothing bends it, and nothing
/// but `scatter` blurs it.
ReflectionDesc reflectionOf(const ReflectionDesc& desc, bool hasWaves);

/// Who computes its waves on the CPU; null: compute shaders do.
const WavesBackend* chosenBackend(const gpu::Device& device, const BodyDesc& desc);

} // namespace seaglass
