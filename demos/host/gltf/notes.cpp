#include "host/gltf/notes.h"

#include <algorithm>

#include "scene/input_limits.h"

namespace demos::gltf {

void Notes::add(const std::string& where, const std::string& what) {
    const auto known = byWhat_.find(what);
    if (known != byWhat_.end()) {
        Note& note = notes_[known->second];
        if (note.where != where) note.others.insert(where);
    } else if (notes_.size() < limits::gltfNotes) {
        byWhat_.emplace(what, notes_.size());
        notes_.push_back({where, what, {}});
    } else {
        ++more_;
    }
}

void Notes::addExtensions(const std::string& where, const Json& object,
                          std::initializer_list<const char*> read) {
    if (!looked_.insert(&object).second) return;
    for (const auto& entry : member(object, "extensions").items()) {
        const std::string& name = entry.key();
        if (!isHarmless(name) && std::find(read.begin(), read.end(), name) == read.end())
            add(where, quoted(name) + " is left out");
    }
}

std::vector<std::string> Notes::lines() const {
    std::vector<std::string> lines;
    for (const Note& note : notes_) {
        const std::string more =
            note.others.empty() ? "" : " (and " + std::to_string(note.others.size()) + " more)";
        lines.push_back(note.where + more + ": " + note.what);
    }
    if (more_ > 0) lines.push_back("and " + std::to_string(more_) + " more that is left out");
    return lines;
}

} // namespace demos::gltf
