// What files may ask for: docs/limits.md has the table. Work and memory follow the bytes of a file, since a
// kilobyte can ask for gigabytes: what no real file asks for is refused before it is allocated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace demos::limits {

/// So much is granted to any file, and more to those that hold bytes for it.
struct Allowance {
    uint64_t any, most;
    uint64_t perByte, perBytes = 1; ///< `perByte` for each `perBytes` bytes

    constexpr uint64_t of(uint64_t bytes) const { return std::min(most, any + bytes / perBytes * perByte); }
};

// ---- Pictures: PNG, JPEG, EXR, HDR

constexpr int64_t pictureSide = 16384;
constexpr uint64_t pictureFileBytes = uint64_t(1) << 30;
/// That are compared: each costs a microsecond, and 170 bytes.
constexpr Allowance comparedPixels{uint64_t(1) << 21, uint64_t(1) << 25, 2};
constexpr Allowance largePixels{comparedPixels.most, comparedPixels.most, 0}; ///< by compare --large
constexpr Allowance skyPixels{uint64_t(1) << 23, uint64_t(1) << 27, 2};
/// Of floors. Flat maps of 4096x4096 take few bytes.
constexpr Allowance texturePixels{uint64_t(1) << 24, uint64_t(1) << 25, 16};
constexpr int64_t tilePixels = int64_t(1) << 24;
constexpr int64_t exrBlockBytes = int64_t(1) << 29; ///< of rows that are unpacked together
constexpr size_t exrNameBytes = 255;
constexpr int exrAttributes = 1024; ///< of a part: each is looked up among all before it
constexpr int exrParts = 256;       ///< OpenEXR itself sets no bound
constexpr size_t hdrHeaderBytes = 1 << 16;
constexpr size_t jpegScans = 64; ///< each goes over all pixels

// ---- glTF and GLB

constexpr uint64_t gltfFileBytes = uint64_t(1) << 30;
constexpr size_t gltfTextBytes = size_t(1) << 28;
constexpr size_t gltfNesting = 64;
constexpr size_t gltfValues = 2'000'000;
constexpr uint64_t gltfBufferBytes = uint64_t(1) << 30; ///< of all files that one refers to
constexpr size_t gltfZeros = size_t(1) << 20;           ///< of an accessor that the file holds no bytes for
constexpr size_t gltfMaterials = 1024;
constexpr size_t gltfTextures = 256;
constexpr size_t gltfInstances = 1'000'000;
constexpr uint64_t gltfImageBytes = uint64_t(1) << 28;
constexpr int gltfImageSide = 8192;
constexpr Allowance gltfTexels{uint64_t(1) << 24, uint64_t(1) << 27, 16}; ///< of all textures
/// Nodes may repeat a mesh as often as they like.
constexpr Allowance gltfVertices{uint64_t(1) << 20, 16'000'000, 1, 3};
/// Elements that are read, or read again for another node: sixteen a vertex.
constexpr Allowance gltfWork{uint64_t(1) << 24, uint64_t(1) << 32, 16, 3};
constexpr uint64_t gltfPrimitiveWork = 128; ///< of one that is read, whatever it holds
constexpr uint64_t gltfAccessorWork = 64;   ///< likewise, each time
constexpr uint64_t gltfSparseBytes = uint64_t(1) << 28;
constexpr size_t gltfNotes = 64; ///< lines of what is left out

// ---- Scenes

constexpr uint64_t sceneBytes = uint64_t(1) << 20;
constexpr size_t sceneKeyParts = 16; ///< of a dotted key
constexpr size_t sceneTables = 256;  ///< of one array, as [[mesh]]
/// Of all meshes that a scene places; the bytes are those of its files.
constexpr Allowance sceneTriangles{uint64_t(1) << 19, uint64_t(1) << 32, 1};

// ---- Reports of compare, which are gathered: a kilobyte for each pair of pictures

constexpr uint64_t reportBytes = uint64_t(1) << 28;

// ---- Measured spectra

constexpr size_t spectrumBytes = size_t(1) << 20;

} // namespace demos::limits
