// Of builds with SEAGLASS_SHADER_RELOAD: the library's shaders compiled anew when their files change.
// Pipelines that work stay until others do.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/host.h"

namespace demos {

class ShaderReload {
  public:
    /// Of a folder with the shaders as they were built in, of which one at a time is watched.
    explicit ShaderReload(std::filesystem::path folder);
    ~ShaderReload();
    ShaderReload(const ShaderReload&) = delete;
    ShaderReload& operator=(const ShaderReload&) = delete;

    /// Whether a file has changed since this was last asked.
    bool changed();
    /// Makes all that the host draws with anew from the files as they are, and draws a frame for a trial.
    /// What there was stays where that fails, with `error` naming the file and the line.
    bool renew(Host& host, const Scene& scene, const FrameDesc& trial, Error& error);
    /// What is wrong with a shader that was not wanted before, and was taken as it was; empty when asked
    /// again.
    std::string takeProblem();

  private:
    using Words = std::vector<uint32_t>;
    using Stamps = std::map<std::filesystem::path, std::pair<std::filesystem::file_time_type, uintmax_t>>;
    /// How a shader is compiled.
    struct Recipe {
        std::filesystem::path source; ///< relative to the folder
        std::string defines;
    };

    void readRecipes();
    Stamps stampsNow() const;
    /// Those within the shaders' folder, in any of which an included file may lie.
    std::vector<std::filesystem::path> folders() const;
    std::filesystem::path including(const std::string& name) const;
    /// All files that one includes, itself among them.
    void addIncluded(const std::filesystem::path& file, std::set<std::filesystem::path>& out) const;
    bool compile(const std::string& name, Words& out);
    bool find(const std::string& name, Words& out);
    bool findForTrial(const std::string& name, Words& out);

    std::filesystem::path folder_;
    std::map<std::string, Recipe> recipes_;
    Stamps stamps_;
    std::set<std::string> stale_;         ///< shaders whose files changed since their words were made
    std::map<std::string, Words> words_;  ///< where others than the built-in ones serve
    std::map<std::string, Words> trials_; ///< those of the trial that goes on
    bool trial_ = false;
    bool broken_ = false; ///< the last trial failed, and nothing has changed since
    std::string problem_;
};

} // namespace demos
