#include "program/screenshots/frame_name.h"

#include "scene/parse_all.h"

namespace demos {

FrameName frameName(const std::string& stem) {
    const size_t end = stem.find_last_not_of("0123456789");
    if (end == stem.npos || end == 0 || stem.size() - end < 3) return {stem, {}};
    const char parting = stem[end];
    const std::optional<uint32_t> number = parseAll<uint32_t>(std::string_view(stem).substr(end + 1));
    if (!number || (parting != '_' && parting != '-' && parting != '.')) return {stem, {}};
    return {stem.substr(0, end), number};
}

} // namespace demos
