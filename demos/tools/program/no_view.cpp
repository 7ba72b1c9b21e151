// In place of view.cpp where the packages of the window were not found.
#include "program/view.h"

namespace demos {

ExitCode viewScene(const ViewOptions&, Error& error) {
    error.text = "this seaglass was built without its viewer, expected GLFW and Dear ImGui when it is built "
                 "(Debian: libglfw3-dev, libimgui-dev; SEAGLASS_VIEWER=ON); seaglass render draws to files";
    return badInput;
}

} // namespace demos
