#include "tests/gltf/plate.h"

#include <algorithm>
#include <cstring>

namespace tests {
namespace {

std::string bigEndian(uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
            static_cast<char>(value)};
}

std::string littleEndian(uint32_t value) {
    return {static_cast<char>(value), static_cast<char>(value >> 8), static_cast<char>(value >> 16),
            static_cast<char>(value >> 24)};
}

uint32_t crc(const std::string& bytes) {
    uint32_t crc = ~0u;
    for (const char byte : bytes) {
        crc ^= static_cast<uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

/// As zlib's stream of blocks that are stored as they are.
std::string stored(const std::string& data) {
    std::string stream = "\x78\x01";
    uint32_t a = 1, b = 0;
    for (const char byte : data) {
        a = (a + static_cast<uint8_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    for (size_t at = 0; at < data.size(); at += 65535) {
        const size_t size = std::min<size_t>(65535, data.size() - at);
        stream += static_cast<char>(at + size == data.size());
        const auto length = static_cast<uint16_t>(size);
        stream += littleEndian(uint32_t{length} | uint32_t{static_cast<uint16_t>(~length)} << 16);
        stream += data.substr(at, size);
    }
    return stream + bigEndian(b << 16 | a);
}

template<class T>
std::string bytesOf(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

constexpr uint32_t floats = 5126, shorts = 5123;

} // namespace

std::string pngChunk(const std::string& name, const std::string& data) {
    return bigEndian(static_cast<uint32_t>(data.size())) + name + data + bigEndian(crc(name + data));
}

std::string png(uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba) {
    std::string rows;
    for (uint32_t y = 0; y < height; ++y) {
        rows += '\0';
        rows.append(reinterpret_cast<const char*>(&rgba[size_t{y} * width * 4]), size_t{width} * 4);
    }
    const std::string header =
        bigEndian(width) + bigEndian(height) + std::string({8, 6, 0, 0, 0}); // RGBA of 8 bits
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + pngChunk("IDAT", stored(rows)) +
           pngChunk("IEND", "");
}

std::string halves(const std::vector<uint8_t>& left, const std::vector<uint8_t>& right) {
    constexpr uint32_t width = 64;
    std::vector<uint8_t> rgba;
    for (uint32_t x = 0; x < width; ++x) {
        const std::vector<uint8_t>& color = x < width / 2 ? left : right;
        rgba.insert(rgba.end(), color.begin(), color.end());
    }
    return png(width, 1, rgba);
}

std::string base64(const std::string& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

Plate::Plate() {
    root = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1,
        "TEXCOORD_0": 2}, "indices": 3, "material": 0}]}], "materials": [{"doubleSided": true,
        "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.9}}]})");
    addFloats({-1, 0, 0, 1, 0, 0, 1, 2, 0, -1, 2, 0}, "VEC3");
    addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    addFloats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    addAccessor(bytesOf<uint16_t>({0, 1, 2, 0, 2, 3}), shorts, "SCALAR", 6);
}

size_t Plate::addView(const std::string& bytes) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
    bytes_ += bytes;
    return root["bufferViews"].size() - 1;
}

size_t Plate::addAccessor(const std::string& bytes, uint32_t componentType, const std::string& type,
                          size_t count) {
    root["accessors"].push_back(
        {{"bufferView", addView(bytes)}, {"componentType", componentType}, {"type", type}, {"count", count}});
    return root["accessors"].size() - 1;
}

size_t Plate::addFloats(const std::vector<float>& values, const std::string& type) {
    const size_t components = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<size_t>(type[3] - '0');
    return addAccessor(bytesOf(values), floats, type, values.size() / components);
}

size_t Plate::addTexture(const std::string& image) {
    root["images"].push_back({{"uri", "data:image/png;base64," + base64(image)}});
    root["textures"].push_back({{"source", root["images"].size() - 1}});
    return root["textures"].size() - 1;
}

Plate& Plate::texture(const std::string& slot, const std::string& image) {
    const bool ofBase = slot == "baseColorTexture" || slot == "metallicRoughnessTexture";
    (ofBase ? material()["pbrMetallicRoughness"] : material())[slot] = {{"index", addTexture(image)}};
    return *this;
}

std::string Plate::text() const {
    Json whole = root;
    if (!whole.contains("buffers"))
        whole["buffers"] = {{{"byteLength", bytes_.size()},
                             {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return whole.dump();
}

std::string Plate::binary() const {
    Json whole = root;
    whole["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string json = whole.dump(), bin = bytes_;
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bin.resize((bin.size() + 3) / 4 * 4);
    const auto length = static_cast<uint32_t>(28 + json.size() + bin.size());
    return "glTF" + littleEndian(2) + littleEndian(length) +
           littleEndian(static_cast<uint32_t>(json.size())) + "JSON" + json +
           littleEndian(static_cast<uint32_t>(bin.size())) + std::string("BIN\0", 4) + bin;
}

} // namespace tests
