#include "host/passes/floor_texture.h"

#include <cmath>

#include "host/files/image_file.h"

namespace demos {

std::optional<MeshTexture> readFloorTexture(const FloorDesc& floor, Error& error) {
    MeshTexture texture;
    texture.srgb = true;
    if (floor.texture.empty()) {
        texture.width = texture.height = 1;
        texture.rgba.assign(4, 255);
        return texture;
    }
    const std::optional<Picture> picture = readPicture(floor.texture, error);
    if (!picture) return std::nullopt;
    texture.width = picture->width;
    texture.height = picture->height;
    for (const float value : picture->rgba) {
        // NaN, which an EXR may hold, goes to 0.
        const float kept = value > 0 ? std::min(value, 1.0f) : 0.0f;
        texture.rgba.push_back(static_cast<uint8_t>(std::lround(kept * 255)));
    }
    return texture;
}

} // namespace demos
