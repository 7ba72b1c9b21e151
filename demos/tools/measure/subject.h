// What is measured of a scene: its cameras, and what each technique makes of the surface that mirrors.
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
    bool flat = false;                        ///< water without waves and foam
};

/// The scene's surface as one technique has it.
struct Variant {
    const Technique* technique = nullptr;
    SurfaceDesc surface;
};

struct Subject {
    std::string file;         ///< as it was named
    Scene scene;              ///< with the surface of the first variant
    Vec3 offsetM = {0, 0, 0}; ///< what it was moved by
    std::vector<CameraDesc> cameras;
    std::vector<Variant> variants; ///< one for each technique
};

/// One for each place that the cameras move the scene to, which most do not. Null with `error` set when the
/// file cannot be read, has no surface that mirrors, or lacks a camera that is named.
std::optional<std::vector<Subject>> readSubjects(const SubjectDesc& desc, Error& error);

} // namespace demos::measure
