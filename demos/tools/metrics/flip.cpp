#include "metrics/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "metrics/flip/color_space.h"
#include "metrics/flip/seen.h"

namespace demos {

namespace {

/// The paper's exponents, and the knee that gives its lower 40 % of colour differences 95 % of the range.
constexpr float colorExponent = 0.7f, featureExponent = 0.5f;
constexpr float kneeOfRange = 0.4f, kneeOfError = 0.95f;

/// Columns at once: what the filters keep of two such strips stays in a core's cache.
constexpr size_t stripWidth = 256;

/// HyAB, for large differences of colour (Abasi, Amani Tehran and Fairchild 2020).
float colorDistance(const Lab& a, const Lab& b) {
    const float da = a[1] - b[1], db = a[2] - b[2];
    return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

/// The greatest that sRGB holds: between its green and its blue.
float greatestColorDistance() {
    return colorDistance(huntAdjusted(labOfXyz(xyzOfRgb({0, 1, 0}))),
                         huntAdjusted(labOfXyz(xyzOfRgb({0, 0, 1}))));
}

float colorError(float distance, float greatest) {
    const float error = power(distance, colorExponent), knee = kneeOfRange * greatest;
    return error < knee ? kneeOfError * error / knee
                        : kneeOfError + (1 - kneeOfError) * (error - knee) / (greatest - knee);
}

/// What the compiler takes several pixels of at once: no index leads to another.
struct SeenRow {
    explicit SeenRow(const Seen& seen)
        : lightness(seen.lab()[0].data()), redGreen(seen.lab()[1].data()), blueYellow(seen.lab()[2].data()),
          edges(seen.edges().data()), points(seen.points().data()) {}

    Lab lab(size_t i) const { return {lightness[i], redGreen[i], blueYellow[i]}; }

    const float *lightness, *redGreen, *blueYellow, *edges, *points;
};

void combine(const SeenRow a, const SeenRow b, float greatest, std::vector<float>& to) {
    for (size_t i = 0; i < to.size(); ++i) {
        const float color = colorError(colorDistance(a.lab(i), b.lab(i)), greatest);
        const float edges = std::abs(a.edges[i] - b.edges[i]);
        const float points = std::abs(a.points[i] - b.points[i]);
        const float feature =
            power(std::max(edges, points) * (1 / std::numbers::sqrt2_v<float>), featureExponent);
        to[i] = power(color, 1 - std::min(feature, 1.0f));
    }
}

/// Of two pictures as far as a strip is filtered from.
class Sameness {
  public:
    Sameness(const PixelView& a, const PixelView& b, const Strip& strip, size_t radius)
        : a_(a), b_(b), first_(strip.left - std::min(strip.left, radius)),
          count_(std::min<size_t>(strip.left + strip.width + radius, a.width) - first_), radius_(radius) {}

    /// Whether all that row y is filtered from is the same. Rows are asked for from the top.
    bool around(size_t y) {
        for (; next_ < std::min<size_t>(y + radius_ + 1, a_.height); ++next_) {
            const size_t at = 4 * (next_ * a_.width + first_);
            if (std::memcmp(&a_.rgba[at], &b_.rgba[at], 4 * count_ * sizeof(float)) != 0)
                changedUntil_ = next_ + radius_ + 1;
        }
        return y >= changedUntil_;
    }

  private:
    const PixelView &a_, &b_;
    size_t first_, count_, radius_, next_ = 0;
    size_t changedUntil_ = 0; ///< the row below what is filtered from rows that differ
};

void flipOfStrip(const PixelView& reference, const PixelView& test, const Strip& strip, const EyeFilters& eye,
                 const ToLight& toLight, std::vector<float>& map) {
    const float greatest = std::pow(greatestColorDistance(), colorExponent);
    Seen a({reference, strip.left, strip.width}, eye, toLight),
        b({test, strip.left, strip.width}, eye, toLight);
    Sameness same(reference, test, strip, eye.radius);
    std::vector<float> row(a.edges().size());
    for (size_t y = 0; y < reference.height; ++y) {
        if (same.around(y)) continue;
        a.goTo(y);
        b.goTo(y);
        combine(SeenRow(a), SeenRow(b), greatest, row);
        std::copy_n(row.begin(), strip.width,
                    map.begin() + static_cast<std::ptrdiff_t>(y * reference.width + strip.left));
    }
}

/// Almost all values are one of a byte's, of which the light is known.
class SrgbTable {
  public:
    SrgbTable() {
        for (size_t step = 0; step < steps; ++step) {
            encoded_[step] = static_cast<float>(step) / (steps - 1);
            light_[step] = decodeSrgb(encoded_[step]);
        }
    }

    void decode(std::vector<float>& row) const {
        for (float& value : row) {
            const float inside = std::max(0.0f, std::min(value, 1.0f)); // 0 of NaN: no place in the table
            const auto step = static_cast<size_t>(static_cast<int>(inside * (steps - 1) + 0.5f));
            value = encoded_[step] == inside ? light_[step] : decodeSrgb(inside);
        }
    }

  private:
    static constexpr size_t steps = 256;

    std::array<float, steps> encoded_, light_;
};

} // namespace

std::vector<float> flipOf(const PixelView& reference, const PixelView& test, const ToLight& toLight,
                          float pixelsPerDegree) {
    const EyeFilters eye(pixelsPerDegree);
    std::vector<float> map(reference.pixels());
    for (size_t left = 0; left < reference.width; left += stripWidth) {
        const Strip strip{reference, left, std::min(stripWidth, reference.width - left)};
        flipOfStrip(reference, test, strip, eye, toLight, map);
    }
    return map;
}

std::vector<float> flip(const PixelView& reference, const PixelView& test, float pixelsPerDegree) {
    const SrgbTable table;
    return flipOf(
        reference, test, [&table](std::vector<float>& row) { table.decode(row); }, pixelsPerDegree);
}

} // namespace demos
