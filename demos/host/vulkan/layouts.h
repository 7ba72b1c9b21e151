// What the host's shaders see: the frame's uniforms and textures (set 0), a material's textures (set 1) and
// the push constants of one draw.
#pragma once

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "host/vulkan/resources.h"
#include "seaglass/fog.h"

namespace demos {

/// Shadow maps of growing reach, as tiles of one image.
constexpr uint32_t shadowCascades = 4;

/// As in shaders/frame.glsl.
struct FrameUniforms {
    glm::mat4 clipFromEye;
    glm::mat4 shadowFromEye[shadowCascades];
    glm::vec4 skyRight, skyUp, skyForward;
    glm::vec4 toSun;
    glm::vec4 sunIrradiance;
    glm::vec4 sunRadiance;
    glm::vec4 irradianceSh[9];
    glm::vec4 sky;
    glm::vec4 shadowTexelM;
    glm::vec4 shadow;
    glm::vec4 waterPlane, waterAcross, waterAlong, sunShear;
    glm::vec4 sunStrays[2];
    glm::vec4 sight;
    seaglass::FogBlock fog;
    glm::vec4 fogEye, fogSight, fogWater;
    glm::vec4 shorePlace, shoreRows, shoreForm; ///< seaglass::ShoreBlock
    glm::vec4 shoreU, shoreUp, shoreV;
};

/// What follows from eye-relative positions' way to clip space, with reversed depth.
void setClip(const glm::dmat4& clipFromEye, FrameUniforms& uniforms);

/// As in shaders/draw.glsl.
struct DrawConstants {
    glm::vec4 eyeFromMesh[3];
    glm::vec4 baseColor;
    glm::vec4 emissive;
    glm::vec4 surface;
    glm::vec4 specular;
    glm::vec4 maps;
};
static_assert(sizeof(DrawConstants) <= 128, "the least that every device has");

struct Layouts {
    UniqueDescriptorSetLayout frame, material;
    UniquePipelineLayout pipeline;
};

constexpr VkShaderStageFlags drawStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

/// One descriptor of each type, bound in their order.
bool createSetLayout(const Device& device, std::span<const VkDescriptorType> types,
                     UniqueDescriptorSetLayout& out, Error& error, VkShaderStageFlags stages = drawStages);

/// With push constants of `constantBytes` for drawing; 0: none.
bool createPipelineLayout(const Device& device, std::span<const VkDescriptorSetLayout> sets,
                          uint32_t constantBytes, UniquePipelineLayout& out, Error& error);

bool createLayouts(const Device& device, Layouts& out, Error& error);

/// A set from a pool of its own.
bool allocateSet(const Device& device, VkDescriptorSetLayout layout,
                 std::span<const VkDescriptorPoolSize> sizes, UniqueDescriptorPool& pool,
                 VkDescriptorSet& set, Error& error);
/// All of a storage buffer of `size` bytes.
void writeStorageBuffer(const Device& device, VkDescriptorSet set, uint32_t binding, VkBuffer buffer,
                        VkDeviceSize size);
/// All of a uniform buffer of `size` bytes at binding 0.
void writeUniformBuffer(const Device& device, VkDescriptorSet set, VkBuffer buffer, VkDeviceSize size);
/// Points one combined image sampler of a set at an image in SHADER_READ_ONLY_OPTIMAL.
void writeTexture(const Device& device, VkDescriptorSet set, uint32_t binding, VkImageView view,
                  VkSampler sampler);

} // namespace demos
