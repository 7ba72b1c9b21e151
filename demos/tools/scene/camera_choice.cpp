#include "scene/camera_choice.h"

#include "scene/nearest.h"
#include "scene/parse_all.h"
#include "scene/random_camera.h"

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
    if (name.starts_with(randomCameraPrefix)) {
        const auto number = parseAll<uint32_t>(std::string_view(name).substr(randomCameraPrefix.size()));
        if (number) return randomCamera(scene, *number);
        error.text = "--camera is '" + name + "', expected a number after 'random:', 0 to 4294967295";
        return std::nullopt;
    }
    error.text = "--camera is '" + name + "', expected one of " + scene.file.filename().string() + ": " +
                 list + "; the nearest is " + std::string(nearest(name, names));
    return std::nullopt;
}

} // namespace demos
