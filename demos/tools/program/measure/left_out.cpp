#include "program/measure/left_out.h"

#include <cstdio>

#include "host/one_line.h"
#include "program/scene_input.h"

namespace demos {

bool sayLeftOut(const std::vector<std::string>& leftOut, const Scene& scene, bool strict, Error& error) {
    for (const std::string& note : scene.notes) std::fprintf(stderr, "warning: %s\n", oneLine(note).c_str());
    for (const std::string& line : leftOut) {
        Error placed{line};
        addPlace(scene, placed);
        if (strict) {
            const size_t more = leftOut.size() - 1;
            error.text = "--strict: " + placed.text;
            if (more > 0) error.text += "; and " + std::to_string(more) + " more, which are said without it";
            return false;
        }
        std::fprintf(stderr, "warning: %s\n", oneLine(placed.text).c_str()); // of any file's names
    }
    return true;
}

} // namespace demos
