#pragma once

#include "scene/scene.h"

namespace demos {

/// Adds to the error what was expected, if it is that there is no Vulkan device at all.
void explainNoDevice(Error& error);

} // namespace demos
