// What is measured of a scene: its cameras, and the water that each technique makes of its own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measure/technique.h"
#include "scene/scene.h"

namespace demos::measure {

struct SubjectDesc {
    std::filesystem::path file;
    std::vector<std::string> overrides;       ///< of the scene, before those of a technique
    std::vector<const Technique*> techniques; ///< at least one
    std::vector<std::string> cameras;         ///< empty takes all
    bool firstCameraOnly = false;             ///< instead of all
    bool flat = false;                        ///< no waves and no foam
};

/// The scene's water as one technique has it.
struct Variant {
    const Technique* technique = nullptr;
    WaterDesc water;
};

struct Subject {
    std::string file;         ///< as it was named
    Scene scene;              ///< with the water of the first variant
    Vec3 offsetM = {0, 0, 0}; ///< what it was moved by
    std::vector<CameraDesc> cameras;
    std::vector<Variant> variants; ///< one for each technique
};

/// One for each place that the cameras move the scene to, which most do not. Null with `error` set when the
/// file cannot be read, has no water, or lacks a camera that is named.
std::optional<std::vector<Subject>> readSubjects(const SubjectDesc& desc, Error& error);

} // namespace demos::measure
