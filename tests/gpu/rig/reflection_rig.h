// Reflects traced scenes and brings the images back.
#pragma once

#include <span>
#include <string>

#include "tests/gpu/rig/reflection_score.h"
#include "tests/gpu/rig/rig.h"

namespace tests {

/// The view as a region of a larger target, its corner at (left, top).
TracedView framed(const TracedView& traced, uint32_t left, uint32_t top);

struct SceneOnDevice {
    demos::Image depth, color;
};

seaglass::ReflectorDesc with(seaglass::ReflectionTechnique technique);
/// Of a test that is repeated for techniques.
std::string nameOf(const testing::TestParamInfo<seaglass::ReflectionTechnique>& info);

class ReflectionTest : public GpuTest {
  protected:
    /// Points the view at what it returns.
    SceneOnDevice upload(const TracedView& traced, seaglass::ViewDesc& view);
    Reflected reflectView(const TracedView& traced, const seaglass::ViewDesc& view,
                          const seaglass::ReflectorDesc& desc = {});
    /// Of a view that names its images.
    Reflected reflectImages(const seaglass::ViewDesc& view, const seaglass::ReflectorDesc& desc = {});
    /// By one call.
    std::vector<Reflected> reflectTogether(const seaglass::ViewDesc& view,
                                           std::span<const seaglass::ReflectorDesc> descs);
    std::vector<Reflected> reflectTogether(const TracedView& traced, seaglass::ViewDesc view,
                                           std::span<const seaglass::ReflectorDesc> descs);
    Reflected reflectScene(const Camera& camera, const TracedView& traced,
                           const seaglass::ReflectorDesc& desc = {});
    /// Holds estimate() against what a first view of `extent` asks of Vulkan.
    seaglass::Estimate expectEstimateHolds(const seaglass::ReflectorDesc& desc, VkExtent2D extent);
};

} // namespace tests
