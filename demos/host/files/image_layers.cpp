#include "host/files/image_layers.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "host/ascii.h"

namespace demos {
namespace {

constexpr size_t listed = 8;
/// What renderers call the picture itself: Blender, Arnold, V-Ray, Houdini, Nuke, Katana.
constexpr std::array<std::string_view, 11> beautyNames = {
    "beauty", "combined", "composite", "rgba", "rgb", "color", "colour", "c", "main", "primary", "image"};

struct Channel {
    std::string base; ///< in lower case
    int index = 0;
};

struct Group {
    int part = 0;
    std::string layer, label;
    std::vector<Channel> channels;
};

std::string afterLastDot(const std::string& name) {
    return name.substr(name.rfind('.') + 1); // npos + 1 is 0
}

int indexOf(const Group& group, std::initializer_list<std::string_view> names) {
    for (const Channel& channel : group.channels)
        if (std::find(names.begin(), names.end(), channel.base) != names.end()) return channel.index;
    return -1;
}

bool isLuminanceChroma(const Group& group) {
    return indexOf(group, {"y"}) >= 0 && (indexOf(group, {"ry"}) >= 0 || indexOf(group, {"by"}) >= 0);
}

/// Null unless it holds colour or grey. A Y beside an X is a vector's.
std::optional<ImageLayer> colorOf(const Group& group) {
    ImageLayer out{group.part, group.label, {}};
    const int alpha = indexOf(group, {"a", "alpha"});
    out.channels = {indexOf(group, {"r", "red"}), indexOf(group, {"g", "green"}),
                    indexOf(group, {"b", "blue"}), alpha};
    if (std::none_of(out.channels.begin(), out.channels.begin() + 3, [](int c) { return c < 0; })) return out;
    const int grey = indexOf(group, {"x"}) < 0 ? indexOf(group, {"y"}) : -1;
    if (grey < 0 || isLuminanceChroma(group)) return std::nullopt;
    out.channels = {grey, -1, -1, alpha};
    return out;
}

/// What somebody names need not hold colour: its first three channels then stand for it, or what it has.
ImageLayer anyOf(const Group& group) {
    ImageLayer out{group.part, group.label, {-1, -1, -1, -1}};
    const size_t kept = std::min<size_t>(group.channels.size(), 3);
    for (size_t i = 0; i < kept; ++i) out.channels[i] = group.channels[i].index;
    return out;
}

std::vector<Group> groupsOf(const std::vector<ImagePart>& parts) {
    std::vector<Group> groups;
    for (size_t part = 0; part < parts.size(); ++part) {
        std::map<std::string, size_t> known; // a file may have as many layers as channels
        for (size_t i = 0; i < parts[part].channels.size(); ++i) {
            const std::string& name = parts[part].channels[i];
            const size_t dot = name.rfind('.');
            const std::string layer = dot == name.npos ? "" : name.substr(0, dot);
            const auto [group, fresh] = known.try_emplace(layer, groups.size());
            if (fresh) {
                const std::string label = layer.empty() && parts.size() > 1 ? parts[part].name : layer;
                groups.push_back({static_cast<int>(part), layer, label, {}});
            }
            groups[group->second].channels.push_back({lowerCase(afterLastDot(name)), static_cast<int>(i)});
        }
    }
    return groups;
}

/// Two parts may have layers of one name.
void tellApart(std::vector<Group>& groups, const std::vector<ImagePart>& parts) {
    std::map<std::string, size_t> counts;
    for (const Group& group : groups) ++counts[group.label];
    for (Group& group : groups)
        if (counts[group.label] > 1) {
            const std::string& part = parts[static_cast<size_t>(group.part)].name;
            group.label = group.layer.empty() ? part : part + "." + group.layer;
        }
}

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < std::min(names.size(), listed); ++i)
        text += (i ? ", " : "") + names[i].substr(0, 60);
    return names.size() > listed ? text + " and " + std::to_string(names.size() - listed) + " more" : text;
}

std::string labels(const std::vector<const Group*>& groups) {
    std::vector<std::string> names;
    for (const Group* group : groups) names.push_back(group->label.empty() ? "(unnamed)" : group->label);
    return list(names);
}

template<class Suits>
std::vector<const Group*> those(const std::vector<Group>& groups, const Suits& suits) {
    std::vector<const Group*> found;
    for (const Group& group : groups)
        if (suits(group)) found.push_back(&group);
    return found;
}

std::optional<ImageLayer> named(const std::vector<Group>& groups, const LayerChoice& choice, Error& error) {
    const std::string wanted = lowerCase(choice.name);
    std::vector<const Group*> found =
        those(groups, [&](const Group& g) { return lowerCase(g.label) == wanted; });
    if (found.empty())
        found = those(groups, [&](const Group& g) { return lowerCase(afterLastDot(g.label)) == wanted; });
    if (found.size() == 1) {
        const std::optional<ImageLayer> color = colorOf(*found.front());
        return color ? *color : anyOf(*found.front());
    }
    error.text = found.empty() ? "has no layer '" + choice.name + "', expected one of " +
                                     labels(those(groups, [](const Group&) { return true; }))
                               : "has several layers '" + choice.name + "', expected one of " + labels(found);
    return std::nullopt;
}

/// Several where it is not clear.
std::vector<const Group*> likeliest(const std::vector<Group>& groups, bool onePart) {
    const auto isColor = [](const Group& g) { return colorOf(g).has_value(); };
    std::vector<const Group*> found =
        those(groups, [&](const Group& g) { return onePart && g.label.empty() && isColor(g); });
    if (found.size() == 1) return found;
    found = those(groups, [&](const Group& g) {
        const std::string name = lowerCase(afterLastDot(g.label));
        return isColor(g) && std::find(beautyNames.begin(), beautyNames.end(), name) != beautyNames.end();
    });
    return found.size() == 1 ? found : those(groups, isColor);
}

} // namespace

std::optional<ImageLayer> chooseLayer(const std::vector<ImagePart>& parts, const LayerChoice& choice,
                                      Error& error) {
    std::vector<Group> groups = groupsOf(parts);
    tellApart(groups, parts);
    if (!choice.name.empty()) return named(groups, choice, error);
    const std::vector<const Group*> found = likeliest(groups, parts.size() == 1);
    if (found.size() == 1) return colorOf(*found.front());
    if (found.size() > 1) {
        error.text =
            "holds several layers of colour, expected " + choice.option + " with one of " + labels(found);
        return std::nullopt;
    }
    if (choice.anyChannel && groups.size() == 1 && groups.front().channels.size() == 1)
        return anyOf(groups.front());
    const bool chroma = std::any_of(groups.begin(), groups.end(), isLuminanceChroma);
    std::vector<std::string> channels;
    for (const ImagePart& part : parts)
        channels.insert(channels.end(), part.channels.begin(), part.channels.end());
    error.text = (chroma ? "holds luminance and chroma, " : "holds no colour, only ") + list(channels) +
                 ", expected R, G, B or Y";
    return std::nullopt;
}

} // namespace demos
