#include "water/foam/foam_pattern.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

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

/// Distance to the nearest and second nearest of one jittered point a cell (Worley 1996), `cells` cells to
/// the tile.
struct Cells {
    float nearest;
    float second;
};

Cells worley(float x, float y, uint32_t cells, uint32_t salt) {
    const float fx = x * static_cast<float>(cells);
    const float fy = y * static_cast<float>(cells);
    const int ix = static_cast<int>(std::floor(fx));
    const int iy = static_cast<int>(std::floor(fy));
    Cells result{9, 9};
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const uint32_t cx = static_cast<uint32_t>(ix + dx + static_cast<int>(cells)) % cells;
            const uint32_t cy = static_cast<uint32_t>(iy + dy + static_cast<int>(cells)) % cells;
            const float px = static_cast<float>(ix + dx) + unit(cx, cy, salt) - fx;
            const float py = static_cast<float>(iy + dy) + unit(cx, cy, salt + 1) - fy;
            const float d = std::sqrt(px * px + py * py);
            if (d < result.nearest)
                result = {d, result.nearest};
            else
                result.second = std::min(result.second, d);
        }
    return result;
}

/// Smooth noise of `cells` cells to the tile, 0..1.
float noise(float x, float y, uint32_t cells, uint32_t salt) {
    const float fx = x * static_cast<float>(cells);
    const float fy = y * static_cast<float>(cells);
    const float x0 = std::floor(fx), y0 = std::floor(fy);
    const auto at = [&](int dx, int dy) {
        const auto wrapped = [cells](float i, int d) {
            return static_cast<uint32_t>(static_cast<int>(i) + d + static_cast<int>(cells)) % cells;
        };
        return unit(wrapped(x0, dx), wrapped(y0, dy), salt);
    };
    const auto ease = [](float t) { return t * t * (3 - 2 * t); };
    const float tx = ease(fx - x0), ty = ease(fy - y0);
    return std::lerp(std::lerp(at(0, 0), at(1, 0), tx), std::lerp(at(0, 1), at(1, 1), tx), ty);
}

/// Small where foam goes last: on the walls between bubbles, in patches. Walls are bent, as currents bend
/// them.
float rawPattern(float x, float y) {
    const float bentX = x + 0.05f * (noise(x, y, 6, 101) - 0.5f) + 0.025f * (noise(x, y, 13, 103) - 0.5f);
    const float bentY = y + 0.05f * (noise(x, y, 6, 102) - 0.5f) + 0.025f * (noise(x, y, 13, 104) - 0.5f);
    float value = 0.9f * noise(x, y, 4, 55) + 0.5f * noise(x, y, 9, 56);
    float weight = 1;
    for (const uint32_t cells : {7u, 13u, 25u, 49u}) {
        const Cells c = worley(bentX, bentY, cells, cells * 7919u);
        value += weight * (c.second - c.nearest);
        weight *= 0.62f;
    }
    return value;
}

float bendAt(float x, float y) {
    return noise(x, y, 5, 201) + 0.6f * noise(x, y, 11, 202) + 0.35f * noise(x, y, 23, 203) +
           0.2f * noise(x, y, 47, 204);
}

template<typename At>
std::vector<float> mapOf(At&& at) {
    std::vector<float> map(size_t{size} * size);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x)
            map[size_t{y} * size + x] = at(static_cast<float>(x) / size, static_cast<float>(y) / size);
    return map;
}

/// Each value's place among all, 0..1.
std::vector<float> evenly(const std::vector<float>& map) {
    std::vector<uint32_t> order(map.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return map[a] < map[b]; });
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
    const std::vector<float> pattern = evenly(mapOf(rawPattern)), bend = evenly(mapOf(bendAt));
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

VkDeviceSize FoamPattern::bytes(const gpu::Device& device) {
    return FixedImage::bytes(device, imageDesc());
}

Status FoamPattern::create(Context& context) {
    // The same for all bodies, and worked out by the first: it takes longer than all else that a body is made
    // of.
    static const std::vector<std::vector<FoamTexel>> pattern = foamPattern();
    if (const Status s = image_.create(context, imageDesc(), "foam pattern"); s != Status::ok) return s;
    std::byte* out = image_.texels();
    for (const std::vector<FoamTexel>& mip : pattern) {
        std::memcpy(out, mip.data(), mip.size() * sizeof(FoamTexel));
        out += mip.size() * sizeof(FoamTexel);
    }
    return Status::ok;
}

} // namespace seaglass
