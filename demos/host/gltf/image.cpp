#include "host/gltf/image.h"

#include <algorithm>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "host/files/quiet.h"
#include "host/files/unpacking.h"
#include "host/gltf/json.h"
#include "host/one_line.h"
#include "scene/input_limits.h"

namespace demos::gltf {
namespace {

/// A name that OpenImageIO chooses its reader by; null for other kinds.
const char* nameFor(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG")) return "memory.png";
    if (bytes.starts_with("\xff\xd8")) return "memory.jpg";
    if (bytes.starts_with("RIFF") && bytes.substr(std::min<size_t>(8, bytes.size())).starts_with("WEBP"))
        return "memory.webp";
    return nullptr;
}

/// What OpenImageIO says, of which there may be several lines.
std::string reasonOf(const std::string& said) {
    return "cannot be read: " + oneLine(said.substr(0, said.find('\n')));
}

std::string kindOf(std::string_view bytes) {
    if (bytes.starts_with("\xabKTX 20")) return "is KTX2";
    if (bytes.starts_with("DDS ")) return "is DDS";
    return bytes.empty() ? "is empty" : "is neither PNG nor JPEG";
}

} // namespace

bool decodeImage(std::span<const uint8_t> bytes, uint64_t mostPixels, Pixels& out, std::string& problem) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const char* const name = nameFor(text);
    if (!name) {
        problem = kindOf(text);
        return false;
    }
    problem.clear();
    std::optional<BarePicture> bare = barePicture(bytes, problem);
    if (!bare) return false;
    const auto isGranted = [&](int64_t width, int64_t height) {
        if (width < 1 || height < 1 || width > limits::gltfImageSide || height > limits::gltfImageSide) {
            problem = "is " + std::to_string(width) + "x" + std::to_string(height) + ", expected 1 to 8192";
            return false;
        }
        out.width = static_cast<uint32_t>(width);
        out.height = static_cast<uint32_t>(height);
        if (uint64_t{out.width} * out.height > mostPixels)
            problem = "brings the textures over what is granted to so many bytes";
        return problem.empty();
    };
    if (bare->width > 0 && bare->height > 0 && !isGranted(bare->width, bare->height)) return false;
    const QuietStderr quiet;
    OIIO::Filesystem::IOMemReader memory(bare->bytes.data(), bare->bytes.size());
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::Filesystem::IOProxy* proxy = &memory;
    hints.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto input = OIIO::ImageInput::open(name, &hints);
    if (!input) {
        problem = reasonOf(OIIO::geterror());
        return false;
    }
    const OIIO::ImageSpec spec = input->spec();
    if (!isGranted(spec.width, spec.height)) return false;
    const int channels = std::min(spec.nchannels, 4);
    out.rgba.assign(size_t{out.width} * out.height * 4, 255);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, out.rgba.data(), 4)) {
        problem = reasonOf(input->geterror());
        return false;
    }
    if (channels <= 2)
        for (size_t i = 0; i < out.rgba.size(); i += 4) {
            uint8_t* const p = &out.rgba[i];
            if (channels == 2) p[3] = p[1];
            p[1] = p[2] = p[0];
        }
    return true;
}

} // namespace demos::gltf
