// Pictures in and out of files. A file appears whole or not at all: it is written beside its place and
// renamed.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "host/files/image_header.h"
#include "host/files/image_layers.h"
#include "host/host.h"
#include "scene/input_limits.h"

namespace demos {

/// 8-bit RGB, rows from the top.
bool writePng(const std::filesystem::path& file, uint32_t width, uint32_t height,
              std::span<const uint8_t> rgb, Error& error);
/// Float RGBA, zip-compressed.
bool writeExr(const std::filesystem::path& file, const Picture& picture, Error& error);

/// A picture and what its file says of it.
struct PictureFile {
    Picture picture;
    ImageHeader header;
};

/// Reads PNG, EXR or HDR of up to 16384 pixels each way, and as many in all as its bytes allow. Grey is
/// spread to RGB; a missing alpha is 1; light is of Rec. 709. Integers stay as they are encoded, 0..1.
/// The picture takes the memory of `spent`, as far as that goes: the system clears all that is new.
std::optional<PictureFile> readPictureFile(const std::filesystem::path& file, const LayerChoice& choice,
                                           const limits::Allowance& pixels, Error& error,
                                           std::vector<float> spent = {});
/// The same of a file whose picture need not be asked for by name.
std::optional<Picture> readPicture(const std::filesystem::path& file, Error& error);

} // namespace demos
