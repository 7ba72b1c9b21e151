#include "tests/metrics/painted.h"

#include <cmath>

namespace tests {

Painted painted(int width, int height, const std::function<float(int, int, int)>& value) {
    Painted picture(static_cast<uint32_t>(width), static_cast<uint32_t>(height), {});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int channel = 0; channel < 3; ++channel) picture.rgba.push_back(value(x, y, channel));
            picture.rgba.push_back(1);
        }
    }
    return picture;
}

Painted grey(int width, int height, float value) {
    return painted(width, height, [value](int, int, int) { return value; });
}

Painted harbour() {
    return painted(160, 100, [](int x, int y, int channel) {
        const float sky = 0.75f - 0.1f * static_cast<float>(2 - channel);
        const float wave =
            0.08f * std::sin(0.35f * static_cast<float>(x) + 0.02f * static_cast<float>(y * y));
        const float sea = 0.3f + 0.08f * static_cast<float>(channel) + wave;
        if (x >= 70 && x < 90 && y >= 25 && y < 60) return channel == 0 ? 0.6f : 0.15f;
        return y < 45 ? sky : sea;
    });
}

} // namespace tests
