#pragma once

#include <filesystem>
#include <string>

#include "scene/fields.h"
#include "scene/reading/toml.h"
#include "scene/scene.h"

namespace demos::reading {

/// Fills a scene from parsed TOML. The first error wins.
class Reader {
  public:
    Reader(const std::filesystem::path& file, Error& error)
        : file_(file.string()), folder_(std::filesystem::absolute(file).parent_path()), error_(error) {}

    /// `path` is what errors say ("mesh.0"), `schemaPath` what the table calls it ("mesh").
    bool read(const toml::table& table, const Section& section, void* owner, const std::string& path,
              const std::string& schemaPath);
    bool fail(const std::string& where, const std::string& what);

    const std::string& file() const { return file_; }

  private:
    bool readChild(const toml::table& parent, const Child& child, void* owner, const std::string& path,
                   const std::string& schemaPath);
    bool readField(const toml::node& node, const Field& field, const Target& target, const std::string& path);
    bool findFile(const toml::node& node, std::filesystem::path& file, const Field& field,
                  const std::string& path);

    bool unknown(const toml::node& node, const toml::key& key, const std::string& path,
                 const std::string& schemaPath);
    bool missing(const toml::table& table, const Field& field, void* owner, const std::string& path);
    bool wrong(const toml::node& node, const std::string& path, const std::string& expected);

    std::string file_;
    std::filesystem::path folder_;
    Error& error_;
};

} // namespace demos::reading
