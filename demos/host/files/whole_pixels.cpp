#include "host/files/whole_pixels.h"

#include <limits>

namespace demos {

namespace {

template<class Whole>
void spread(const Whole* wholes, size_t channels, std::array<int, 4> from, std::span<glm::vec4> to) {
    constexpr Whole none = 0, greatest = std::numeric_limits<Whole>::max();
    if (from[1] < 0) from[1] = from[2] = from[0];
    std::array<const Whole*, 4> at{&none, &none, &none, &greatest};
    std::array<size_t, 4> step{};
    for (size_t slot = 0; slot < 4; ++slot) {
        if (from[slot] < 0) continue;
        at[slot] = wholes + from[slot];
        step[slot] = channels;
    }
    for (glm::vec4& pixel : to) {
        pixel = glm::vec4(*at[0], *at[1], *at[2], *at[3]) / static_cast<float>(greatest);
        for (size_t slot = 0; slot < 4; ++slot) at[slot] += step[slot];
    }
}

} // namespace

void spreadWholes(const uint8_t* wholes, size_t channels, const std::array<int, 4>& from,
                  std::span<glm::vec4> to) {
    spread(wholes, channels, from, to);
}

void spreadWholes(const uint16_t* wholes, size_t channels, const std::array<int, 4>& from,
                  std::span<glm::vec4> to) {
    spread(wholes, channels, from, to);
}

} // namespace demos
