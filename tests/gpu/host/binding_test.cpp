// Descriptor sets hold what shaders declare, by its number, and nothing else.
#include <span>
#include <vector>

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/pipeline/kernel.h"
#include "gpu/pipeline/spirv_bindings.h"
#include "spirv/bindings.comp.h"
#include "spirv/fill_sample.frag.h"
#include "spirv/fill_sample.vert.h"
#include "spirv/tile_lists.comp.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr VkDescriptorType uniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType buffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType sampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType stored = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

using Words = std::span<const uint32_t>;

struct Expected {
    uint32_t number;
    VkDescriptorType type;
    VkShaderStageFlags stages;
};

void expectBindings(std::span<const Words> modules, const std::vector<Expected>& expected) {
    const std::optional<gpu::ShaderInterface> found = gpu::interfaceOf(modules);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->bindings.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(found->bindings[i].number, expected[i].number);
        EXPECT_EQ(found->bindings[i].type, expected[i].type) << expected[i].number;
        EXPECT_EQ(found->bindings[i].stages, expected[i].stages) << expected[i].number;
    }
}

TEST(ShaderInterface, IsWhatModulesDeclare) {
    constexpr VkShaderStageFlags compute = VK_SHADER_STAGE_COMPUTE_BIT;
    const Words module[] = {bindings_comp};
    expectBindings(
        module, {{1, uniform, compute}, {3, sampled, compute}, {4, stored, compute}, {7, buffer, compute}});
}

TEST(ShaderInterface, IsOfTheStagesThatDeclareIt) {
    const Words modules[] = {fill_sample_vert, fill_sample_frag};
    expectBindings(modules,
                   {{0, sampled, VK_SHADER_STAGE_FRAGMENT_BIT}, {1, sampled, VK_SHADER_STAGE_FRAGMENT_BIT}});
}

TEST(ShaderInterface, IsNoneOfModulesThatDisagree) {
    const Words modules[] = {fill_sample_frag, tile_lists_comp};
    EXPECT_FALSE(gpu::interfaceOf(modules));
}

class Sets : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        ASSERT_EQ(kernel_.create(context()->device, bindings_comp, "four kinds"), Status::ok) << message();
        ASSERT_EQ(words_.create(context()->device, 64,
                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                "words"),
                  Status::ok);
        ASSERT_EQ(image_.create(
                      context()->device,
                      {VK_FORMAT_R32_SFLOAT, {4, 4}, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT},
                      "image"),
                  Status::ok);
    }

    void TearDown() override {
        kernel_ = {};
        words_ = {};
        image_ = {};
        GpuTest::TearDown();
    }

    std::vector<gpu::Bound> all() const {
        return {{7, gpu::storageBuffer(words_.handle())},
                {1, gpu::uniformBuffer(words_.handle(), 0, 16)},
                {3, gpu::sampledImage(context()->samplers.nearestClamp(), image_.view())},
                {4, gpu::storageImage(image_)}};
    }

    Status allocated(const std::vector<gpu::Bound>& resources) {
        VkDescriptorSet set = VK_NULL_HANDLE;
        return context()->frame().allocateSet(kernel_.layout(), resources, set);
    }

    gpu::Kernel kernel_;
    gpu::Buffer words_;
    gpu::OwnedImage image_;
};

TEST_F(Sets, TakeEachResourceByItsNumber) {
    frame([&](VkCommandBuffer) { EXPECT_EQ(allocated(all()), Status::ok) << message(); });
}

TEST_F(Sets, LeaveOutWhatNoShaderDeclares) {
    std::vector<gpu::Bound> more = all();
    more.push_back({2, gpu::storageImage(image_)});
    frame([&](VkCommandBuffer) { EXPECT_EQ(allocated(more), Status::ok) << message(); });
}

TEST_F(Sets, RefuseWhatIsNotAsDeclared) {
    std::vector<gpu::Bound> wrong = all();
    frame([&](VkCommandBuffer) {
        wrong[2].resource = gpu::storageImage(image_);
        EXPECT_MISUSE(allocated(wrong), "four kinds: binding 3 is of descriptor type 3, expected 1",
                      message());
        wrong = all();
        wrong[3].resource.format = VK_FORMAT_R16_SFLOAT;
        EXPECT_MISUSE(allocated(wrong), "four kinds: the image of binding 4 is of format 76, expected 100",
                      message());
        wrong = all();
        wrong[0].number = 2;
        EXPECT_MISUSE(allocated(wrong), "four kinds: binding 7 is bound twice or never", message());
        wrong = all();
        wrong.pop_back();
        EXPECT_MISUSE(allocated(wrong), "four kinds: binding 4 is bound twice or never", message());
        wrong = all();
        wrong.push_back(wrong.back());
        EXPECT_MISUSE(allocated(wrong), "four kinds: binding 4 is bound twice or never", message());
    });
}

} // namespace
