#include "scene/camera_choice.h"

#include <charconv>

#include "scene/nearest.h"
#include "scene/random_camera.h"

namespace demos {

namespace {

constexpr std::string_view random = "random:";

std::optional<uint32_t> numberOf(std::string_view digits) {
    uint32_t number = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (problem != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return number;
}

} // namespace

std::optional<CameraDesc> chooseCamera(const Scene& scene, const std::string& name, Error& error) {
    if (name.empty()) return scene.cameras.front();
    std::vector<std::string_view> names;
    std::string list;
    for (const CameraDesc& camera : scene.cameras) {
        if (camera.name == name) return camera;
        names.push_back(camera.name);
        list += (list.empty() ? "" : ", ") + camera.name;
    }
    if (name.starts_with(random)) {
        const std::optional<uint32_t> number = numberOf(std::string_view(name).substr(random.size()));
        if (number) return randomCamera(scene, *number);
        error.text = "--camera is '" + name + "', expected a number after 'random:', 0 to 4294967295";
        return std::nullopt;
    }
    error.text = "--camera is '" + name + "', expected one of " + scene.file.filename().string() + ": " +
                 list + "; the nearest is " + std::string(nearest(name, names));
    return std::nullopt;
}

} // namespace demos
