// The same bits from the same input, time after time. Prints a hash of what each technique leaves, so that
// processes with other numbers of threads can be compared: tests/gpu/same_bits.cmake. SEAGLASS_REPEATS says
// how often, else 10.
#include <cstdlib>
#include <cstring>

#include "tests/gpu/poses.h"
#include "tests/gpu/reflection_rig.h"

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

class SameBits : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {};

TEST_P(SameBits, EachTime) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        ReflectorDesc desc;
        desc.reflection.technique = GetParam();
        const Reflected first = reflectScene(pose.camera, traced, desc);
        for (int i = 1; i < repeats(); ++i) {
            const Reflected again = reflectScene(pose.camera, traced, desc);
            ASSERT_EQ(first.color, again.color) << pose.name << ", repeat " << i;
            ASSERT_EQ(first.info, again.info) << pose.name << ", repeat " << i;
        }
        hash = hashed(first.info, hashed(first.color, hash));
    }
    std::printf("bits of technique %u: %016llx\n", static_cast<uint32_t>(GetParam()),
                static_cast<unsigned long long>(hash));
}

INSTANTIATE_TEST_SUITE_P(, SameBits,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid),
                         nameOf);

} // namespace
