#include "scene/scene.h"

#include <algorithm>
#include <system_error>

#include "scene/fields.h"
#include "scene/input_limits.h"
#include "scene/reading/checks.h"
#include "scene/reading/former_names.h"
#include "scene/reading/input_file.h"
#include "scene/reading/overrides.h"
#include "scene/reading/places.h"
#include "scene/reading/reader.h"
#include "scene/reading/short_keys.h"
#include "scene/reading/toml.h"

namespace demos {

namespace {

namespace fs = std::filesystem;
using namespace reading;

/// Where meshes and sky were named, for those who will find out whether they can be read.
void rememberPlaces(Scene& scene, const toml::table& root, const std::string& file) {
    if (!scene.sky.file.empty()) scene.sky.where = place(*root["sky"]["file"].node(), file) + ": sky.file";
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
        scene.meshes[i].where =
            place(*root["mesh"][i]["file"].node(), file) + ": mesh." + std::to_string(i) + ".file";
    }
    if (scene.water && scene.water->extent && !scene.water->extent->file.empty())
        scene.water->extent->where =
            place(*root["water"]["extent"]["file"].node(), file) + ": water.extent.file";
    if (scene.water && scene.water->shore)
        scene.water->shore->where =
            place(*root["water"]["shore"]["file"].node(), file) + ": water.shore.file";
    if (scene.floor && !scene.floor->texture.empty())
        scene.floor->where = place(*root["floor"]["texture"].node(), file) + ": floor.texture";
}

std::optional<std::string> readText(const fs::path& file, Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = file.string() + ": " + what;
        return std::nullopt;
    };
    std::error_code code;
    if (const uintmax_t size = fs::file_size(file, code); !code && size > limits::sceneBytes)
        return fail("has " + std::to_string(size) + " bytes, expected a scene of at most 1 MB");
    std::string text, problem;
    if (!readWhole(file, limits::sceneBytes, text, problem))
        return fail(problem + ", expected a scene (TOML)");
    return text;
}

} // namespace

std::optional<Scene> loadScene(const fs::path& file, const std::vector<std::string>& overrides,
                               Error& error) {
    const std::optional<std::string> text = readText(file, error);
    if (!text) return std::nullopt;

    if (!hasShortKeys(*text)) {
        error.text = file.string() + ": has a key of over 16 parts, expected a scene (TOML)";
        return std::nullopt;
    }
    toml::parse_result parsed = toml::parse(*text, file.string());
    if (!parsed) {
        std::string what(parsed.error().description());
        std::replace(what.begin(), what.end(), '\n', ' ');
        error.text = place(parsed.error().source(), file.string()) + ": not valid TOML: " + what;
        return std::nullopt;
    }
    toml::table& root = parsed.table();

    Scene scene;
    renameFormer(root, sceneSection(), "", file.string(), scene.notes);
    if (!applyOverrides(root, overrides, scene.notes, error)) return std::nullopt;

    scene.file = fs::absolute(file).lexically_normal();
    Reader reader(file, error);
    if (!reader.read(root, sceneSection(), &scene, "", "")) return std::nullopt;
    if (!goTogether(scene, root, reader)) return std::nullopt;
    if (scene.water)
        for (const PhotographicDefault& usual : photographicDefaults())
            (*scene.water).*usual.isSaid = root["water"].as_table()->contains(usual.key);
    rememberPlaces(scene, root, file.string());
    return scene;
}

} // namespace demos
