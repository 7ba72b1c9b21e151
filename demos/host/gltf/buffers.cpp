#include "host/gltf/buffers.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace demos::gltf {
namespace {

enum ComponentType : uint32_t {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126,
};

size_t bytesOf(size_t componentType) {
    switch (componentType) {
    case int8:
    case uint8:
        return 1;
    case int16:
    case uint16:
        return 2;
    case uint32:
    case float32:
        return 4;
    default:
        return 0;
    }
}

size_t componentsOf(const std::string& type) {
    constexpr std::pair<const char*, size_t> types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                        {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const auto found = std::find_if(std::begin(types), std::end(types),
                                    [&](const auto& known) { return type == known.first; });
    return found == std::end(types) ? 0 : found->second;
}

template<class T>
T read(const uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof(value));
    return value;
}

/// Whether `count` elements lie within so many bytes; divisions, so that hostile sizes cannot wrap around.
bool fits(size_t bytes, size_t offset, size_t count, size_t element, size_t stride) {
    return stride >= element && count > 0 && offset <= bytes && element <= bytes - offset &&
           count - 1 <= (bytes - offset - element) / stride;
}

} // namespace

float Elements::component(size_t element, size_t c) const {
    const uint8_t* const at = data + element * stride;
    const auto scaled = [&](auto value, float most) {
        const auto number = static_cast<float>(value);
        return normalized ? std::max(-1.0f, number / most) : number;
    };
    switch (componentType) {
    case float32:
        return read<float>(at + 4 * c);
    case uint8:
        return scaled(at[c], 255);
    case uint16:
        return scaled(read<uint16_t>(at + 2 * c), 65535);
    case int8:
        return scaled(read<int8_t>(at + c), 127);
    case int16:
        return scaled(read<int16_t>(at + 2 * c), 32767);
    default:
        return static_cast<float>(read<uint32_t>(at + 4 * c));
    }
}

uint32_t Elements::whole(size_t element, size_t c) const {
    const uint8_t* const at = data + element * stride;
    if (componentType == uint8) return at[c];
    if (componentType == uint16) return read<uint16_t>(at + 2 * c);
    return read<uint32_t>(at + 4 * c);
}

bool Elements::isWhole() const {
    return componentType == uint8 || componentType == uint16 || componentType == uint32;
}

bool Buffers::buffer(size_t index, std::span<const uint8_t>& bytes, Error& error) {
    const Json& source = document_.at("buffers", index);
    const std::string where = placeOf("buffers", index, source);
    size_t length = 0;
    if (!readCount(source, "byteLength", where, length, error)) return false;
    read_.resize(document_.count("buffers"));
    const bool inFile = index == 0 && !document_.bin.empty() && !member(source, "uri").is_string();
    if (!inFile && !read_[index]) {
        if (!member(source, "uri").is_string()) {
            error.text = where + " has no bytes, neither in the file nor by a uri";
            return false;
        }
        std::string problem;
        const auto read = uris_.read(textOf(source, "uri"), limits::gltfBufferBytes, problem);
        if (!read) {
            error.text = where + ": " + problem;
            return false;
        }
        if (uris_.bytes() > limits::gltfBufferBytes) {
            error.text = where + ": brings the files beside it over 1 GiB";
            return false;
        }
        read_[index] = read;
    }
    bytes = inFile ? std::span(document_.bin) : std::span(*read_[index]);
    if (length > bytes.size()) {
        error.text =
            where + " has " + std::to_string(bytes.size()) + " bytes, expected " + std::to_string(length);
        return false;
    }
    bytes = bytes.first(length);
    return true;
}

bool Buffers::view(size_t index, std::span<const uint8_t>& bytes, size_t& stride, Error& error) {
    const Json& source = document_.at("bufferViews", index);
    const std::string where = placeOf("bufferViews", index, source);
    std::optional<size_t> bufferIndex;
    if (!readIndex(source, "buffer", document_.count("buffers"), where, bufferIndex, error)) return false;
    if (!bufferIndex) {
        error.text = where + ".buffer is missing";
        return false;
    }
    for (const char* const compressed : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const bool fallback = member(document_.at("buffers", *bufferIndex), "uri").is_string();
        if (extension(source, compressed).is_null() || fallback) continue;
        error.text = where + " is compressed by " + compressed + ", which is not read";
        return false;
    }
    size_t offset = 0, length = 0;
    stride = 0;
    std::span<const uint8_t> all;
    if (!readCount(source, "byteOffset", where, offset, error) ||
        !readCount(source, "byteLength", where, length, error) ||
        !readCount(source, "byteStride", where, stride, error) || !buffer(*bufferIndex, all, error))
        return false;
    if (offset > all.size() || length > all.size() - offset) {
        error.text = where + " reaches past its buffer";
        return false;
    }
    bytes = all.subspan(offset, length);
    return true;
}

bool Buffers::elements(size_t index, const std::string& where, Elements& out, Error& error) {
    const Json& accessor = document_.at("accessors", index);
    const std::string what = where + ": " + placeOf("accessors", index, accessor);
    const auto fail = [&](const std::string& problem) {
        error.text = what + " " + problem;
        return false;
    };
    size_t type = 0, offset = 0;
    std::optional<size_t> viewIndex;
    if (!readCount(accessor, "componentType", what, type, error) ||
        !readCount(accessor, "count", what, out.count, error) ||
        !readCount(accessor, "byteOffset", what, offset, error) ||
        !readIndex(accessor, "bufferView", document_.count("bufferViews"), what, viewIndex, error))
        return false;
    out.componentType = static_cast<uint32_t>(std::min<size_t>(type, UINT32_MAX));
    out.components = componentsOf(textOf(accessor, "type"));
    out.normalized = isTrue(accessor, "normalized");
    const size_t element = bytesOf(type) * out.components;
    if (element == 0) return fail("is of an unknown type");
    if (out.count == 0) return fail("is empty");
    if (out.count > limits::gltfZeros && !viewIndex)
        return fail("is of over a million elements and has no bytes");
    if (viewIndex) {
        std::span<const uint8_t> bytes;
        if (!view(*viewIndex, bytes, out.stride, error)) {
            error.text = what + ": " + error.text;
            return false;
        }
        if (out.stride == 0) out.stride = element;
        if (!fits(bytes.size(), offset, out.count, element, out.stride))
            return fail("reaches past its buffer");
        out.data = bytes.data() + offset;
    } else {
        out.own = std::make_shared<std::vector<uint8_t>>(element, uint8_t{0});
        out.data = out.own->data();
        out.stride = 0;
    }
    return spend(limits::gltfAccessorWork + out.count, what, error) &&
           (member(accessor, "sparse").is_null() || sparse(accessor, what, out, error));
}

bool Buffers::spend(uint64_t work, const std::string& where, Error& error) {
    work_ += work;
    const uint64_t most = allowed(limits::gltfWork);
    if (work_ <= most) return true;
    error.text =
        where + " brings what is read over " + std::to_string(most) + " elements: the most for so many bytes";
    return false;
}

bool Buffers::sparse(const Json& accessor, const std::string& where, Elements& out, Error& error) {
    const Json& source = member(accessor, "sparse");
    const Json &indices = member(source, "indices"), &values = member(source, "values");
    const std::string what = where + ".sparse";
    const auto fail = [&](const std::string& problem) {
        error.text = what + " " + problem;
        return false;
    };
    Elements places;
    std::optional<size_t> indexView, valueView;
    size_t type = 0, indexOffset = 0, valueOffset = 0;
    const size_t views = document_.count("bufferViews");
    if (!readCount(source, "count", what, places.count, error) ||
        !readIndex(indices, "bufferView", views, what + ".indices", indexView, error) ||
        !readIndex(values, "bufferView", views, what + ".values", valueView, error) ||
        !readCount(indices, "byteOffset", what + ".indices", indexOffset, error) ||
        !readCount(values, "byteOffset", what + ".values", valueOffset, error) ||
        !readCount(indices, "componentType", what + ".indices", type, error))
        return false;
    if (places.count == 0) return true;
    if (!spend(places.count, what, error)) return false;
    places.componentType = static_cast<uint32_t>(std::min<size_t>(type, UINT32_MAX));
    if (!indexView || !valueView || !places.isWhole()) return fail("has no indices or no values");
    places.stride = bytesOf(type);
    const size_t element = bytesOf(out.componentType) * out.components;
    std::span<const uint8_t> indexBytes, valueBytes;
    size_t ignored = 0;
    if (!view(*indexView, indexBytes, ignored, error) || !view(*valueView, valueBytes, ignored, error))
        return false;
    if (!fits(indexBytes.size(), indexOffset, places.count, places.stride, places.stride) ||
        !fits(valueBytes.size(), valueOffset, places.count, element, element))
        return fail("reaches past its buffer");
    places.data = indexBytes.data() + indexOffset;

    sparseBytes_ += out.count * element;
    if (sparseBytes_ > limits::gltfSparseBytes) return fail("brings sparse accessors over 256 MiB");
    const auto whole = std::make_shared<std::vector<uint8_t>>(out.count * element);
    for (size_t i = 0; i < out.count; ++i)
        std::memcpy(whole->data() + i * element, out.data + i * out.stride, element);
    for (size_t i = 0; i < places.count; ++i) {
        const size_t place = places.whole(i, 0);
        if (place >= out.count) return fail("replaces elements that there are none of");
        std::memcpy(whole->data() + place * element, valueBytes.data() + valueOffset + i * element, element);
    }
    out.data = whole->data();
    out.stride = element;
    out.own = whole;
    return true;
}

} // namespace demos::gltf
