// The same bits from the same input, time after time. Prints a hash of what each technique or option leaves,
// so that processes with other numbers of threads can be compared: tests/gpu/host/same_bits.cmake.
// SEAGLASS_REPEATS says how often, else 10.
#include <cstdlib>
#include <cstring>
#include <optional>
#include <ostream>

#include <glm/gtc/packing.hpp>

#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

int repeats() {
    const char* text = std::getenv("SEAGLASS_REPEATS");
    return text ? std::max(std::atoi(text), 1) : 10;
}

/// FNV-1a.
uint64_t hashed(const std::vector<float>& values, uint64_t hash) {
    for (const float value : values) {
        uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 0x100000001b3u;
    }
    return hash;
}

struct Case {
    const char* name;
    ReflectionTechnique technique;
    void (*change)(ReflectionDesc&) = [](ReflectionDesc&) {};
};

void PrintTo(const Case& some, std::ostream* out) {
    *out << some.name;
}

class SameBits : public ReflectionTest, public testing::WithParamInterface<Case> {
  protected:
    /// What the last of some frames leaves, each jittered otherwise, or of one where frames are not reused.
    Reflected reflected(const Camera& camera, const TracedView& traced) {
        ReflectorDesc desc = with(GetParam().technique);
        GetParam().change(desc.reflection);
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        const int frames = desc.reflection.temporal > 0 ? 3 : 1;
        ViewDesc of;
        const SceneOnDevice scene = upload(traced, of);
        for (int i = 0; i < frames; ++i) {
            Camera jittered = camera;
            jittered.jitter = {0.3 * i, -0.2 * i};
            ViewDesc view = viewDesc(jittered);
            view.sceneDepth = of.sceneDepth;
            view.sceneColor = of.sceneColor;
            view.jitter[0] = jittered.jitter.x;
            view.jitter[1] = jittered.jitter.y;
            reflectOnce(reflector, view, traced);
        }
        const ReflectionImages images = reflectionImages(reflector, 0);
        Reflected result{download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                         download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
        destroyReflector(reflector);
        // Both slots come round, so that the reflector is gone before its images are.
        frame([](VkCommandBuffer) {});
        frame([](VkCommandBuffer) {});
        return result;
    }

  private:
    void reflectOnce(Reflector* reflector, const ViewDesc& view, const TracedView& traced) {
        const bool drawn = GetParam().technique == ReflectionTechnique::planar;
        PlanarView mirrored;
        std::optional<DrawnBuffers> buffers;
        if (drawn) {
            EXPECT_EQ(planarView(reflector, &view, &mirrored), Status::ok) << message();
            buffers.emplace(asDrawn(traced));
        }
        frame([&](VkCommandBuffer commands) {
            if (drawn) recordDrawing(commands, mirrored, *buffers);
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
        });
    }

    /// As if the mirrored camera saw what the other does.
    static Drawn asDrawn(const TracedView& traced) {
        Drawn drawn{traced.depth, {}};
        for (size_t i = 0; i < traced.depth.size(); ++i) {
            const float* const c = &traced.color[i * 4];
            drawn.color.push_back(glm::packHalf4x16({c[0], c[1], c[2], c[3]}));
        }
        return drawn;
    }
};

TEST_P(SameBits, EachTime) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const Reflected first = reflected(pose.camera, traced);
        for (int i = 1; i < repeats(); ++i) {
            const Reflected again = reflected(pose.camera, traced);
            ASSERT_EQ(first.color, again.color) << pose.name << ", repeat " << i;
            ASSERT_EQ(first.info, again.info) << pose.name << ", repeat " << i;
        }
        hash = hashed(first.info, hashed(first.color, hash));
    }
    std::printf("bits of %s: %016llx\n", GetParam().name, static_cast<unsigned long long>(hash));
}

constexpr Case cases[] = {
    {"Sspr", ReflectionTechnique::sspr},
    {"Ssr", ReflectionTechnique::ssr},
    {"Hybrid", ReflectionTechnique::hybrid},
    {"Planar", ReflectionTechnique::planar},
    {"CoarseKeys", ReflectionTechnique::sspr, [](ReflectionDesc& d) { d.coarseKeys = true; }},
    {"Overhangs", ReflectionTechnique::hybrid, [](ReflectionDesc& d) { d.overhangSamples = 6; }},
    {"EdgeReach", ReflectionTechnique::hybrid, [](ReflectionDesc& d) { d.edgeReach = 0.2f; }},
    {"EdgeStretch", ReflectionTechnique::sspr, [](ReflectionDesc& d) { d.edgeStretch = 2; }},
    {"Temporal", ReflectionTechnique::hybrid, [](ReflectionDesc& d) { d.temporal = 0.9f; }},
};

INSTANTIATE_TEST_SUITE_P(, SameBits, testing::ValuesIn(cases),
                         [](const testing::TestParamInfo<Case>& info) { return info.param.name; });

} // namespace
