// What a sea's description may say.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// True when every field is in its range; else `error` names the first one that is not.
bool validate(const SeaDesc& desc, SeaError& error);

} // namespace seaglass
