#include "metrics/blob.h"

#include <algorithm>
#include <cstddef>

namespace demos {

namespace {

/// Takes pixels off a map of those that are wrong, a blob at a time.
class Taker {
  public:
    Taker(std::span<const float> map, uint32_t width, double over)
        : width_(width), height_(map.size() / width), wrong_(map.size()) {
        std::transform(map.begin(), map.end(), wrong_.begin(),
                       [over](float value) { return static_cast<double>(value) > over ? 1 : 0; });
    }

    bool isWrong(size_t pixel) const { return wrong_[pixel] != 0; }

    Blob take(size_t first) {
        size_t left = first % width_, right = left, bottom = first / width_;
        uint64_t pixels = 0;
        push(first);
        while (!open_.empty()) {
            const size_t x = open_.back() % width_, y = open_.back() / width_;
            open_.pop_back();
            ++pixels;
            left = std::min(left, x);
            right = std::max(right, x);
            bottom = std::max(bottom, y);
            pushNeighbours(x, y);
        }
        // Rows are looked through from the top, so the first pixel is in the topmost.
        const size_t top = first / width_;
        return {pixels, static_cast<uint32_t>(left), static_cast<uint32_t>(top),
                static_cast<uint32_t>(right - left + 1), static_cast<uint32_t>(bottom - top + 1)};
    }

  private:
    void push(size_t pixel) {
        if (wrong_[pixel] == 0) return;
        wrong_[pixel] = 0;
        open_.push_back(pixel);
    }

    void pushNeighbours(size_t x, size_t y) {
        for (size_t row = y - std::min<size_t>(y, 1); row <= std::min(y + 1, height_ - 1); ++row) {
            for (size_t column = x - std::min<size_t>(x, 1); column <= std::min(x + 1, width_ - 1);
                 ++column) {
                push(row * width_ + column);
            }
        }
    }

    size_t width_, height_;
    std::vector<uint8_t> wrong_;
    std::vector<size_t> open_;
};

/// Where it belongs by its size, behind those that are as large.
void insert(std::vector<Blob>& blobs, const Blob& blob) {
    const auto place = std::upper_bound(blobs.begin(), blobs.end(), blob,
                                        [](const Blob& a, const Blob& b) { return a.pixels > b.pixels; });
    blobs.insert(place, blob);
    if (blobs.size() > mostBlobs) blobs.pop_back();
}

} // namespace

Wrong findWrong(std::span<const float> map, uint32_t width, double over) {
    Wrong found;
    Taker taker(map, width, over);
    for (size_t pixel = 0; pixel < map.size(); ++pixel) {
        if (!taker.isWrong(pixel)) continue;
        const Blob blob = taker.take(pixel);
        found.pixels += blob.pixels;
        insert(found.blobs, blob);
    }
    if (!found.blobs.empty()) found.largest = found.blobs.front();
    return found;
}

} // namespace demos
