// Numbers that are a function of (pixel, sample, seed) alone, so that a picture does not depend on who draws
// which pixel when.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

namespace demos::reference {

/// Integer hash with good avalanche (Wellons, "lowbias32").
inline uint32_t hash(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ (x >> 16);
}

inline float unitOf(uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

inline uint32_t reversed(uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffU) << 8) | ((x >> 8) & 0x00ff00ffU);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
    x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
    return ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
}

/// Owen's scrambling in base two, by a hash (Burley 2020, "Practical Hash-based Owen Scrambling").
inline uint32_t scrambled(uint32_t x, uint32_t seed) {
    x = reversed(x) + seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reversed(x);
}

/// Each call gives the next two dimensions of a sequence whose first 16, 64, 256 ... points fill the unit
/// square evenly: Sobol's first two, scrambled and in an order of the call's own, so that calls do not know
/// of each other.
class Random {
  public:
    Random(uint32_t pixel, uint32_t sample, uint64_t seed)
        : pixel_(hash(pixel + hash(static_cast<uint32_t>(seed) + hash(static_cast<uint32_t>(seed >> 32))))),
          sample_(sample) {}

    /// 0 <= x < 1.
    float next() { return next2().x; }
    glm::vec2 next2() { return pointOf(++calls_); }
    /// Two independent normal deviates (Box and Muller 1958).
    glm::vec2 nextNormal() {
        const glm::vec2 at = next2();
        const float radius = std::sqrt(-2 * std::log(1 - at.x));
        const float angle = 2 * std::numbers::pi_v<float> * at.y;
        return radius * glm::vec2(std::cos(angle), std::sin(angle));
    }
    /// Where in its pixel the sample lies.
    glm::vec2 inPixel() const { return pointOf(0); }

  private:
    glm::vec2 pointOf(uint32_t call) const {
        const uint32_t seed = hash(pixel_ + 0x9e3779b9U * (call + 1));
        const uint32_t index = scrambled(sample_, seed);
        uint32_t second = 0;
        for (uint32_t rest = index, direction = 1U << 31; rest != 0; rest >>= 1, direction ^= direction >> 1)
            if (rest & 1) second ^= direction;
        return {unitOf(scrambled(reversed(index), hash(seed + 1))),
                unitOf(scrambled(second, hash(seed + 2)))};
    }

    uint32_t pixel_, sample_, calls_ = 0;
};

} // namespace demos::reference
