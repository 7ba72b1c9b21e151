#include "measure/subject.h"

#include <algorithm>

#include "host/water/quality.h"
#include "scene/camera_choice.h"
#include "scene/offset.h"
#include "scene/without.h"

namespace demos::measure {

namespace {

std::optional<Scene> sceneWith(const Technique& technique, const std::string& surface,
                               const SubjectDesc& desc, Error& error) {
    std::vector<std::string> overrides = desc.overrides;
    for (const std::string& setting : technique.settings)
        overrides.push_back(surface + ".reflection." + setting);
    std::optional<Scene> scene = loadScene(desc.file, overrides, error);
    if (!scene) return std::nullopt;
    // No override takes a part away.
    if (!technique.part && scene->water) scene->water->reflection.reset();
    if (!technique.part && scene->floor) scene->floor->reflection.reset();
    if (technique.isPreset) setQuality(technique.quality, *scene->water);
    if (desc.flat && scene->water) takeWaves(*scene->water);
    if (scene->water) takeUntraced(*scene->water);
    return scene;
}

bool chooseCameras(const Scene& scene, const SubjectDesc& desc, std::vector<CameraDesc>& cameras,
                   Error& error) {
    if (desc.cameras.empty()) {
        cameras = scene.cameras;
        if (desc.firstCameraOnly) cameras.resize(1);
        return true;
    }
    for (const std::string& name : desc.cameras) {
        const std::optional<CameraDesc> camera = chooseCamera(scene, name, error);
        if (!camera) return false;
        cameras.push_back(*camera);
    }
    return true;
}

CameraDesc moved(CameraDesc camera) {
    Scene ignored;
    applyOffset(ignored, camera);
    return camera;
}

/// Those that the scene's surface can have.
std::vector<const Technique*> techniquesFor(const Scene& scene, const std::vector<const Technique*>& asked) {
    std::vector<const Technique*> fitting = asked;
    if (!scene.water) std::erase_if(fitting, [](const Technique* technique) { return technique->isPreset; });
    return fitting;
}

Subject movedBy(const Vec3& offsetM, const std::vector<Scene>& scenes,
                const std::vector<const Technique*>& techniques, const std::string& file) {
    Subject subject;
    subject.file = file;
    subject.offsetM = offsetM;
    for (size_t i = 0; i < scenes.size(); ++i) {
        Scene scene = scenes[i];
        CameraDesc camera;
        camera.offsetM = offsetM;
        applyOffset(scene, camera);
        subject.variants.push_back({techniques[i], *surfaceOf(scene)});
        if (i == 0) subject.scene = std::move(scene);
    }
    return subject;
}

} // namespace

std::optional<std::vector<Subject>> readSubjects(const SubjectDesc& desc, Error& error) {
    const std::optional<Scene> plain = loadScene(desc.file, desc.overrides, error);
    if (!plain) return std::nullopt;
    // An override of its reflection would give it a surface.
    if (!surfaceOf(*plain)) {
        error.text = desc.file.string() + ": has neither water nor floor, expected [water] or [floor]";
        return std::nullopt;
    }
    std::vector<CameraDesc> cameras;
    if (!chooseCameras(*plain, desc, cameras, error)) return std::nullopt;
    const std::vector<const Technique*> techniques = techniquesFor(*plain, desc.techniques);
    if (techniques.empty()) {
        error.text = desc.file.string() + ": has a floor, expected [water] for the technique 'water'";
        return std::nullopt;
    }
    std::vector<Scene> scenes; // one for each technique
    for (const Technique* const technique : techniques) {
        std::optional<Scene> scene = sceneWith(*technique, plain->water ? "water" : "floor", desc, error);
        if (!scene) return std::nullopt;
        scenes.push_back(std::move(*scene));
    }
    std::vector<Subject> subjects;
    for (const CameraDesc& camera : cameras) {
        auto subject = std::find_if(subjects.begin(), subjects.end(),
                                    [&](const Subject& known) { return known.offsetM == camera.offsetM; });
        if (subject == subjects.end())
            subject =
                subjects.insert(subject, movedBy(camera.offsetM, scenes, techniques, desc.file.string()));
        subject->cameras.push_back(moved(camera));
    }
    return subjects;
}

} // namespace demos::measure
