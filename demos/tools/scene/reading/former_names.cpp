#include "scene/reading/former_names.h"

#include "scene/reading/places.h"

namespace demos::reading {

std::string calledNow(const std::string& where, const std::string& path, std::string_view key,
                      std::string_view now) {
    return where + ": " + join(path, key) + " is called " + std::string(now) + " now";
}

std::string isGone(const std::string& where, const std::string& path, const GoneKey& gone) {
    return where + ": " + join(path, gone.key) + " is no more: " + std::string(gone.why);
}

void renameFormer(toml::table& table, const Section& section, const std::string& path,
                  const std::string& file, std::vector<std::string>& notes) {
    for (const FormerKey& former : formerKeys) {
        const toml::node* const node = table.get(former.before);
        if (section.key != former.section || !node || table.contains(former.now)) continue;
        notes.push_back(calledNow(place(*node, file), path, former.before, former.now));
        table.get(former.before)->visit([&](auto& found) { table.insert(former.now, std::move(found)); });
        table.erase(former.before);
    }
    for (const GoneKey& gone : goneKeys) {
        const toml::node* const node = table.get(gone.key);
        if (section.key != gone.section || !node) continue;
        notes.push_back(isGone(place(*node, file), path, gone));
        table.erase(gone.key);
    }
    for (const Child& child : section.children) {
        toml::node* const node = table.get(child.section->key);
        if (!node) continue;
        const std::string childPath = join(path, child.section->key);
        if (toml::table* const below = node->as_table())
            renameFormer(*below, *child.section, childPath, file, notes);
        toml::array* const elements = node->as_array();
        for (size_t i = 0; elements && i < elements->size(); ++i)
            if (toml::table* const below = (*elements)[i].as_table())
                renameFormer(*below, *child.section, join(childPath, std::to_string(i)), file, notes);
    }
}

} // namespace demos::reading
