// Each kind of violation, planted in a shader, is noted under the layer, and what is just short of it is not.
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "demos/host/vulkan/pipeline.h"
#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/pipeline/kernel.h"
#include "spirv/planted.comp.h"
#include "spirv/planted.frag.h"
#include "spirv/planted.vert.h"
#include "tests/program/run.h"

namespace {

using namespace seaglass;

using ViolationsByFunction = std::map<std::string, std::set<std::string>>;

ViolationsByFunction parse(const std::string& report) {
    ViolationsByFunction found;
    const std::regex line("violation: ([^:]+): [a-z]+ shader, (\\w+)\\(\\).*");
    std::istringstream lines(report);
    std::smatch match;
    for (std::string text; std::getline(lines, text);)
        if (std::regex_match(text, match, line)) found[match[2]].insert(match[1]);
    return found;
}

/// On a device of its own under the layer: what was noted when it is gone.
class Planted : public testing::Test {
  protected:
    Planted() {
        setenv("VK_ADD_LAYER_PATH", SEAGLASS_LAYERS, 1);
        setenv("VK_INSTANCE_LAYERS", "VK_LAYER_SEAGLASS_checked_shaders", 1);
        setenv("SEAGLASS_VIOLATIONS", report_.c_str(), 1);
        demos::HostDesc desc;
        // Hears of what the layer writes, too: it stands between.
        desc.validation = true;
        device_ = demos::Device::create(desc, error_);
    }
    void SetUp() override { ASSERT_TRUE(device_) << error_.text; }

    ViolationsByFunction violations() {
        EXPECT_EQ(device_->validationMessages(), 0u);
        device_.reset();
        const std::string text = tests::readAll(report_);
        EXPECT_NE(text.find("left 0 shaders alone"), std::string::npos) << text;
        return parse(text);
    }

    void compute(bool violating);
    void draw(float number);

    tests::TemporaryFolder folder_;
    const std::filesystem::path report_ = folder_.path() / "report";
    std::unique_ptr<demos::Device> device_;
    demos::Error error_;
};

void Planted::compute(bool violating) {
    DeviceDesc desc;
    desc.instance = device_->instance();
    desc.physicalDevice = device_->physical();
    desc.device = device_->handle();
    desc.getInstanceProcAddr = vkGetInstanceProcAddr;
    Context* made = nullptr;
    ASSERT_EQ(createContext(&desc, &made), Status::ok);
    const std::unique_ptr<Context, void (*)(Context*)> context(made, destroyContext);
    ASSERT_EQ(beginFrame(made, 0), Status::ok);

    // `violate`, `sum`, and eight floats.
    constexpr VkDeviceSize bytes = 10 * sizeof(float);
    gpu::Buffer words;
    ASSERT_EQ(words.createMapped(made->device, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "words"),
              Status::ok);
    std::memset(words.mapped(), 0, bytes);
    *static_cast<uint32_t*>(words.mapped()) = violating;
    gpu::OwnedImage sampled, stored, counted;
    ASSERT_EQ(sampled.create(made->device, {VK_FORMAT_R32_SFLOAT, {4, 4}, VK_IMAGE_USAGE_SAMPLED_BIT, 2},
                             "sampled"),
              Status::ok);
    ASSERT_EQ(
        stored.create(made->device, {VK_FORMAT_R32_SFLOAT, {4, 4}, VK_IMAGE_USAGE_STORAGE_BIT}, "stored"),
        Status::ok);
    ASSERT_EQ(
        counted.create(made->device, {VK_FORMAT_R32_UINT, {4, 4}, VK_IMAGE_USAGE_STORAGE_BIT}, "counted"),
        Status::ok);
    gpu::Kernel kernel;
    ASSERT_EQ(kernel.create(made->device, planted_comp, "planted"), Status::ok);
    const auto record = [&](VkCommandBuffer commands, demos::Error&) {
        const VkImageMemoryBarrier2 barriers[] = {
            gpu::imageBarrier(sampled.handle(), {}, gpu::sampledByShaders),
            gpu::imageBarrier(stored.handle(), {}, gpu::storageChanged),
            gpu::imageBarrier(counted.handle(), {}, gpu::storageChanged)};
        gpu::recordBarriers(made->device, commands, barriers, 3);
        const gpu::Bound resources[] = {
            {0, gpu::storageBuffer(words.handle())},
            {1, gpu::sampledImage(made->samplers.nearestClamp(), sampled.view())},
            {2, gpu::storageImage(stored)},
            {3, gpu::storageImage(counted)},
        };
        VkDescriptorSet set = VK_NULL_HANDLE;
        if (made->frame().allocateSet(kernel.layout(), resources, set) != Status::ok) return false;
        kernel.dispatch(commands, set, 1, 1);
        return true;
    };
    ASSERT_TRUE(device_->run(record, error_)) << error_.text;
}

/// 16 x 16 pixels and no attachment.
void Planted::draw(float number) {
    constexpr VkShaderStageFlags stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
    const VkPushConstantRange range{stages, 0, sizeof number};
    VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layoutInfo.pushConstantRangeCount = 1;
    layoutInfo.pPushConstantRanges = &range;
    VkPipelineLayout made = VK_NULL_HANDLE;
    ASSERT_EQ(vkCreatePipelineLayout(device_->handle(), &layoutInfo, nullptr, &made), VK_SUCCESS);
    const demos::UniquePipelineLayout layout(device_->handle(), made);
    demos::PipelineDesc desc;
    desc.vertex = planted_vert;
    desc.fragment = planted_frag;
    desc.meshVertices = false;
    demos::UniquePipeline pipeline;
    ASSERT_TRUE(demos::createPipeline(*device_, layout.get(), desc, pipeline, error_)) << error_.text;
    const auto record = [&](VkCommandBuffer commands, demos::Error&) {
        VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
        rendering.renderArea.extent = {16, 16};
        rendering.layerCount = 1;
        vkCmdBeginRendering(commands, &rendering);
        const VkViewport viewport{0, 0, 16, 16, 0, 1};
        vkCmdSetViewport(commands, 0, 1, &viewport);
        vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
        vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
        vkCmdSetFrontFace(commands, VK_FRONT_FACE_CLOCKWISE);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
        vkCmdPushConstants(commands, layout.get(), stages, 0, sizeof number, &number);
        vkCmdDraw(commands, 3, 1, 0, 0);
        vkCmdEndRendering(commands);
        return true;
    };
    ASSERT_TRUE(device_->run(record, error_)) << error_.text;
}

const char* const toInt = "a float beyond the range of int, or NaN, is made one";
const char* const toUint = "a float beyond the range of uint, or NaN, is made one";
const char* const angle = "sin, cos or tan is of an angle beyond pi, or NaN";
const char* const arc = "asin or acos is of more than 1, or NaN";
const char* const power = "pow is of a negative base, NaN, or zero to the power of zero or less";
const char* const logarithm = "log is of zero, a negative number or NaN";
const char* const chosen = "min, max or step is given NaN";
const char* const limits = "clamp has limits in the wrong order";
const char* const index = "an index is beyond its array or vector";
const char* const texel = "a texel outside its image is read or written";
const char* const sample = "an image is sampled at NaN or infinity";

const ViolationsByFunction plantedInCompute = {
    {"intOfMuch", {toInt}},
    {"intOfLittle", {toInt}},
    {"intOfNan", {toInt}},
    {"uintOfMuch", {toUint}},
    {"uintOfLittle", {toUint}},
    {"uintOfNan", {toUint}},
    {"minOfNan", {chosen}},
    {"maxOfNan", {chosen}},
    {"stepOfNan", {chosen}},
    {"clampOfNan", {"clamp is given NaN"}},
    {"clampTurned", {limits}},
    {"clampTurnedInts", {limits}},
    {"smoothstepOfNan", {"smoothstep is given NaN"}},
    {"smoothstepOfNothing", {"smoothstep has edges in the wrong order"}},
    {"comparesNan", {"NaN is compared"}},
    {"sinOfMuch", {angle}},
    {"cosOfMuch", {angle}},
    {"tanOfMuch", {angle}},
    {"asinOfMuch", {arc}},
    {"acosOfMuch", {arc}},
    {"atanOfZeros", {"atan is of zero and zero"}},
    {"powOfNegative", {power}},
    {"powOfZeros", {power}},
    {"expOfMuch", {"exp is of more than 88.7, or NaN"}},
    {"exp2OfMuch", {"exp2 is of 128 or more, or NaN"}},
    {"logOfZero", {logarithm}},
    {"log2OfNegative", {logarithm}},
    {"sqrtOfNegative", {"sqrt is of a negative number or NaN"}},
    {"inversesqrtOfZero", {"inversesqrt is of zero, a negative number or NaN"}},
    {"normalizeOfZero", {"normalize is of zero"}},
    {"modOfZero", {"the remainder of a division by zero is taken"}},
    {"dividesByZero", {"an integer is divided by zero"}},
    {"remainderOfNegative", {"the remainder of a negative integer is taken"}},
    {"shiftsByAll", {"an integer is shifted by 32 bits or more"}},
    {"fieldBeyond", {"a bit field ends beyond 32 bits"}},
    {"indexOfArray", {index}},
    {"indexBeforeArray", {index}},
    {"indexOfRest", {index}},
    {"indexOfVector", {index}},
    {"indexOfMatrix", {index}},
    {"fetchesBeyond", {texel}},
    {"fetchesBefore", {texel}},
    {"fetchesBeyondMip", {texel}},
    {"fetchesNoMip", {"a mip level is read that its image does not have"}},
    {"fetchesOffset", {texel}},
    {"loadsBeyond", {texel}},
    {"storesBeyond", {texel}},
    {"countsBeyond", {texel}},
    {"samplesAtNan", {sample}},
    {"gathersAtInfinity", {sample}},
    {"goesRound", {"loops go round too often"}},
};

TEST_F(Planted, ViolationsInComputeAreNoted) {
    compute(true);
    EXPECT_EQ(violations(), plantedInCompute);
}

TEST_F(Planted, WhatIsJustShortOfThemIsNot) {
    compute(false);
    EXPECT_EQ(violations(), ViolationsByFunction());
}

TEST_F(Planted, ViolationsAreNotedBeforeAnInvocationEndsOrHelps) {
    draw(1e10f);
    const ViolationsByFunction expected = {
        {"inVertex", {toInt}}, {"beforeDiscard", {toInt}}, {"beforeDemote", {toInt}}};
    EXPECT_EQ(violations(), expected);
}

TEST_F(Planted, HelpersNoteNothing) {
    draw(1.0f);
    EXPECT_EQ(violations(), ViolationsByFunction());
}

} // namespace
