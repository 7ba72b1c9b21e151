#include "program/compare/compare_notes.h"

#include <algorithm>
#include <cstdio>

namespace demos {

namespace {

constexpr size_t listed = 12;

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < std::min(names.size(), listed); ++i) text += (i ? " " : "") + names[i];
    return names.size() > listed ? text + " and " + std::to_string(names.size() - listed) + " more" : text;
}

bool isPlain(const ImageHeader& header) {
    return header.layer.empty() && header.others.empty() && header.data == header.display &&
           header.pixelAspect == 1 && header.encoding.empty();
}

std::string describe(const ImageHeader& header) {
    std::string text = list(header.color);
    if (!header.others.empty()) text += "; not compared: " + list(header.others);
    if (header.data != header.display)
        text += "; data window " + toText(header.data) + " of " + toText(header.display);
    if (header.pixelAspect != 1) {
        char aspect[48];
        std::snprintf(aspect, sizeof(aspect), "; pixels of aspect %.4g", header.pixelAspect);
        text += aspect;
    }
    if (!header.encoding.empty()) text += "; " + header.encoding;
    return text + "\n";
}

} // namespace

std::string compareNotes(const ImageHeader& reference, const ImageHeader& test) {
    const std::string ofReference = describe(reference), ofTest = describe(test);
    if (ofReference != ofTest) return "reference: " + ofReference + "test: " + ofTest;
    return isPlain(reference) ? "" : "both: " + ofReference;
}

} // namespace demos
