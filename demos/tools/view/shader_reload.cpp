#include "view/shader_reload.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include <unistd.h>

#include "gpu/interface/shader_reload.h"
#include "host/host_impl.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// As the shell takes it for one word.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

/// What a command says, on both of its outputs. False where it could not be run or failed.
bool runs(const std::string& command, std::string& said) {
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return false;
    char piece[512];
    for (size_t got; (got = std::fread(piece, 1, sizeof piece, pipe)) > 0;) said.append(piece, got);
    return pclose(pipe) == 0;
}

/// glslang's first "ERROR: FILE:LINE: what", without the word.
std::string firstError(const std::string& said) {
    const std::string mark = "ERROR: ";
    const size_t from = said.find(mark);
    if (from == std::string::npos) return said.empty() ? "the compiler cannot be run" : said;
    return said.substr(from + mark.size(), said.find('\n', from) - from - mark.size());
}

std::vector<uint32_t> readWords(const fs::path& file) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    std::vector<uint32_t> words(in ? static_cast<size_t>(in.tellg()) / sizeof(uint32_t) : 0);
    in.seekg(0);
    in.read(reinterpret_cast<char*>(words.data()),
            static_cast<std::streamsize>(words.size() * sizeof(uint32_t)));
    return words;
}

} // namespace

ShaderReload::ShaderReload(fs::path folder) : folder_(std::move(folder)), stamps_(stampsNow()) {
    readRecipes();
    seaglass::gpu::setShaderSource([this](const std::string& name, Words& words) {
        return trial_ ? findForTrial(name, words) : find(name, words);
    });
}

ShaderReload::~ShaderReload() {
    seaglass::gpu::setShaderSource(nullptr);
}

/// A line of SEAGLASS_SHADER_LIST: name, source, options.
void ShaderReload::readRecipes() {
    std::ifstream list(SEAGLASS_SHADER_LIST);
    for (std::string line; std::getline(list, line);) {
        std::istringstream words(line);
        std::string name, source, defines;
        words >> name >> source;
        std::getline(words, defines);
        recipes_[name] = {source, defines};
    }
}

ShaderReload::Stamps ShaderReload::stampsNow() const {
    Stamps stamps;
    std::error_code gone; // an editor may be replacing a file
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_, gone))
        if (entry.is_regular_file(gone))
            stamps[entry.path().lexically_relative(folder_)] = {entry.last_write_time(gone),
                                                                entry.file_size(gone)};
    return stamps;
}

std::vector<fs::path> ShaderReload::folders() const {
    std::vector<fs::path> all;
    std::error_code gone;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_, gone))
        if (entry.is_directory(gone)) all.push_back(entry.path().lexically_relative(folder_));
    std::ranges::sort(all);
    return all;
}

fs::path ShaderReload::including(const std::string& name) const {
    for (const fs::path& folder : folders())
        if (fs::exists(folder_ / folder / name)) return folder / name;
    return name;
}

void ShaderReload::addIncluded(const fs::path& file, std::set<fs::path>& out) const {
    if (!out.insert(file).second) return;
    std::ifstream in(folder_ / file);
    const std::string mark = "#include \"";
    for (std::string line; std::getline(in, line);) {
        const size_t from = line.find(mark);
        if (from == std::string::npos) continue;
        const std::string name = line.substr(from + mark.size(), line.rfind('"') - from - mark.size());
        const fs::path beside = file.parent_path() / name;
        addIncluded(fs::exists(folder_ / beside) ? beside : including(name), out);
    }
}

bool ShaderReload::changed() {
    Stamps now = stampsNow();
    if (now == stamps_) return false;
    std::set<fs::path> others;
    for (const auto& [file, stamp] : now)
        if (const auto had = stamps_.find(file); had == stamps_.end() || had->second != stamp)
            others.insert(file);
    for (const auto& [file, stamp] : stamps_)
        if (!now.contains(file)) others.insert(file);
    stamps_ = std::move(now);
    broken_ = false;
    for (const auto& [name, recipe] : recipes_) {
        std::set<fs::path> files;
        addIncluded(recipe.source, files);
        for (const fs::path& file : others)
            if (files.contains(file)) stale_.insert(name);
    }
    return true;
}

bool ShaderReload::compile(const std::string& name, Words& out) {
    const Recipe& recipe = recipes_.at(name);
    const fs::path made = fs::temp_directory_path() / ("seaglass-" + std::to_string(getpid()) + ".spv");
    std::string command = quoted(SEAGLASS_GLSLANG) + " " SEAGLASS_GLSLANG_FLAGS;
    for (const fs::path& folder : folders()) command += " -I" + quoted((folder_ / folder).string());
    command +=
        recipe.defines + " -o " + quoted(made.string()) + " " + quoted((folder_ / recipe.source).string());
    std::string said;
    const bool compiled = runs(command, said);
    out = compiled ? readWords(made) : Words{};
    std::error_code none;
    fs::remove(made, none);
    if (compiled) return true;
    problem_ = firstError(said);
    std::fprintf(stderr, "%s\n", problem_.c_str());
    return false;
}

bool ShaderReload::findForTrial(const std::string& name, Words& out) {
    if (!stale_.contains(name)) return find(name, out);
    if (!trials_.contains(name) && !compile(name, trials_[name])) return false;
    out = trials_[name];
    return true;
}

bool ShaderReload::find(const std::string& name, Words& out) {
    Words made;
    // While anything is broken the shaders stay that fit each other.
    if (!trial_ && !broken_ && stale_.contains(name)) {
        if (compile(name, made)) words_[name] = std::move(made);
        stale_.erase(name);
    }
    if (const auto known = words_.find(name); known != words_.end()) out = known->second;
    return true;
}

bool ShaderReload::renew(Host& host, const Scene& scene, const FrameDesc& trial, Error& error) {
    Host::Impl& inside = host.inside();
    auto recorder = std::make_unique<FrameRecorder>();
    auto loaded = std::make_unique<LoadedScene>();
    trial_ = true;
    problem_.clear();
    bool drawn = false;
    if (recorder->create(*inside.device, inside.desc, error) && recorder->load(scene, *loaded, error)) {
        std::swap(inside.recorder, recorder);
        std::swap(inside.scene, loaded);
        drawn = inside.draw(
            trial, [](VkCommandBuffer, const Image&) {}, error);
        if (!drawn) {
            std::swap(inside.scene, loaded);
            std::swap(inside.recorder, recorder);
        }
    }
    trial_ = false;
    broken_ = !drawn;
    if (!drawn && !problem_.empty()) error.text = takeProblem();
    for (auto& [name, words] : trials_) {
        if (!drawn) break;
        words_[name] = std::move(words);
        stale_.erase(name);
    }
    trials_.clear();
    return drawn;
}

std::string ShaderReload::takeProblem() {
    return std::exchange(problem_, {});
}

} // namespace demos
