#include "tests/gpu/rig/overlay_target.h"

#include <gtest/gtest.h>

#include "tests/gpu/rig/rig.h"

namespace tests {

demos::Image overlayTarget(VkExtent2D extent) {
    demos::ImageDesc desc;
    desc.format = VK_FORMAT_R16G16B16A16_SFLOAT;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createImage(device(), desc, image, error)) << error.text;
    return image;
}

seaglass::Image described(const demos::Image& image) {
    return {image.view.get(), image.format, image.extent, VK_IMAGE_LAYOUT_GENERAL};
}

void toGeneral(VkCommandBuffer commands, const demos::Image& image) {
    demos::imageBarrier(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL,
                        VK_PIPELINE_STAGE_2_NONE, 0, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                        VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void toSampled(VkCommandBuffer commands, const demos::Image& image) {
    demos::imageBarrier(commands, image, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                        VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                        VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT);
}

} // namespace tests
