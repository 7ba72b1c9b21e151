#include "gpu/type_erased.h"

namespace seaglass::gpu {

std::shared_ptr<void> shared(Erased object) {
    return object;
}

} // namespace seaglass::gpu
