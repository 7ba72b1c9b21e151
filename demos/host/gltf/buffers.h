// Buffers, the views of them, and accessors: what every number of a mesh is read through.
#pragma once

#include <memory>
#include <optional>

#include "host/gltf/document.h"
#include "host/gltf/uri.h"
#include "scene/input_limits.h"

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
    explicit Buffers(const Document& document) : document_(document), uris_(document.folder) {}

    /// Those of the file may be read in whole; the bytes stay where they are.
    bool view(size_t index, std::span<const uint8_t>& bytes, size_t& stride, Error& error);
    bool elements(size_t accessor, const std::string& where, Elements& out, Error& error);
    UriReader& uris() { return uris_; }
    /// How much is granted, by the bytes of the file and of those that were read beside it.
    uint64_t allowed(const limits::Allowance& of) const { return of.of(document_.bytes + uris_.bytes()); }
    /// Counts elements that are read, or read again. False once they are too many for so many bytes.
    bool spend(uint64_t work, const std::string& where, Error& error);

  private:
    bool buffer(size_t index, std::span<const uint8_t>& bytes, Error& error);
    bool sparse(const Json& accessor, const std::string& where, Elements& out, Error& error);

    const Document& document_;
    UriReader uris_;
    std::vector<std::shared_ptr<const std::vector<uint8_t>>> read_;
    uint64_t sparseBytes_ = 0, work_ = 0;
};

} // namespace demos::gltf
