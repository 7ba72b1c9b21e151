// What is wrong with a description, for those who draw water without making a body.
#pragma once

#include "gpu/fields.h"
#include "seaglass/water.h"

namespace seaglass {

FieldError badField(const ExtentDesc& desc);
/// Of setExclusionVolumes(); null: nothing.
const char* badVolumes(const ExclusionVolume* volumes, uint32_t count);

} // namespace seaglass
