#include "host/water/wet_sand.h"

#include <glm/gtc/type_ptr.hpp>

#include "seaglass/shore.h"

namespace demos {

namespace {

constexpr double dryingTimeS = 45;

} // namespace

bool WetSand::create(Device& device, const seaglass::Sea* sea, Error& error) {
    const uint32_t rows = sea ? seaglass::shoreRowCount(*sea, dryingTimeS) : 0;
    if (rows == 0) return true;
    ImageDesc desc;
    desc.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    uint32_t samples[2];
    seaglass::shoreSamples(*sea, samples);
    desc.extent = {samples[0], samples[1]};
    std::vector<float> texels(size_t{4} * samples[0] * samples[1]);
    seaglass::shoreTexels(*sea, texels.data());
    const std::span<const std::byte> level = std::as_bytes(std::span(texels));
    if (!createSampledImage(device, desc, {&level, 1}, map_, error) ||
        !createSampler(device, {}, sampler_, error) ||
        !createBuffer(device, size_t{4} * sizeof(float) * rows, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                      BufferPlace::upload, rows_, error))
        return false;
    sea_ = sea;
    return true;
}

void WetSand::set(double timeS, const BentSun& sun, const glm::dvec3& eye, FrameUniforms& uniforms) const {
    const double place[2] = {glm::dot(sun.across, eye), glm::dot(sun.along, eye)};
    const seaglass::ShoreBlock block =
        seaglass::shoreRows(*sea_, timeS, dryingTimeS, place, static_cast<float*>(rows_.mapped));
    uniforms.shorePlace = glm::make_vec4(block.place);
    uniforms.shoreRows = glm::make_vec4(block.rows);
    uniforms.shoreForm = glm::make_vec4(block.form);
    uniforms.shoreU = glm::vec4(glm::vec3(sun.across), 0);
    uniforms.shoreUp = glm::vec4(glm::dvec4(sun.normal, -sun.depthOf(eye)));
    uniforms.shoreV = glm::vec4(glm::vec3(sun.along), 0);
}

void WetSand::write(const Device& device, VkDescriptorSet frame) const {
    writeTexture(device, frame, 5, map_.view.get(), sampler_.get());
    writeStorageBuffer(device, frame, 6, rows_.buffer.get(), rows_.size);
}

void moveShoreUniforms(const glm::dvec3& step, FrameUniforms& uniforms) {
    for (glm::vec4* const axis : {&uniforms.shoreU, &uniforms.shoreUp, &uniforms.shoreV})
        axis->w += static_cast<float>(glm::dot(glm::dvec3(*axis), step));
}

} // namespace demos
