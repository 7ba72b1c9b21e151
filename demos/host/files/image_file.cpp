#include "host/files/image_file.h"

#include <cstring>
#include <fstream>
#include <utility>

#include <unistd.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "host/files/image_source.h"
#include "scene/reading/input_file.h"

namespace demos {
namespace {

/// A name beside `file` that no other process uses, with the same ending so that the format is found by it.
std::filesystem::path temporaryBeside(const std::filesystem::path& file) {
    std::filesystem::path name = file;
    name.replace_filename("." + file.stem().string() + "." + std::to_string(getpid()) + ".part" +
                          file.extension().string());
    return name;
}

/// What went wrong; empty when nothing did. The bytes are made in memory, because OpenImageIO's writers
/// overlook some failures to write, such as a full disk's.
std::string encode(const std::string& format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                   const void* pixels, std::vector<unsigned char>& bytes) {
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) return OIIO::geterror();
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const bool encoded = output->set_ioproxy(&memory) && output->open("memory." + format, spec) &&
                         output->write_image(type, pixels) && output->close();
    return encoded ? "" : output->geterror();
}

std::string writeBytes(const std::filesystem::path& file, const std::vector<unsigned char>& bytes) {
    std::error_code ignored;
    const std::filesystem::path directory = file.parent_path();
    if (!directory.empty() && !std::filesystem::is_directory(directory, ignored)) return "no such directory";
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    return stream ? "" : "cannot be written; is the disk full?";
}

bool writeWhole(const std::filesystem::path& file, const std::string& format, const OIIO::ImageSpec& spec,
                OIIO::TypeDesc type, const void* pixels, Error& error) {
    if (spec.width < 1 || spec.height < 1) {
        error.text = file.string() + ": an empty picture cannot be written";
        return false;
    }
    const std::filesystem::path temporary = temporaryBeside(file);
    std::vector<unsigned char> bytes;
    // Renamed to, whatever is no file would be gone.
    std::string problem = noFile(file);
    if (problem.empty()) problem = encode(format, spec, type, pixels, bytes);
    if (problem.empty()) problem = writeBytes(temporary, bytes);
    std::error_code failed;
    if (problem.empty()) {
        std::filesystem::rename(temporary, file, failed);
        if (failed) problem = failed.message();
    }
    if (problem.empty()) return true;
    std::filesystem::remove(temporary, failed);
    error.text = file.string() + ": " + problem;
    return false;
}

/// Else some of the picture's pixels are in no file.
bool covers(const ImageWindow& data, const ImageWindow& display) {
    return data.x <= display.x && data.y <= display.y && data.x + data.width >= display.x + display.width &&
           data.y + data.height >= display.y + display.height;
}

void putRow(const ImageRow& row, Picture& picture) {
    const auto place = [&picture](int x, int y) {
        return picture.rgba.data() + 4 * (static_cast<size_t>(y) * picture.width + static_cast<size_t>(x));
    };
    if (row.stepX == 1 && row.stepY == 0) {
        std::memcpy(place(row.x, row.y), row.rgba.data(), row.rgba.size_bytes());
        return;
    }
    int x = row.x, y = row.y;
    for (const glm::vec4& pixel : row.rgba) {
        std::memcpy(place(x, y), &pixel, sizeof(pixel));
        x += row.stepX;
        y += row.stepY;
    }
}

} // namespace

bool writePng(const std::filesystem::path& file, uint32_t width, uint32_t height,
              std::span<const uint8_t> rgb, Error& error) {
    if (rgb.size() != size_t(width) * height * 3) {
        error.text = file.string() + ": the picture's size does not fit its pixels";
        return false;
    }
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return writeWhole(file, "png", spec, OIIO::TypeDesc::UINT8, rgb.data(), error);
}

bool writeExr(const std::filesystem::path& file, const Picture& picture, Error& error) {
    if (picture.rgba.size() != size_t(picture.width) * picture.height * 4) {
        error.text = file.string() + ": the picture's size does not fit its pixels";
        return false;
    }
    OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 4,
                         OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    // Else OpenImageIO puts the clock's time into the file, and no two files are the same.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    return writeWhole(file, "openexr", spec, OIIO::TypeDesc::FLOAT, picture.rgba.data(), error);
}

std::optional<PictureFile> readPictureFile(const std::filesystem::path& file, const LayerChoice& choice,
                                           const limits::Allowance& pixels, Error& error,
                                           std::vector<float> spent) {
    std::optional<ImageSource> source = ImageSource::open(file, choice, pixels, error);
    if (!source) return std::nullopt;
    PictureFile out{{}, source->header()};
    Picture& picture = out.picture;
    picture.width = out.header.width;
    picture.height = out.header.height;
    picture.rgba = std::move(spent);
    if (!covers(out.header.data, out.header.display)) picture.rgba.clear();
    picture.rgba.resize(size_t{4} * picture.width * picture.height);
    const auto put = [&picture](const ImageRow& row) { putRow(row, picture); };
    return source->read(put, error) ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<Picture> readPicture(const std::filesystem::path& file, Error& error) {
    std::optional<PictureFile> read = readPictureFile(file, {"", "a file"}, limits::texturePixels, error);
    return read ? std::optional(std::move(read->picture)) : std::nullopt;
}

} // namespace demos
