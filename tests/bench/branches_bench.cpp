// What a shader's conditions and loops cost on this device where all invocations enter them, a tenth, and
// none: multiples of the same work without a condition. CPU devices run several invocations as lanes of one
// vector, masked: docs/performance.md, "What a condition costs". Least times over the rounds, in turn.
//
//   seaglass_bench_branches [ROUNDS]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "host/vulkan/layouts.h"
#include "host/vulkan/pipeline.h"

#include "spirv/branches.comp.h"

namespace {

using namespace demos;

constexpr uint32_t invocations = 1u << 18;
constexpr std::array entering = {100, 10, 0}; // of a hundred
constexpr std::array forms = {"nothing",
                              "without a condition",
                              "if",
                              "a loop of one round",
                              "two, one in the other",
                              "a loop of four, tested first",
                              "the same, tested last, in an if",
                              "tested last, once at least"};

void require(bool done, const Error& error) {
    if (done) return;
    std::fprintf(stderr, "%s\n", error.text.c_str());
    std::exit(1);
}

class Bench {
  public:
    Bench() {
        HostDesc desc;
        desc.clock = PassClock::processor;
        device_ = Device::create(desc, error_);
        require(device_ != nullptr, error_);
        require(createBuffer(*device_, invocations * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                             BufferPlace::upload, values_, error_),
                error_);
        auto* to = static_cast<float*>(values_.mapped);
        for (uint32_t i = 0; i < invocations; ++i) to[i] = static_cast<float>(i * 37 % 100);
        constexpr VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        const VkDescriptorPoolSize size = {type, 1};
        require(createSetLayout(*device_, {&type, 1}, setLayout_, error_, VK_SHADER_STAGE_COMPUTE_BIT) &&
                    allocateSet(*device_, setLayout_.get(), {&size, 1}, pool_, set_, error_) &&
                    createPipelineLayout(*device_, {&setLayout_.get(), 1}, 0, layout_, error_),
                error_);
        writeBuffer();
        for (int form = 0; form < static_cast<int>(forms.size()); ++form)
            for (const int share : entering) pipelines_.push_back(pipeline({form, share}));
        leastMs_.assign(pipelines_.size(), 1e9);
    }

    const Device& device() const { return *device_; }

    void round() {
        for (size_t i = 0; i < pipelines_.size(); ++i) {
            require(
                device_->run([&](VkCommandBuffer commands, Error&) { return dispatch(commands, i); }, error_),
                error_);
            leastMs_[i] = std::min(leastMs_[i], runMs());
        }
    }

    double leastMs(size_t form, size_t share) const { return leastMs_[form * entering.size() + share]; }

  private:
    void writeBuffer() const {
        const VkDescriptorBufferInfo bound = {values_.buffer.get(), 0, VK_WHOLE_SIZE};
        VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = set_;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &bound;
        vkUpdateDescriptorSets(device_->handle(), 1, &write, 0, nullptr);
    }

    UniquePipeline pipeline(const std::array<int, 2>& constants) {
        constexpr VkSpecializationMapEntry entries[] = {{0, 0, sizeof(int)}, {1, sizeof(int), sizeof(int)}};
        const VkSpecializationInfo chosen = {2, entries, sizeof constants, constants.data()};
        UniquePipeline made;
        require(createComputePipeline(*device_, branches_comp, layout_.get(), &chosen, made, error_), error_);
        return made;
    }

    bool dispatch(VkCommandBuffer commands, size_t pipeline) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_[pipeline].get());
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set_, 0,
                                nullptr);
        device_->passes().mark(commands, forms[pipeline / entering.size()], true);
        vkCmdDispatch(commands, invocations / 64, 1, 1);
        device_->passes().mark(commands, forms[pipeline / entering.size()], false);
        return true;
    }

    double runMs() {
        if (device_->clock() != PassClock::timestamps) return device_->lastRunMs();
        std::vector<TimedPass> passes;
        require(device_->passes().collect(passes, error_), error_);
        return passes.front().ms;
    }

    Error error_;
    std::unique_ptr<Device> device_;
    Buffer values_;
    UniqueDescriptorSetLayout setLayout_;
    UniqueDescriptorPool pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    UniquePipelineLayout layout_;
    std::vector<UniquePipeline> pipelines_;
    std::vector<double> leastMs_;
};

} // namespace

int main(int count, char** arguments) {
    const int rounds = count > 1 ? std::atoi(arguments[1]) : 10;
    if (rounds < 1) {
        std::fprintf(stderr, "'%s' is no number of rounds, expected 1 or more\n", arguments[1]);
        return 2;
    }
    Bench bench;
    for (int i = 0; i < rounds; ++i) bench.round();
    std::printf("%s, %d rounds by %s\n%-34s%8s%8s%8s\n", bench.device().info().name.c_str(), rounds,
                describe(bench.device().clock()), "entered by", "all", "10 %", "none");
    const double plain = bench.leastMs(1, 0);
    for (size_t form = 0; form < forms.size(); ++form) {
        std::printf("%-34s", forms[form]);
        for (size_t share = 0; share < entering.size(); ++share)
            std::printf("%8.2f", bench.leastMs(form, share) / plain);
        std::printf("\n");
    }
    return 0;
}
