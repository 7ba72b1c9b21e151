// A floor's picture: colour, and in alpha how polished each spot is.
#pragma once

#include "host/files/mesh_file.h"
#include "scene/floor.h"

namespace demos {

/// One white, polished texel where the floor has no texture.
std::optional<MeshTexture> readFloorTexture(const FloorDesc& floor, Error& error);

} // namespace demos
