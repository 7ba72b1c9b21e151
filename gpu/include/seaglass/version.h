// Which Seaglass this is. The build takes the version from here.
#pragma once

#include <cstdint>

#define SEAGLASS_VERSION_MAJOR 0
#define SEAGLASS_VERSION_MINOR 1
#define SEAGLASS_VERSION_PATCH 0
/// Of the headers: major << 22 | minor << 12 | patch, as Vulkan packs its own.
#define SEAGLASS_VERSION                                                                                     \
    ((SEAGLASS_VERSION_MAJOR << 22u) | (SEAGLASS_VERSION_MINOR << 12u) | SEAGLASS_VERSION_PATCH)

namespace seaglass {

/// Of the library that is linked; createContext() refuses headers of another major or minor one. Any thread.
uint32_t version();

} // namespace seaglass
