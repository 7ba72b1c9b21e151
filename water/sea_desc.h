// What a sea's description may say.
#ifndef SEAGLASS_WATER_SEA_DESC_H
#define SEAGLASS_WATER_SEA_DESC_H

#include "seaglass/sea.h"

namespace seaglass {

/// True when every field is in its range; else `error` names the first one that is not.
bool validate(const SeaDesc& desc, SeaError& error);

} // namespace seaglass

#endif
