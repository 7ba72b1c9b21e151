// Buffers, the views of them, and accessors: what every number of a mesh is read through.
#pragma once

#include <memory>
#include <optional>

#include "host/gltf/document.h"

namespace demos::gltf {

/// An accessor whose every element lies inside its buffer. Those without a buffer are zeros; sparse ones have
/// storage of their own.
struct Elements {
    const uint8_t* data = nullptr;
    size_t count = 0, stride = 0;
    uint32_t componentType = 0;
    size_t components = 0;
    bool normalized = false;
    std::shared_ptr<const std::vector<uint8_t>> own;

    float component(size_t element, size_t c) const;
    /// Of unsigned types.
    uint32_t whole(size_t element, size_t c) const;
    bool isWhole() const;
};

class Buffers {
  public:
    explicit Buffers(const Document& document) : document_(document) {}

    /// Those of the file may be read in whole; the bytes stay where they are.
    bool view(size_t index, std::span<const uint8_t>& bytes, size_t& stride, Error& error);
    bool elements(size_t accessor, const std::string& where, Elements& out, Error& error);
    /// Read so far.
    size_t bytes() const { return bytes_; }

  private:
    bool buffer(size_t index, std::span<const uint8_t>& bytes, Error& error);
    bool sparse(const Json& accessor, const std::string& where, Elements& out, Error& error);

    const Document& document_;
    std::vector<std::optional<std::vector<uint8_t>>> read_;
    size_t bytes_ = 0;
};

} // namespace demos::gltf
