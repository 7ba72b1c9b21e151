// How long making a body takes, and where the time goes: what createBody() makes, and what prepare() makes
// for a target ahead of the first draw. Each body in a context of its own, in which nothing is shared; then
// once more beside the first. Medians.
//
//   seaglass_bench_bodies [ROUNDS]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/vulkan/device.h"
#include "seaglass/water.h"
#include "tests/body_parts.h"

namespace {

using namespace seaglass;

void require(bool done, const std::string& why) {
    if (done) return;
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

using Milliseconds = std::chrono::duration<double, std::milli>;

double millisecondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return Milliseconds(std::chrono::steady_clock::now() - start).count();
}

/// In the driver, making pipelines.
double& compiling() {
    static double milliseconds = 0;
    return milliseconds;
}

VkResult VKAPI_CALL timedCompute(VkDevice device, VkPipelineCache cache, uint32_t count,
                                 const VkComputePipelineCreateInfo* infos,
                                 const VkAllocationCallbacks* allocator, VkPipeline* out) {
    VkResult result = VK_SUCCESS;
    compiling() += millisecondsOf(
        [&] { result = vkCreateComputePipelines(device, cache, count, infos, allocator, out); });
    return result;
}

VkResult VKAPI_CALL timedGraphics(VkDevice device, VkPipelineCache cache, uint32_t count,
                                  const VkGraphicsPipelineCreateInfo* infos,
                                  const VkAllocationCallbacks* allocator, VkPipeline* out) {
    VkResult result = VK_SUCCESS;
    compiling() += millisecondsOf(
        [&] { result = vkCreateGraphicsPipelines(device, cache, count, infos, allocator, out); });
    return result;
}

PFN_vkVoidFunction VKAPI_CALL timedGetDeviceProcAddr(VkDevice device, const char* name) {
    if (!std::strcmp(name, "vkCreateComputePipelines"))
        return reinterpret_cast<PFN_vkVoidFunction>(&timedCompute);
    if (!std::strcmp(name, "vkCreateGraphicsPipelines"))
        return reinterpret_cast<PFN_vkVoidFunction>(&timedGraphics);
    return vkGetDeviceProcAddr(device, name);
}

PFN_vkVoidFunction VKAPI_CALL timedGetInstanceProcAddr(VkInstance instance, const char* name) {
    if (!std::strcmp(name, "vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&timedGetDeviceProcAddr);
    return vkGetInstanceProcAddr(instance, name);
}

struct Row {
    const char* name;
    std::function<void(tests::BodyParts&)> add;
};

std::vector<Row> rows() {
    const auto waves = [](tests::BodyParts& body) {
        body.desc.waves = &body.sea;
        body.desc.wavesOn = WavesOn::gpu;
    };
    const auto sees = [=](tests::BodyParts& body) {
        waves(body);
        body.desc.refraction = &body.refraction;
        body.desc.reflection = &body.reflection;
    };
    return {{"still, the sky alone", [](tests::BodyParts&) {}},
            {"waves, the sky alone", waves},
            {"and foam",
             [=](tests::BodyParts& body) {
                 waves(body);
                 body.desc.foam = &body.foam;
             }},
            {"waves, refraction, sspr", sees},
            {"everything, hybrid", [](tests::BodyParts& body) {
                 body.addAll();
                 body.desc.wavesOn = WavesOn::gpu;
                 body.desc.spray = nullptr;
                 body.reflection.technique = ReflectionTechnique::hybrid;
                 body.reflection.temporal = 0.9f;
             }}};
}

/// Milliseconds; of the first two what the driver took for pipelines, too.
struct Times {
    double create = 0, createCompiling = 0, prepare = 0, prepareCompiling = 0, again = 0, sea = 0;
};

Times timesOf(const demos::Device& device, const Row& row) {
    DeviceDesc desc;
    desc.instance = device.instance();
    desc.physicalDevice = device.physical();
    desc.device = device.handle();
    desc.getInstanceProcAddr = timedGetInstanceProcAddr;
    desc.message.function = [](void*, const char* text) { std::fprintf(stderr, "%s\n", text); };
    Context* context = nullptr;
    require(createContext(&desc, &context) == Status::ok, "createContext failed");
    TargetDesc targetDesc;
    targetDesc.colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
    targetDesc.depthFormat = VK_FORMAT_D32_SFLOAT;
    Target* target = nullptr;
    require(createTarget(context, &targetDesc, &target) == Status::ok, "createTarget failed");
    tests::BodyParts parts;
    row.add(parts);
    const BodyDesc& bodyDesc = parts.desc;
    Times times;
    Body *body = nullptr, *second = nullptr;
    compiling() = 0;
    times.create = millisecondsOf(
        [&] { require(createBody(context, &bodyDesc, &body) == Status::ok, "createBody failed"); });
    times.createCompiling = std::exchange(compiling(), 0);
    times.prepare = millisecondsOf([&] { require(prepare(target, body) == Status::ok, "prepare failed"); });
    times.prepareCompiling = compiling();
    times.again = millisecondsOf(
        [&] { require(createBody(context, &bodyDesc, &second) == Status::ok, "createBody failed"); });
    if (bodyDesc.waves) times.sea = millisecondsOf([&] { destroySea(createSea(bodyDesc.waves, nullptr)); });
    destroyBody(body);
    destroyBody(second);
    destroyTarget(target);
    destroyContext(context);
    return times;
}

double median(const std::vector<Times>& all, double Times::*field) {
    std::vector<double> values;
    for (const Times& times : all) values.push_back(times.*field);
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 7;
    require(rounds > 0, "usage: seaglass_bench_bodies [ROUNDS], a number from 1");
    demos::Error error;
    const std::unique_ptr<demos::Device> device = demos::Device::create({}, error);
    require(device != nullptr, error.text);
    std::printf("%s, milliseconds, medians of %d\n\n", device->properties().deviceName, rounds);
    std::printf(
        "| body | createBody | of it pipelines | createSea | a second body | prepare | of it pipelines |\n"
        "|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows()) {
        std::vector<Times> all;
        for (int i = 0; i < rounds; ++i) all.push_back(timesOf(*device, row));
        std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f |\n", row.name,
                    median(all, &Times::create), median(all, &Times::createCompiling),
                    median(all, &Times::sea), median(all, &Times::again), median(all, &Times::prepare),
                    median(all, &Times::prepareCompiling));
    }
    return 0;
}
