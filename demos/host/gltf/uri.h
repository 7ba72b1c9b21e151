// The bytes that a URI within a glTF file stands for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace demos::gltf {

class UriReader {
  public:
    explicit UriReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Of a data URI, or of a file below the folder: its name may be percent-encoded or not, and may have
    /// backslashes for slashes, as exporters write it. A file is read once, however many refer to it. Null
    /// with a `problem` that names it.
    std::shared_ptr<const std::vector<uint8_t>> read(const std::string& uri, uint64_t most,
                                                     std::string& problem);
    /// Of the files that were read.
    uint64_t bytes() const { return bytes_; }

  private:
    std::optional<std::filesystem::path> find(const std::string& uri, std::string& problem) const;

    std::filesystem::path folder_;
    std::map<std::filesystem::path, std::shared_ptr<const std::vector<uint8_t>>> files_;
    uint64_t bytes_ = 0;
};

} // namespace demos::gltf
