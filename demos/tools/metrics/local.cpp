#include "metrics/local.h"

#include <algorithm>
#include <vector>

namespace demos {

Square worstSquare(std::span<const float> map, uint32_t width, uint32_t side) {
    Square worst;
    if (map.empty()) return worst;
    const size_t height = map.size() / width;
    const size_t wide = std::min<size_t>(side, width), high = std::min<size_t>(side, height);
    // Of each column, the sum over the rows of the square.
    std::vector<double> columns(width);
    double most = 0;
    for (size_t y = 0; y < height; ++y) {
        for (size_t x = 0; x < width; ++x) {
            columns[x] += static_cast<double>(map[y * width + x]);
            if (y >= high) columns[x] -= static_cast<double>(map[(y - high) * width + x]);
        }
        if (y + 1 < high) continue;
        double sum = 0;
        for (size_t x = 0; x < width; ++x) {
            sum += columns[x];
            if (x >= wide) sum -= columns[x - wide];
            if (x + 1 < wide || sum <= most) continue;
            most = sum;
            worst.left = static_cast<uint32_t>(x + 1 - wide);
            worst.top = static_cast<uint32_t>(y + 1 - high);
        }
    }
    worst.mean = most / static_cast<double>(wide * high);
    return worst;
}

} // namespace demos
