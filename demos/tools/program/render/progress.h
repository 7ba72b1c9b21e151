// A line on stderr that says how far long work has come; nothing when stderr is no terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace demos {

class Progress {
  public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void say(const std::string& what);
    /// So many of so many done; says when the rest will be.
    void say(const std::string& what, uint32_t done, uint32_t all);
    void clear();

  private:
    bool terminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point started_;
};

} // namespace demos
