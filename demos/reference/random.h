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

class Random {
  public:
    Random(uint32_t pixel, uint32_t sample, uint64_t seed)
        : pixel_(hash(pixel + hash(static_cast<uint32_t>(seed) + hash(static_cast<uint32_t>(seed >> 32))))),
          sample_(sample), state_(hash(pixel_ + hash(sample + 0x9e3779b9U))) {}

    /// 0 <= x < 1.
    float next() {
        state_ += 0x9e3779b9U;
        return unitOf(hash(state_));
    }
    glm::vec2 next2() {
        const float x = next();
        return {x, next()};
    }
    /// Two independent normal deviates (Box and Muller 1958).
    glm::vec2 nextNormal() {
        const float radius = std::sqrt(-2 * std::log(1 - next()));
        const float angle = 2 * std::numbers::pi_v<float> * next();
        return radius * glm::vec2(std::cos(angle), std::sin(angle));
    }
    /// Where in its pixel the sample lies: an additive recurrence fills the square evenly (Roberts 2018,
    /// "R2").
    glm::vec2 inPixel() const {
        const auto shifted = [&](uint32_t salt, double step) {
            const double x = static_cast<double>(unitOf(hash(pixel_ ^ salt))) + step * sample_;
            return static_cast<float>(x - std::floor(x));
        };
        return {shifted(0x51ed270bU, 0.7548776662466927), shifted(0xc2b2ae35U, 0.5698402909980532)};
    }

  private:
    uint32_t pixel_, sample_, state_;
};

} // namespace demos::reference
