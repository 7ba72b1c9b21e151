#include "water/foam_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace seaglass {

namespace {

constexpr uint32_t size = foamPatternSamples;
constexpr VkFormat format = VK_FORMAT_R8_UNORM;

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

} // namespace

std::vector<uint8_t> foamPattern() {
    std::vector<float> raw(size_t{size} * size);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x)
            raw[size_t{y} * size + x] =
                rawPattern(static_cast<float>(x) / size, static_cast<float>(y) / size);
    std::vector<uint32_t> order(raw.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return raw[a] < raw[b]; });
    std::vector<uint8_t> pattern(raw.size());
    for (size_t rank = 0; rank < order.size(); ++rank)
        pattern[order[rank]] = static_cast<uint8_t>(rank * 256 / order.size());
    return pattern;
}

VkDeviceSize FoamPattern::bytes() {
    constexpr VkDeviceSize pattern = VkDeviceSize{size} * size;
    return 2 * pattern; // the image and its staging
}

Status FoamPattern::create(Context& context) {
    gpu::ImageDesc desc;
    desc.format = format;
    desc.extent = {size, size};
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if (const Status s = image_.create(context.device, desc, "foam pattern"); s != Status::ok) return s;
    const std::vector<uint8_t> pattern = foamPattern();
    if (const Status s = staging_.createMapped(context.device, pattern.size(),
                                               VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "foam staging buffer");
        s != Status::ok)
        return s;
    std::memcpy(staging_.mapped(), pattern.data(), pattern.size());
    return Status::ok;
}

void FoamPattern::recordUpload(const gpu::Device& device, VkCommandBuffer commands) {
    if (uploaded_) return;
    uploaded_ = true;
    constexpr gpu::Use nothing{};
    const VkImageMemoryBarrier2 before = gpu::imageBarrier(image_.handle(), nothing, gpu::copyWritten);
    gpu::recordBarriers(device, commands, &before, 1);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {size, size, 1};
    device.vk().CmdCopyBufferToImage(commands, staging_.handle(), image_.handle(),
                                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(image_.handle(), gpu::copyWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
}

} // namespace seaglass
