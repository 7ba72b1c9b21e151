#include "scene/reading/short_keys.h"

#include <algorithm>

#include "scene/input_limits.h"

namespace demos::reading {
namespace {

/// Where the string that begins at `at` is over; one of a line ends with that at the latest.
size_t endOfString(std::string_view text, size_t at) {
    const std::string_view three = text.substr(at, 3);
    const bool escapes = text[at] == '"', lines = three == "\"\"\"" || three == "'''";
    const std::string_view closing = lines ? three : text.substr(at, 1);
    for (at += closing.size(); at < text.size(); ++at) {
        if (text.substr(at).starts_with(closing)) {
            at += closing.size();
            // Up to two quotes may stand right before the closing ones.
            while (lines && at < text.size() && text[at] == closing[0]) ++at;
            return at;
        }
        if (text[at] == '\n' && !lines) return at;
        if (text[at] == '\\' && escapes) ++at;
    }
    return text.size();
}

} // namespace

bool hasShortKeys(std::string_view text) {
    constexpr std::string_view betweenKeys = "\n=,[{#";
    size_t dots = 0;
    for (size_t i = 0; i < text.size();) {
        if (text[i] == '"' || text[i] == '\'') {
            i = endOfString(text, i);
            continue;
        }
        if (betweenKeys.find(text[i]) != betweenKeys.npos) dots = 0;
        if (text[i] == '#') i = std::min(text.find('\n', i), text.size() - 1);
        if (text[i] == '.' && ++dots >= limits::sceneKeyParts) return false;
        ++i;
    }
    return true;
}

} // namespace demos::reading
