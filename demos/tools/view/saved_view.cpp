#include "view/saved_view.h"

#include <cstdio>

namespace demos {

namespace fs = std::filesystem;

namespace {

constexpr const char* viewName = "view";

} // namespace

Scene savedScene(const ViewState& state) {
    Scene scene = state.scene;
    scene.timeS = state.timeS;
    std::erase_if(scene.cameras, [](const CameraDesc& camera) { return camera.name == viewName; });
    CameraDesc camera = state.camera;
    camera.name = viewName;
    scene.cameras.insert(scene.cameras.begin(), std::move(camera));
    return scene;
}

fs::path freeName(const fs::path& folder, const std::string& stem, const std::string& extension) {
    for (unsigned number = 1;; ++number) {
        char digits[16];
        std::snprintf(digits, sizeof(digits), "_%04u", number);
        fs::path file = folder / (stem + digits + extension);
        std::error_code code;
        if (!fs::exists(file, code)) return file;
    }
}

} // namespace demos
