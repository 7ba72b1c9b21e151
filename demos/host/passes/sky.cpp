#include "host/passes/sky.h"

#include <numbers>

#include <glm/gtc/packing.hpp>

#include "host/vulkan/pipeline.h"
#include "spirv/sky.frag.h"
#include "spirv/sky.vert.h"

namespace demos {
namespace {

std::vector<uint64_t> halves(const std::vector<glm::vec3>& colors) {
    std::vector<uint64_t> packed(colors.size());
    for (size_t i = 0; i < colors.size(); ++i)
        packed[i] = glm::packHalf4x16(glm::vec4(glm::min(colors[i], 60000.0f), 1));
    return packed;
}

bool uploadCube(Device& device, const SkyCube& cube, Image& out, Error& error) {
    std::vector<std::vector<uint64_t>> levels;
    std::vector<std::span<const std::byte>> bytes;
    for (const auto& mip : cube.mips) levels.push_back(halves(mip));
    for (const auto& level : levels) bytes.push_back(std::as_bytes(std::span(level)));
    ImageDesc desc;
    desc.format = VK_FORMAT_R16G16B16A16_SFLOAT;
    desc.extent = {cube.faceSize, cube.faceSize};
    desc.mips = static_cast<uint32_t>(cube.mips.size());
    desc.cube = true;
    return createSampledImage(device, desc, bytes, out, error);
}

bool uploadImage(Device& device, const SkyImage& image, Image& out, Error& error) {
    const std::vector<uint64_t> level = halves(image.radiance);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(level));
    ImageDesc desc;
    desc.format = VK_FORMAT_R16G16B16A16_SFLOAT;
    desc.extent = {image.width, image.height};
    return createSampledImage(device, desc, {&bytes, 1}, out, error);
}

} // namespace

bool loadSky(Device& device, const SkyDesc& desc, const SunDesc& sun, Sky& out, Error& error) {
    if (!std::isfinite(desc.rotationDeg) || !(desc.intensity >= 0 && desc.intensity <= 1e6)) {
        error.text = "the sky's rotation must be finite and its intensity 0 to 1e6";
        return false;
    }
    std::optional<SkyImage> image = readSkyImage(desc, error);
    if (!image || !chooseSun(desc, sun, *image, out.sun, error)) return false;
    const SkyLight light = filterSky(*image, desc.rotationDeg, desc.intensity);
    out.irradianceSh = light.irradianceSh;
    out.irradianceUp = light.irradianceUp;
    out.rotationDeg = desc.rotationDeg;
    out.intensity = desc.intensity;
    out.detail = desc.clear ? 0 : desc.detail;
    SamplerDesc around;
    around.u = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    return uploadCube(device, light.cube, out.cube, error) && uploadImage(device, *image, out.image, error) &&
           createSampler(device, {}, out.cubeSampler, error) &&
           createSampler(device, around, out.imageSampler, error);
}

void setSkyUniforms(const Sky& sky, bool detailed, const Camera& camera, VkExtent2D extent,
                    FrameUniforms& uniforms) {
    uniforms.skyRight = glm::vec4(camera.right * camera.tanHalfFovX, 0);
    uniforms.skyUp = glm::vec4(camera.up * camera.tanHalfFovY, 0);
    uniforms.skyForward = glm::vec4(camera.forward, detailed ? sky.detail : 0);
    const double pixel = 2 * camera.tanHalfFovY / extent.height;
    const bool visible = sky.sun.direction.y > 0;
    uniforms.toSun = glm::vec4(sky.sun.direction, visible ? 1 : 0);
    uniforms.sunIrradiance = glm::vec4(sky.sun.irradiance, 0);
    const double soft = softEdgeOfSun(pixel);
    const glm::dvec3 radiance = sky.sun.irradiance / (std::numbers::pi * sunRadius * sunRadius);
    uniforms.sunRadiance = glm::vec4(radiance, soft);
    for (size_t i = 0; i < 9; ++i) uniforms.irradianceSh[i] = glm::vec4(sky.irradianceSh[i], 0);
    uniforms.sky = glm::vec4(std::fmod(sky.rotationDeg / 360, 1.0), sky.intensity, sky.cube.mips - 1,
                             sky.cube.extent.width);
}

bool SkyPass::create(const Device& device, const Layouts& layouts, VkFormat color, VkFormat depth,
                     Error& error) {
    PipelineDesc desc;
    desc.vertex = sky_vert;
    desc.fragment = sky_frag;
    desc.meshVertices = false;
    desc.colorFormat = color;
    desc.depthFormat = depth;
    desc.depthWrite = false;
    return createPipeline(device, layouts.pipeline.get(), desc, pipeline_, error);
}

void SkyPass::draw(VkCommandBuffer commands) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdDraw(commands, 3, 1, 0, 0);
}

} // namespace demos
