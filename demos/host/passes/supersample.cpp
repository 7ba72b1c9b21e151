#include "host/passes/supersample.h"

namespace demos {

Picture averaged(const Picture& large, uint32_t factor) {
    Picture out;
    out.width = large.width / factor;
    out.height = large.height / factor;
    out.rgba.assign(size_t{out.width} * out.height * 4, 0.0f);
    const float weight = 1.0f / static_cast<float>(factor * factor);
    for (uint32_t y = 0; y < out.height * factor; ++y)
        for (uint32_t x = 0; x < out.width * factor; ++x) {
            const float* from = &large.rgba[(size_t{y} * large.width + x) * 4];
            float* to = &out.rgba[(size_t{y / factor} * out.width + x / factor) * 4];
            for (int channel = 0; channel < 4; ++channel) to[channel] += from[channel] * weight;
        }
    return out;
}

} // namespace demos
