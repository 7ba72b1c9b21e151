// What SwiftShader needs of a host whose sky no draw shows.
#pragma once

#include "host/vulkan/resources.h"

namespace tests {

/// Between a cube's faces SwiftShader filters with texels that it copies from the neighbours when a draw
/// binds the cube. Kernels do not have them copied: they find black along the edges. So the cube is bound to
/// a draw once; of other drivers nothing is asked.
void copyEdges(demos::Device& device, const demos::Image& cube);

} // namespace tests
