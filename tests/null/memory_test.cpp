// What water holds on a GPU, by estimate() of a context that takes its device for one: GPUs make waves
// themselves and store to images, where CPU devices copy, and shade in steps. Images are as large as llvmpipe
// says, which pads none; GPUs pad some.
#include <cstdio>

#include "tests/body_parts.h"
#include "tests/null/compiles.h"

namespace tests {

namespace {

using namespace seaglass;

constexpr double mebibyte = 1 << 20;

class MemoryOnGpus : public Compiles {
  protected:
    /// Of all that one view of 1920x1080 holds at `medium` [MiB]; printed.
    double held(const char* what) {
        setQuality(Quality::medium, &parts_.desc, &parts_.reflection);
        Estimate estimated;
        EXPECT_EQ(water_->estimated(parts_.desc, {1920, 1080}, estimated), Status::ok) << water_->message();
        const double all = static_cast<double>(estimated.bytes + estimated.bytesPerView) / mebibyte;
        std::printf("%-32s %6.2f MiB\n", what, all);
        return all;
    }

    BodyParts parts_;
};

TEST_F(MemoryOnGpus, OfAllPartsIs64MebibytesAt1080p) {
    EXPECT_LE(held("the surface"), 33);
    parts_.addAll();
    parts_.desc.spray = nullptr;
    EXPECT_LE(held("all but spray and motion"), 64);
    parts_.desc.spray = &parts_.spray;
    EXPECT_LE(held("with spray"), 64);
    parts_.desc.motion = true;
    EXPECT_LE(held("and motion, a map of waves more"), 68);
}

} // namespace

} // namespace tests
