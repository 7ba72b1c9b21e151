#include "water/foam/foam_pattern.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace seaglass {

namespace {

constexpr uint32_t size = foamPatternSamples;
constexpr uint32_t mipLevels = std::bit_width(size);

gpu::ImageDesc imageDesc() {
    gpu::ImageDesc desc;
    desc.format = VK_FORMAT_R8G8B8A8_UNORM;
    desc.extent = {size, size};
    desc.mipLevels = mipLevels;
    return desc;
}

// Integer hash with good avalanche (Wellons, "lowbias32").
uint32_t hash(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ (x >> 16);
}

float unit(uint32_t x, uint32_t y, uint32_t salt) {
    return static_cast<float>(hash(x + hash(y + hash(salt))) >> 8) * 0x1p-24f;
}

/// Random numbers, 0..1, at the corners of `cells` x `cells` cells that tile.
class Lattice {
  public:
    Lattice(uint32_t cells, uint32_t salt);
    /// From `-cells` on.
    float at(int x, int y) const { return values_[static_cast<size_t>(wrapped(y) * cells_ + wrapped(x))]; }
    float cells() const { return static_cast<float>(cells_); }

  private:
    int wrapped(int i) const { return (i + cells_) % cells_; }

    int cells_;
    std::vector<float> values_;
};

Lattice::Lattice(uint32_t cells, uint32_t salt)
    : cells_(static_cast<int>(cells)), values_(size_t{cells} * cells) {
    for (uint32_t y = 0; y < cells; ++y)
        for (uint32_t x = 0; x < cells; ++x) values_[size_t{y} * cells + x] = unit(x, y, salt);
}

/// Walls between bubbles, around one jittered point a cell: 0 on a wall (Worley 1996).
class Bubbles {
  public:
    explicit Bubbles(uint32_t cells) : pointX_(cells, cells * 7919u), pointY_(cells, cells * 7919u + 1) {}

    /// How much farther the second nearest point is than the nearest, in cells.
    float operator()(float x, float y) const;

  private:
    Lattice pointX_, pointY_;
};

float Bubbles::operator()(float x, float y) const {
    const float fx = x * pointX_.cells(), fy = y * pointX_.cells();
    const int ix = static_cast<int>(std::floor(fx)), iy = static_cast<int>(std::floor(fy));
    float nearest = 81, second = 81; // squared
    for (int cy = iy - 1; cy <= iy + 1; ++cy)
        for (int cx = ix - 1; cx <= ix + 1; ++cx) {
            const float px = static_cast<float>(cx) + pointX_.at(cx, cy) - fx;
            const float py = static_cast<float>(cy) + pointY_.at(cx, cy) - fy;
            const float squared = px * px + py * py;
            second = std::min(second, std::max(nearest, squared));
            nearest = std::min(nearest, squared);
        }
    return std::sqrt(second) - std::sqrt(nearest);
}

/// Smooth noise, 0..1.
class Noise {
  public:
    Noise(uint32_t cells, uint32_t salt) : corners_(cells, salt) {}

    float operator()(float x, float y) const;

  private:
    static float eased(float t) { return t * t * (3 - 2 * t); }

    Lattice corners_;
};

float Noise::operator()(float x, float y) const {
    const float fx = x * corners_.cells(), fy = y * corners_.cells();
    const float x0 = std::floor(fx), y0 = std::floor(fy);
    const int ix = static_cast<int>(x0), iy = static_cast<int>(y0);
    const float tx = eased(fx - x0), ty = eased(fy - y0);
    return std::lerp(std::lerp(corners_.at(ix, iy), corners_.at(ix + 1, iy), tx),
                     std::lerp(corners_.at(ix, iy + 1), corners_.at(ix + 1, iy + 1), tx), ty);
}

/// Small where foam goes last: on the walls between bubbles, in patches. Walls are bent, as currents bend
/// them.
class Rafts {
  public:
    float operator()(float x, float y) const {
        const float bentX = x + 0.05f * (bendX_(x, y) - 0.5f) + 0.025f * (finerBendX_(x, y) - 0.5f);
        const float bentY = y + 0.05f * (bendY_(x, y) - 0.5f) + 0.025f * (finerBendY_(x, y) - 0.5f);
        float value = 0.9f * patches_(x, y) + 0.5f * finerPatches_(x, y);
        float weight = 1;
        for (const Bubbles& bubbles : bubbles_) {
            value += weight * bubbles(bentX, bentY);
            weight *= 0.62f;
        }
        return value;
    }

  private:
    Noise bendX_{6, 101}, bendY_{6, 102}, finerBendX_{13, 103}, finerBendY_{13, 104};
    Noise patches_{4, 55}, finerPatches_{9, 56};
    Bubbles bubbles_[4] = {Bubbles(7), Bubbles(13), Bubbles(25), Bubbles(49)};
};

/// Bends the edge of what is foamy.
class EdgeBend {
  public:
    float operator()(float x, float y) const {
        return octaves_[0](x, y) + 0.6f * octaves_[1](x, y) + 0.35f * octaves_[2](x, y) +
               0.2f * octaves_[3](x, y);
    }

  private:
    Noise octaves_[4] = {{5, 201}, {11, 202}, {23, 203}, {47, 204}};
};

template<typename At>
std::vector<float> mapOf(const At& at) {
    std::vector<float> map(size_t{size} * size);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x)
            map[size_t{y} * size + x] = at(static_cast<float>(x) / size, static_cast<float>(y) / size);
    return map;
}

/// Places of values of 0 or more, from the least on; of equals the first comes first. Such floats order as
/// their bits do, which are sorted by halves.
std::vector<uint32_t> ranked(const std::vector<float>& map) {
    std::vector<uint32_t> order(map.size()), next(map.size());
    for (uint32_t place = 0; place < order.size(); ++place) order[place] = place;
    for (const uint32_t shift : {0u, 16u}) {
        const auto half = [&](uint32_t place) {
            return std::bit_cast<uint32_t>(map[place]) >> shift & 0xffffu;
        };
        std::vector<uint32_t> begins(0x10001);
        for (const uint32_t place : order) ++begins[half(place) + 1];
        for (size_t i = 1; i < begins.size(); ++i) begins[i] += begins[i - 1];
        for (const uint32_t place : order) next[begins[half(place)]++] = place;
        order.swap(next);
    }
    return order;
}

/// Each value's place among all, 0..1.
std::vector<float> evenly(const std::vector<float>& map) {
    const std::vector<uint32_t> order = ranked(map);
    std::vector<float> even(map.size());
    for (size_t rank = 0; rank < order.size(); ++rank)
        even[order[rank]] = static_cast<float>(rank) / static_cast<float>(order.size());
    return even;
}

uint8_t asByte(float share) {
    return static_cast<uint8_t>(std::clamp(share * 256, 0.0f, 255.0f));
}

/// Of a difference over two texels.
uint8_t slopeByte(float difference) {
    return asByte(0.5f + 0.25f * difference / foamReliefStep);
}

/// A channel of a mip, in bytes' units, rows along u.
using Channel = std::vector<float>;

/// Means of 2 x 2.
Channel halved(const Channel& texels, uint32_t across) {
    const uint32_t half = across / 2;
    Channel out(size_t{half} * half);
    for (size_t y = 0; y < half; ++y)
        for (size_t x = 0; x < half; ++x) {
            const float* const above = &texels[2 * y * across + 2 * x];
            out[y * half + x] = (above[0] + above[1] + above[across] + above[across + 1]) / 4;
        }
    return out;
}

/// Deviation of what a linear filter finds anywhere on a tile of these.
float deviationBetween(const Channel& texels, uint32_t across) {
    constexpr double kernel[] = {1 / 6.0, 2 / 3.0, 1 / 6.0}; // how often two texels' weights meet
    double variance = 0;
    for (uint32_t y = 0; y < across; ++y)
        for (uint32_t x = 0; x < across; ++x) {
            double around = 0;
            for (uint32_t j = 0; j < 3; ++j)
                for (uint32_t i = 0; i < 3; ++i)
                    around += kernel[j] * kernel[i] *
                              double{texels[size_t{(y + across + j - 1) % across} * across +
                                            (x + across + i - 1) % across]};
            variance += around * double{texels[size_t{y} * across + x]};
        }
    return static_cast<float>(std::sqrt(variance / static_cast<double>(texels.size())));
}

/// What is left of the pattern's contrast where a texel is as wide as so many of the finest;
/// shaders/water/foam/foam_cover.glsl relies on it.
float keptContrast(uint32_t texels) {
    return 30 / (29.15f + static_cast<float>(texels));
}

/// The pattern as one that is even again, -0.5..0.5 times its contrast: means alone bunch in the middle and
/// to one side, and would draw thin foam too often.
Channel evenAgain(const Channel& means, uint32_t across) {
    Channel even = evenly(means);
    for (float& share : even) share += 0.5f / static_cast<float>(even.size()) - 0.5f;
    const float wanted = keptContrast(size / across) / std::sqrt(12.0f),
                found = deviationBetween(even, across);
    for (float& share : even) share *= found > 0 ? wanted / found : 0;
    return even;
}

uint8_t roundedByte(float value) {
    return static_cast<uint8_t>(std::clamp(value + 0.5f, 0.0f, 255.0f));
}

Channel channelOf(const std::vector<FoamTexel>& texels, uint8_t FoamTexel::*channel) {
    Channel out(texels.size());
    for (size_t i = 0; i < texels.size(); ++i) out[i] = static_cast<float>(texels[i].*channel);
    return out;
}

} // namespace

std::vector<std::vector<FoamTexel>> foamPattern() {
    const std::vector<float> pattern = evenly(mapOf(Rafts())), bend = evenly(mapOf(EdgeBend()));
    std::vector<FoamTexel> texels(pattern.size());
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const auto at = [&](uint32_t i, uint32_t j) {
                return pattern[size_t{j % size} * size + i % size];
            };
            FoamTexel& texel = texels[size_t{y} * size + x];
            texel.pattern = asByte(at(x, y));
            texel.bend = asByte(bend[size_t{y} * size + x]);
            // Foam is thickest where it goes last, at the least of the pattern.
            texel.slopeU = slopeByte(at(x + size - 1, y) - at(x + 1, y));
            texel.slopeV = slopeByte(at(x, y + size - 1) - at(x, y + 1));
        }
    constexpr uint8_t FoamTexel::*members[] = {&FoamTexel::pattern, &FoamTexel::bend, &FoamTexel::slopeU,
                                               &FoamTexel::slopeV};
    std::array<Channel, 4> means;
    for (size_t c = 0; c < means.size(); ++c) means[c] = channelOf(texels, members[c]);
    std::vector<std::vector<FoamTexel>> mips{std::move(texels)};
    for (uint32_t across = size / 2; across > 0; across /= 2) {
        for (Channel& channel : means) channel = halved(channel, 2 * across);
        std::vector<FoamTexel>& mip = mips.emplace_back(size_t{across} * across);
        for (size_t c = 0; c < means.size(); ++c)
            for (size_t i = 0; i < mip.size(); ++i) mip[i].*members[c] = roundedByte(means[c][i]);
        const Channel even = evenAgain(means[0], across);
        for (size_t i = 0; i < mip.size(); ++i) mip[i].pattern = roundedByte(127.5f + 255 * even[i]);
    }
    return mips;
}

Status FoamPattern::create(Context& context) {
    if (const Status s = image_.create(context, imageDesc(), "foam pattern"); s != Status::ok) return s;
    std::byte* out = image_.texels();
    for (const std::vector<FoamTexel>& mip : foamPattern()) {
        std::memcpy(out, mip.data(), mip.size() * sizeof(FoamTexel));
        out += mip.size() * sizeof(FoamTexel);
    }
    return Status::ok;
}

} // namespace seaglass
