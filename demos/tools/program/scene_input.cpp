#include "program/scene_input.h"

#include <algorithm>

#include "host/water/quality.h"
#include "program/render/output.h"
#include "program/scene_options.h"
#include "scene/reading/input_file.h"

namespace demos {

namespace fs = std::filesystem;

namespace {

bool canBeRead(const std::string& option, const fs::path& file, const std::string& expected, Error& error) {
    const std::string why = unreadable(file);
    if (why.empty()) return true;
    error.text = option + " " + file.string() + ": " + why + ", expected " + expected;
    return false;
}

/// What the quality sets, to go before the overrides that are given by hand.
bool addQuality(const RenderOptions& options, std::vector<std::string>& overrides, Error& error) {
    if (options.quality.empty()) return true;
    const std::optional<Scene> plain = loadScene(options.scene, overrides, error);
    if (!plain) return false;
    if (!plain->water) {
        error.text = "--quality " + options.quality + ": " + options.scene.string() + " has no [water]";
        return false;
    }
    for (std::string& setting : qualityOverrides(options.quality, *plain->water))
        overrides.push_back(std::move(setting));
    return true;
}

} // namespace

std::optional<Scene> readScene(const RenderOptions& options, Error& error) {
    std::vector<std::string> overrides;
    const bool sky = !options.sky.empty(), mesh = !options.mesh.empty();
    if (sky) {
        if (!canBeRead("--sky", options.sky, "a lat-long HDR or EXR file", error)) return std::nullopt;
        overrides.push_back("sky.file=" + fs::absolute(options.sky).string());
        overrides.push_back("sky.layer=''");
        overrides.push_back("sky.clear=false");
        overrides.push_back("sky.detail=0"); // it may be of more than clouds
        // The scene's sun is that of the scene's sky.
        if (!sets(options.overrides, "sun")) overrides.push_back("sun.from_sky=true");
    }
    if (mesh) {
        if (!canBeRead("--mesh", options.mesh, "a glTF file", error)) return std::nullopt;
        overrides.push_back("mesh=[{}]");
        overrides.push_back("mesh.0.file=" + fs::absolute(options.mesh).string());
    }
    if (!addQuality(options, overrides, error)) return std::nullopt;
    overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
    std::optional<Scene> scene = loadScene(options.scene, overrides, error);
    if (scene && sky) scene->sky.where = "--sky";
    if (scene && mesh && !scene->meshes.empty()) scene->meshes.front().where = "--mesh";
    if (scene && options.lens) addPhotographicDefaults(*scene);
    return scene;
}

std::vector<fs::path> sceneFiles(const Scene& scene) {
    std::vector<fs::path> files = {scene.file};
    if (!scene.sky.file.empty()) files.push_back(scene.sky.file);
    for (const MeshDesc& mesh : scene.meshes) files.push_back(mesh.file);
    if (scene.floor && !scene.floor->texture.empty()) files.push_back(scene.floor->texture);
    return files;
}

bool checkPictures(const RenderOptions& options, const Scene& scene, Error& error) {
    const std::vector<fs::path> inputs = sceneFiles(scene);
    for (const fs::path& file : options.outputs) {
        const fs::path first = options.numbered ? numbered(file, 0) : file;
        if (!checkOutput("-o", first, {".png", ".exr"}, error)) return false;
        if (!checkApart("-o", first, inputs, error)) return false;
    }
    return true;
}

void addPlace(const Scene& scene, Error& error) {
    const auto prefix = [&error](const fs::path& file, const std::string& where) {
        const bool names = error.text.find(file.filename().string()) != std::string::npos;
        if (!names || where.empty() || error.text.starts_with(where)) return false;
        error.text = where + ": " + error.text;
        return true;
    };
    if (prefix(scene.sky.file, scene.sky.where)) return;
    if (scene.floor && !scene.floor->texture.empty() && prefix(scene.floor->texture, scene.floor->where))
        return;
    for (const MeshDesc& mesh : scene.meshes) {
        if (prefix(mesh.file, mesh.where)) return;
    }
}

} // namespace demos
