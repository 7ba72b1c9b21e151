#include "host/lens/bloom.h"

#include "spirv/bloom.frag.h"

namespace demos {

namespace {

/// Of all light: what good lenses and eyes let stray.
constexpr float strays = 0.02f;
/// Of what strays that far, what strays farther still.
constexpr float farther = 0.6f;
constexpr uint32_t leastHeight = 6; ///< of a level [pixel]

void draw(const PicturePass& pass, VkCommandBuffer commands, VkDescriptorSet from, VkExtent2D fromExtent,
          const Image& to, float reachTexels, float share) {
    const BloomConstants constants = {
        {1.0f / static_cast<float>(to.extent.width), 1.0f / static_cast<float>(to.extent.height)},
        {reachTexels / static_cast<float>(fromExtent.width),
         reachTexels / static_cast<float>(fromExtent.height)},
        share};
    pass.record(commands, to, from, &constants);
}

} // namespace

bool Bloom::fit(const Device& device, const FrameTargets& targets, Error& error) {
    if (!levels_.empty()) return true;
    if (!larger_.exists() && (!smaller_.create(device, bloom_frag, 1, sizeof(BloomConstants), false, error) ||
                              !larger_.create(device, bloom_frag, 1, sizeof(BloomConstants), true, error)))
        return false;
    VkExtent2D extent = targets.extent;
    VkImageView source = targets.color.view.get();
    do {
        extent = {(extent.width + 1) / 2, (extent.height + 1) / 2};
        Level& level = levels_.emplace_back();
        if (!createPicture(device, extent, level.image, error) ||
            !smaller_.allocate(device, {&level.image.view.get(), 1}, level.pool, level.set, error) ||
            !smaller_.allocate(device, {&source, 1}, level.sourcePool, level.sourceSet, error)) {
            levels_.clear();
            return false;
        }
        source = level.image.view.get();
    } while (extent.height >= 2 * leastHeight);
    return true;
}

void Bloom::record(VkCommandBuffer commands, const FrameTargets& targets) const {
    drawnToRead(commands, targets.color);
    VkExtent2D from = targets.extent;
    for (const Level& level : levels_) {
        readToDrawn(commands, level.image, VK_IMAGE_LAYOUT_UNDEFINED);
        draw(smaller_, commands, level.sourceSet, from, level.image, 1, 1);
        drawnToRead(commands, level.image);
        from = level.image.extent;
    }
    for (size_t i = levels_.size() - 1; i > 0; --i) {
        const Level &smaller = levels_[i], &larger = levels_[i - 1];
        readToDrawn(commands, larger.image);
        draw(larger_, commands, smaller.set, smaller.image.extent, larger.image, 0.5f, farther);
        drawnToRead(commands, larger.image);
    }
    readToDrawn(commands, targets.color);
    draw(larger_, commands, levels_[0].set, levels_[0].image.extent, targets.color, 0.5f, strays);
}

} // namespace demos
