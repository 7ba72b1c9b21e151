// The texture of the pattern that foam breaks up into, which all who draw it sample alike.
#pragma once

#include <cstdint>
#include <vector>

namespace seaglass {

constexpr uint32_t foamPatternSamples = 256;

/// A place of the pattern, as four bytes of a texel.
struct FoamTexel {
    uint8_t pattern = 0; ///< evenly distributed over 0..255: `pattern < cover` covers a share `cover`
    uint8_t bend = 0;    ///< smooth noise of its own, which bends the edge of what is foamy
    uint8_t slopeU = 0, slopeV = 0; ///< 128 + 128 of how the foam rises, in foamReliefStep a texel
};
constexpr float foamReliefStep = 0.1f; ///< of the pattern, a texel

/// Mip by mip from foamPatternSamples^2 texels on, rows along u; tiles without a seam.
std::vector<std::vector<FoamTexel>> foamPattern();

} // namespace seaglass
