// Wrong pixels that lie together: what is lost from a picture, where as many scattered ones are noise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace demos {

struct Blob {
    uint64_t pixels = 0;
    uint32_t left = 0, top = 0, width = 0, height = 0; ///< the box around it
};

struct Wrong {
    uint64_t pixels = 0;     ///< whose value is over the limit
    Blob largest;            ///< of those that touch, corners too; the topmost where two are as large
    std::vector<Blob> blobs; ///< the largest few, at most mostBlobs, in this order
};

/// As many as a reader looks at.
constexpr size_t mostBlobs = 4;

/// Of a map of one value a pixel, rows of `width` from the top.
Wrong findWrong(std::span<const float> map, uint32_t width, double over);

} // namespace demos
