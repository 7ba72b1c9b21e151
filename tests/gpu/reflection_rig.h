// Reflects traced scenes and brings the images back.
#pragma once

#include "tests/gpu/reflection_score.h"
#include "tests/gpu/rig.h"

namespace tests {

class ReflectionTest : public GpuTest {
  protected:
    Reflected reflectView(const TracedView& traced, seaglass::ViewDesc view,
                          const seaglass::ReflectorDesc& desc = {});
    Reflected reflectScene(const Camera& camera, const TracedView& traced,
                           const seaglass::ReflectorDesc& desc = {});
};

} // namespace tests
