#include "host/gltf/notes.h"

#include <algorithm>

namespace demos::gltf {

void Notes::add(const std::string& where, const std::string& what) {
    const auto known =
        std::find_if(notes_.begin(), notes_.end(), [&](const Note& note) { return note.what == what; });
    if (known == notes_.end())
        notes_.push_back({where, what, {}});
    else if (known->where != where &&
             std::find(known->others.begin(), known->others.end(), where) == known->others.end())
        known->others.push_back(where);
}

void Notes::addExtensions(const std::string& where, const Json& object,
                          std::initializer_list<const char*> read) {
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
    return lines;
}

} // namespace demos::gltf
