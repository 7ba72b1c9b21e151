// Pictures by the reference, for tests; what cannot be traced fails the test that asked, by an exception.
#pragma once

#include "reference/reference.h"

namespace tests {

demos::reference::Pictures traced(const demos::reference::World& world,
                                  const demos::reference::FrameDesc& desc, bool withTruth = false);
demos::reference::Pictures traced(const demos::Scene& scene, const demos::reference::FrameDesc& desc,
                                  bool withTruth = false);

} // namespace tests
