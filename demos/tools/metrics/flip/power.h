// Powers without branches and without a call, so that the compiler takes several of a row at once.
#pragma once

#include <bit>
#include <cstdint>

namespace demos {

/// Of a normal number over 0, within 1e-7 of it and of its magnitude.
inline float binaryLogarithm(float x) {
    constexpr int32_t rootOfHalf = 0x3f3504f3; // the bits of a float
    const auto bits = std::bit_cast<int32_t>(x);
    const int32_t exponent = (bits - rootOfHalf) >> 23;
    const auto mantissa = std::bit_cast<float>(bits - exponent * (1 << 23)); // sqrt(1/2) .. sqrt(2)
    // ln m = 2 artanh((m - 1) / (m + 1)), by its series.
    constexpr float twoOverLn2 = 2.88539008f;
    const float s = (mantissa - 1) / (mantissa + 1), s2 = s * s;
    const float series = 1 + s2 * (1.0f / 3 + s2 * (1.0f / 5 + s2 * (1.0f / 7 + s2 * (1.0f / 9))));
    return static_cast<float>(exponent) + twoOverLn2 * s * series;
}

/// Of -126 .. 127, within 2e-7 of its magnitude.
inline float binaryExponential(float x) {
    const auto whole = static_cast<int32_t>(x + (x < 0 ? -0.5f : 0.5f));
    // e^y by its series, y at most half of ln 2.
    const float y = 0.693147181f * (x - static_cast<float>(whole));
    const float series =
        1 + y * (1 + y * (1.0f / 2 +
                          y * (1.0f / 6 +
                               y * (1.0f / 24 + y * (1.0f / 120 + y * (1.0f / 720 + y * (1.0f / 5040)))))));
    return series * std::bit_cast<float>((whole + 127) * (1 << 23));
}

/// x to `exponent`, each 0 or more; 0 where x is smaller than any picture's light, 1 where the exponent is 0.
/// The result must be within 2^-126 .. 2^127.
inline float power(float x, float exponent) {
    constexpr float smallest = 1e-18f;
    const float result = binaryExponential(exponent * binaryLogarithm(x > smallest ? x : smallest));
    const float ofNothing = exponent == 0 ? 1.0f : 0.0f;
    return x > smallest ? result : ofNothing;
}

} // namespace demos
