// glTF files for tests: one square plate, to be changed before it is written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace tests {

using Json = nlohmann::json;

/// A part of a PNG: a name of four letters, and what it holds.
std::string pngChunk(const std::string& name, const std::string& data);
/// A PNG of RGBA pixels, top row first.
std::string png(uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba);
/// Half of one colour on the left and half of another on the right, 64 pixels wide.
std::string halves(const std::vector<uint8_t>& left, const std::vector<uint8_t>& right);
std::string base64(const std::string& bytes);

/// Spans x from -1 to 1 and y from 0 to 2 at z = 0, faces +Z, and has UVs from 0 to 1 with v running down.
class Plate {
  public:
    Plate();

    Json root; ///< accessors: 0 positions, 1 normals, 2 UVs, 3 indices
    Json& primitive() { return root["meshes"][0]["primitives"][0]; }
    Json& material() { return root["materials"][0]; }
    Json& node() { return root["nodes"][0]; }

    /// All of these give indices.
    size_t addView(const std::string& bytes);
    size_t addFloats(const std::vector<float>& values, const std::string& type);
    size_t addAccessor(const std::string& bytes, uint32_t componentType, const std::string& type,
                       size_t count);
    /// Of an image of its own.
    size_t addTexture(const std::string& image);
    Plate& texture(const std::string& slot, const std::string& image);

    std::string text() const;   ///< with its bytes in it
    std::string binary() const; ///< as GLB

  private:
    std::string bytes_;
};

} // namespace tests
