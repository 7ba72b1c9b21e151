// Light that strays in the host's lens, of pictures that no scene gives.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "host/lens/bloom.h"
#include "host/vulkan/rendering.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace demos;

constexpr VkExtent2D extent = {64, 36};
constexpr VkOffset2D broken = {21, 17};

void clear(VkCommandBuffer commands, const VkRect2D& where, float light) {
    VkClearAttachment attachment{VK_IMAGE_ASPECT_COLOR_BIT, 0, {}};
    attachment.clearValue.color = {{light, light, light, 1}};
    const VkClearRect rect = {where, 0, 1};
    vkCmdClearAttachments(commands, 1, &attachment, 1, &rect);
}

TEST(Bloom, LeavesWhatIsBrokenWhereItIs) {
    Device& device = tests::device();
    Error error;
    FrameTargets targets;
    Bloom bloom;
    ASSERT_TRUE(createFrameTargets(device, extent, targets, error) && bloom.fit(device, targets, error))
        << error.text;
    for (const float light :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        const auto record = [&](VkCommandBuffer commands, Error&) {
            targets.colorToAttachment(commands, VK_IMAGE_LAYOUT_UNDEFINED);
            beginRendering(commands, extent, targets.color.view.get(), VK_ATTACHMENT_LOAD_OP_CLEAR,
                           VK_NULL_HANDLE, VK_ATTACHMENT_LOAD_OP_DONT_CARE, 0);
            clear(commands, {{0, 0}, extent}, 0.5f);
            clear(commands, {broken, {1, 1}}, light);
            vkCmdEndRendering(commands);
            bloom.record(commands, targets);
            targets.copyBack(commands, targets.color);
            return true;
        };
        ASSERT_TRUE(device.run(record, error)) << error.text;
        const Picture picture = readColor(targets);
        for (uint32_t y = 0; y < extent.height; ++y)
            for (uint32_t x = 0; x < extent.width; ++x) {
                if (x == uint32_t(broken.x) && y == uint32_t(broken.y)) continue;
                // What is broken shines on nothing.
                EXPECT_NEAR(picture.rgba[(size_t{y} * extent.width + x) * 4], 0.5, 0.01) << x << ", " << y;
            }
    }
    EXPECT_EQ(device.validationMessages(), 0u);
}

} // namespace
