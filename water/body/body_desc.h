// What a body's description may say.
#pragma once

#include "gpu/device.h"
#include "gpu/fields.h"
#include "seaglass/water.h"

namespace seaglass {

/// What is wrong with it, if anything is.
FieldError badField(const BodyDesc& desc);

} // namespace seaglass
