// What of a file changes its picture and is not drawn so: one line for each kind, however often it is met.
#pragma once

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/gltf/json.h"

namespace demos::gltf {

class Notes {
  public:
    void add(const std::string& where, const std::string& what);
    /// The extensions of a part of the file but for those that are read; of each part once.
    void addExtensions(const std::string& where, const Json& object,
                       std::initializer_list<const char*> read = {});
    std::vector<std::string> lines() const;

  private:
    struct Note {
        std::string where, what; ///< where it was met first
        std::set<std::string> others;
    };
    std::vector<Note> notes_;
    std::map<std::string, size_t> byWhat_;
    std::set<const Json*> looked_; ///< of which the extensions are noted
    size_t more_ = 0;              ///< kinds beyond those that are kept
};

} // namespace demos::gltf
