// Functions of shaders that no picture shows alone: a shader calls them for each of what it is given.
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "gpu/context.h"
#include "gpu/pipeline/kernel.h"
#include "tests/gpu/rig/rig.h"

namespace tests {

class ShaderFunctions : public GpuTest {
  protected:
    /// What a shader tells of each that it is given, at bindings 1 and 0.
    template<class Given>
    std::vector<glm::vec4> told(std::span<const uint32_t> shader, const std::vector<Given>& given) {
        using namespace seaglass;
        constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        const gpu::Device& device = context()->device;
        std::vector<glm::vec4> out(given.size());
        gpu::Kernel kernel;
        gpu::Buffer in, left;
        EXPECT_EQ(kernel.create(device, shader, "functions"), Status::ok) << message();
        EXPECT_EQ(in.createMapped(device, given.size() * sizeof(Given), usage, "given"), Status::ok)
            << message();
        EXPECT_EQ(left.createMapped(device, out.size() * sizeof out[0], usage, "told"), Status::ok)
            << message();
        std::memcpy(in.mapped(), given.data(), given.size() * sizeof(Given));
        frame([&](VkCommandBuffer commands) {
            const gpu::Bound resources[] = {{0, gpu::storageBuffer(in.handle())},
                                            {1, gpu::storageBuffer(left.handle())}};
            VkDescriptorSet set = VK_NULL_HANDLE;
            EXPECT_EQ(context()->frame().allocateSet(kernel.layout(), resources, set), Status::ok)
                << message();
            kernel.dispatchAlong(commands, set, static_cast<uint32_t>(given.size()));
            gpu::recordBarrier(device, commands,
                               {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                               {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
        });
        std::memcpy(out.data(), left.mapped(), out.size() * sizeof out[0]);
        return out;
    }
};

} // namespace tests
