// matplotlib's magma (Nathaniel J. Smith and Stefan van der Walt, CC0), in the polynomial fit of degree six
// by Matt Zucker ("mattz", shadertoy WlfXRN, CC0): off by at most about 2 % of the range.
#include "metrics/magma.h"

#include <algorithm>
#include <cmath>

namespace demos {

namespace {

/// From the constant term up.
constexpr std::array<std::array<float, 7>, 3> coefficients = {{
    {-0.0021364851f, 0.2516605407f, 8.3537172792f, -27.6687330858f, 52.1761398123f, -50.7685253647f,
     18.6557050659f},
    {-0.0007496551f, 0.6775232437f, -3.5777195150f, 14.2647307810f, -27.9436060717f, 29.0465828213f,
     -11.4897735200f},
    {-0.0053861279f, 2.4940265993f, 0.3144679030f, -13.6492131881f, 12.9441694424f, 4.2341529938f,
     -5.6019615087f},
}};

} // namespace

std::array<uint8_t, 3> magma(float value) {
    const float t = std::clamp(value, 0.0f, 1.0f);
    std::array<uint8_t, 3> rgb{};
    for (size_t channel = 0; channel < 3; ++channel) {
        float color = 0;
        for (size_t i = coefficients[channel].size(); i-- > 0;) color = color * t + coefficients[channel][i];
        rgb[channel] = static_cast<uint8_t>(std::lround(std::clamp(color, 0.0f, 1.0f) * 255));
    }
    return rgb;
}

std::vector<uint8_t> magma(std::span<const float> map) {
    std::vector<uint8_t> bytes;
    bytes.reserve(3 * map.size());
    for (const float value : map) {
        const std::array<uint8_t, 3> rgb = magma(value);
        bytes.insert(bytes.end(), rgb.begin(), rgb.end());
    }
    return bytes;
}

} // namespace demos
