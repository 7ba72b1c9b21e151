#include "scene/camera_choice.h"

#include "scene/nearest.h"

namespace demos {

std::optional<CameraDesc> chooseCamera(const Scene& scene, const std::string& name, Error& error) {
    if (name.empty()) return scene.cameras.front();
    std::vector<std::string_view> names;
    std::string list;
    for (const CameraDesc& camera : scene.cameras) {
        if (camera.name == name) return camera;
        names.push_back(camera.name);
        list += (list.empty() ? "" : ", ") + camera.name;
    }
    error.text = "--camera is '" + name + "', expected one of " + scene.file.filename().string() + ": " +
                 list + "; the nearest is " + std::string(nearest(name, names));
    return std::nullopt;
}

} // namespace demos
