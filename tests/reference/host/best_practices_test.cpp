// The layers' best practices, over frames of the sample host: quiet but for what is listed here.
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/demo_scenes.h"
#include "tests/reference/rendered_picture.h"

namespace {

using namespace demos;

/// What a message has, and why it stays.
struct Allowed {
    const char* words;
    const char* because;
};

constexpr Allowed allowed[] = {
    {"vkCreateInstance-specialuse-extension-debugging", "validation itself asks for these extensions"},
    {"small-allocation", "of the host: a block for each image and buffer, as DeviceDesc::memory may change"},
    {"small-dedicated-allocation", "likewise"},
    {"VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT_KHR when", "of the host: timestamps, and uploads at load time"},
    {"Vertex attribute at location",
     "of the host: pipelines share one layout of vertices, of which few use all"},
    {"VK_ACCESS_2_SHADER_SAMPLED_READ_BIT", "the layer knows SHADER_READ alone, of which it is a part"},
    {"SpirvDeprecated_WorkgroupSize", "SPIR-V 1.6 would want the feature maintenance4"},
};

TEST(BestPractices, AreKeptButForWhatIsExplained) {
    Error error;
    std::optional<Scene> scene = loadScene(tests::demoScene("harbour"), {}, error);
    ASSERT_TRUE(scene) << error.text;
    testing::internal::CaptureStderr();
    {
        HostDesc desc;
        desc.validation = true;
        desc.bestPractices = true;
        const std::unique_ptr<Host> host = Host::create(desc, error);
        ASSERT_TRUE(host) << error.text;
        ASSERT_TRUE(host->load(*scene, error)) << error.text;
        for (const double later : {0.0, 0.1})
            ASSERT_TRUE(
                host->render({96, 54, scene->cameras.front(), scene->timeS + later, Aov::color}, error))
                << error.text;
    }
    std::istringstream heard(testing::internal::GetCapturedStderr());
    std::map<std::string, size_t> unexplained;
    size_t count = 0;
    for (std::string line; std::getline(heard, line);) {
        if (!line.starts_with("validation: ")) continue;
        ++count;
        const bool known = std::ranges::any_of(
            allowed, [&](const Allowed& one) { return line.find(one.words) != std::string::npos; });
        if (!known) ++unexplained[line];
    }
    EXPECT_GT(count, 0u) << "best practices are not listened to";
    for (const auto& [line, times] : unexplained) ADD_FAILURE() << times << " x " << line;
}

} // namespace
