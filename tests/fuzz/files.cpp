// Readers of files: the bytes are the file.
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "host/files/image_file.h"
#include "host/files/mesh_file.h"
#include "host/files/quiet.h"
#include "host/files/spectrum_file.h"
#include "scene/scene.h"
#include "tests/fuzz/target.h"

namespace fuzz {

namespace {

/// One of this process's own, written over by the next.
std::filesystem::path fileOf(Bytes bytes, const char* extension) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("seaglass-fuzz-" + std::to_string(getpid()) + extension);
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file;
}

/// `read` is given the file and an error.
template<typename Read>
void reading(Bytes bytes, const char* extension, const Read& read) {
    const std::filesystem::path file = fileOf(bytes, extension);
    {
        const demos::QuietStderr quiet;
        demos::Error error;
        const bool well = static_cast<bool>(read(file, error));
        // What is refused is refused in words.
        if (!well && error.text.empty()) std::abort();
    }
    std::filesystem::remove(file);
}

/// Most inputs say any size: to clear the memory of large ones would take most of the time.
constexpr demos::limits::Allowance pixels{1 << 14, 1 << 14, 0};

void readPictureOf(Bytes bytes, const char* extension) {
    reading(bytes, extension, [](const auto& file, demos::Error& error) {
        return demos::readPictureFile(file, {}, pixels, error);
    });
}

} // namespace

void readPng(Bytes bytes) {
    readPictureOf(bytes, ".png");
}

void readExr(Bytes bytes) {
    readPictureOf(bytes, ".exr");
}

void readHdr(Bytes bytes) {
    readPictureOf(bytes, ".hdr");
}

void readGltf(Bytes bytes) {
    reading(bytes, ".gltf",
            [](const auto& file, demos::Error& error) { return demos::readMesh(file, error); });
}

void readCsv(Bytes bytes) {
    reading(bytes, ".csv", [](const auto& file, demos::Error& error) {
        std::vector<seaglass::SpectrumSample> samples;
        return demos::readSpectrum(file, samples, error);
    });
}

void readScene(Bytes bytes) {
    reading(bytes, ".toml",
            [](const auto& file, demos::Error& error) { return demos::loadScene(file, {}, error); });
}

} // namespace fuzz
