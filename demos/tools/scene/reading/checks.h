#pragma once

#include "scene/reading/reader.h"
#include "scene/reading/toml.h"
#include "scene/scene.h"

namespace demos::reading {

/// Whether fields that are good each by itself go together. `scene` was read from `root` by `reader`.
bool goTogether(const Scene& scene, const toml::table& root, Reader& reader);

} // namespace demos::reading
