// What a body's description may say.
#pragma once

#include "seaglass/water.h"

namespace seaglass {

/// Null when it is usable, else what is wrong with it.
const char* badField(const BodyDesc& desc);

} // namespace seaglass
