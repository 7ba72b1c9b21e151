#include "program/measure/left_out.h"

#include <algorithm>
#include <cstdio>

#include "program/scene_input.h"

namespace demos {

bool sayLeftOut(const std::vector<std::string>& leftOut, const Scene& scene, bool strict, Error& error) {
    for (const std::string& note : scene.notes) std::fprintf(stderr, "warning: %s\n", note.c_str());
    for (const std::string& line : leftOut) {
        Error placed{line};
        addPlace(scene, placed);
        std::replace(placed.text.begin(), placed.text.end(), '\n', ' '); // of a file's name
        if (strict) {
            const size_t more = leftOut.size() - 1;
            error.text = "--strict: " + placed.text;
            if (more > 0) error.text += "; and " + std::to_string(more) + " more, which are said without it";
            return false;
        }
        std::fprintf(stderr, "warning: %s\n", placed.text.c_str());
    }
    return true;
}

} // namespace demos
