#include "program/screenshots/stages.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "program/screenshots/frame_name.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> own = {
    "scene", "depth", "height", "normal", "foam", "class", "reflection_source", "reflection", "color"};
constexpr std::array<std::string_view, 6> data = {"depth", "height", "normal",
                                                  "foam",  "class",  "reflection_source"};

bool endsWithWord(const std::string& text, const std::string& word) {
    if (!text.ends_with(word)) return false;
    const size_t before = text.size() - word.size();
    return before == 0 || std::string_view("._-").find(text[before - 1]) != std::string_view::npos;
}

} // namespace

Stages::Stages(std::vector<std::string> names) : names_(std::move(names)) {
    if (names_.empty()) names_.assign(own.begin(), own.end());
}

std::optional<Stages::Place> Stages::placeOf(const fs::path& picture) const {
    const FrameName frame = frameName(picture.stem().string());
    std::optional<Place> longest;
    for (size_t i = 0; i < names_.size(); ++i) {
        if (!endsWithWord(frame.stem, names_[i])) continue;
        if (longest && names_[longest->stage].size() > names_[i].size()) continue;
        std::string rest = (picture.parent_path() / frame.stem).string();
        rest.resize(rest.size() - names_[i].size());
        longest = Place{rest + (frame.number ? "#" + std::to_string(*frame.number) : ""), i};
    }
    return longest;
}

std::string Stages::of(const fs::path& picture) const {
    const std::optional<Place> place = placeOf(picture);
    return place ? names_[place->stage] : "";
}

void Stages::nameFirst(std::vector<Judged>& all) const {
    std::map<std::string, std::map<size_t, Judged*>> pictures;
    for (Judged& one : all)
        if (const std::optional<Place> place = placeOf(one.name))
            pictures[place->picture][place->stage] = &one;
    for (const auto& [name, stages] : pictures) {
        if (stages.size() < 2) continue;
        const auto differs = [](const auto& entry) { return entry.second->code != ok; };
        const auto first = std::find_if(stages.begin(), stages.end(), differs);
        // What has no reference yet, or was not drawn, tells nothing of where a difference begins.
        if (first != stages.end() && first->second->code == different && first->second->json.empty())
            continue;
        for (auto later = first; later != stages.end(); ++later)
            if (differs(*later))
                later->second->why += "; the first stage that differs is " + names_[first->first];
    }
}

bool isData(const std::string& stage) {
    return std::find(data.begin(), data.end(), stage) != data.end();
}

} // namespace demos
