// The libraries' pipelines, made without a frame, and compiled on a null device as well.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/vulkan/device.h"
#include "seaglass/water.h"
#include "tests/null/compiled_twice.h"
#include "water/below/view_pass.h"
#include "water/spray/spray.h"
#include "water/surface/surface.h"

namespace tests {

/// Which of the surface's pipelines.
struct SurfaceChoice {
    /// Features: w waves, f foam, s a shore, l reflection, r refraction, o an outline, h the host's shadow
    /// map.
    std::string letters;
    seaglass::Quality quality = seaglass::Quality::medium;
    seaglass::SurfaceOutput output = seaglass::SurfaceOutput::shaded;
    seaglass::SidesSeen sides = seaglass::SidesSeen::above;
    bool hostMesh = false;
    bool multiview = false;
};

class CompiledWater {
  public:
    /// Null with `whyNot` set where there is no null device, or none for the library itself.
    static std::unique_ptr<CompiledWater> create(std::string& whyNot);
    ~CompiledWater();
    CompiledWater(const CompiledWater&) = delete;
    CompiledWater& operator=(const CompiledWater&) = delete;

    const NullDevice& nullDevice() const { return *null_; }
    /// What the library said last.
    const std::string& message() const { return message_; }

    // What these make; less than was asked for where the library fails, which then says why.
    std::vector<CompiledPipeline> kernels(); ///< those of compute, waves at each number of samples
    /// Those that find it, place it in multisampled passes and, but for motion, look up what shines through
    /// and shade it.
    std::vector<CompiledPipeline> surface(const SurfaceChoice& choice);
    std::vector<CompiledPipeline> overView(const seaglass::ViewPassVariant& variant, bool multiview);
    std::vector<CompiledPipeline> spray(const seaglass::SprayVariant& variant, bool multiview);
    /// What a body of the library's takes where it runs on the null device's kind.
    seaglass::Status estimated(const seaglass::BodyDesc& desc, VkExtent2D extent,
                               seaglass::Estimate& out) const;

  private:
    CompiledWater() = default;
    void makeKernels();
    void makeTilesKernels(); ///< what lists a surface's tiles, and completes its pixels
    /// Calls `make` with the variant of the choice's body, and tells what that made.
    template<typename Make>
    std::vector<CompiledPipeline> madeOf(const SurfaceChoice& choice, Make&& make);

    std::unique_ptr<NullDevice> null_;
    std::unique_ptr<demos::Device> device_;
    std::string message_;
    seaglass::Context* context_ = nullptr;
    uint32_t slot_ = 0;
};

/// All combinations.
std::vector<std::string> surfaceLetters();
bool hasLetter(const std::string& letters, char letter);

} // namespace tests
