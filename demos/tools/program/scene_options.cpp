#include "program/scene_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "host/water/quality.h"
#include "program/compare/values.h"
#include "scene/nearest.h"

namespace demos {

void describeQuality(CLI::App& command, RawScene& raw) {
    command
        .add_option("--quality", raw.quality,
                    "low, medium, high or highest: sets what costs of the water; --set comes after it")
        ->type_name("NAME");
}

void describePlain(CLI::App& command, RawScene& raw) {
    command.add_flag("--plain", raw.plain,
                     "Without air, bloom, glitter, detail of clouds and antialiasing, as what is measured: "
                     "EXR files, --aov, --stats");
}

void describeStrict(CLI::App& command, bool& strict) {
    command.add_flag("--strict", strict,
                     "An error where a mesh's file says what is not drawn so, instead of a warning");
}

void describeScene(CLI::App& command, RawScene& raw) {
    // Required ones are checked by hand, for errors that say what is expected.
    command.add_option("SCENE", raw.scene, "Scene file (TOML)");
    command.add_option("--size", raw.size, "Picture size, 1280x720 if not given")->type_name("WxH");
    command.add_option("--time", raw.time, "Time of the waves, the scene's if not given")
        ->type_name("SECONDS");
    command
        .add_option(
            "--camera", raw.camera,
            "One of the scene's cameras, its first if not given; random:7 is a view that nobody chose")
        ->type_name("NAME");
    command
        .add_option("--set", raw.overrides,
                    "Override a scene value: water.waves.wind_m_s=12, camera.low.roll_deg=5, mesh.0.scale=2")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false)
        ->type_name("PATH=VALUE");
    command
        .add_option("--sky", raw.sky,
                    "Lat-long HDR or EXR instead of the scene's sky, and its brightest spot instead of the "
                    "scene's sun, unless --set says one of sun.*")
        ->type_name("FILE");
    describeStrict(command, raw.strict);
    command.add_option("--mesh", raw.mesh, "glTF at the origin instead of the scene's meshes")
        ->type_name("FILE");
}

bool checkScene(const RawScene& raw, const char* expected, RenderOptions& out, Error& error) {
    if (raw.scene.empty()) {
        error.text = std::string("no scene, expected ") + expected;
        return false;
    }
    out.scene = raw.scene;
    if (!raw.size.empty()) {
        const std::optional<Size> size = parseSize("--size", raw.size, error);
        if (!size) return false;
        out.size = *size;
    }
    if (!raw.time.empty()) {
        out.timeS = parseNumber("--time", raw.time, -1e9, 1e9, "a number of seconds, -1e9 to 1e9", error);
        if (!out.timeS) return false;
    }
    if (!raw.quality.empty() && !isOneOf("--quality", raw.quality, qualities(), error)) return false;
    out.quality = raw.quality;
    out.camera = raw.camera;
    out.overrides = raw.overrides;
    out.sky = raw.sky;
    out.mesh = raw.mesh;
    out.strict = raw.strict;
    return true;
}

bool sets(const std::vector<std::string>& overrides, const std::string& path) {
    return std::ranges::any_of(overrides, [&](const std::string& text) {
        return text.starts_with(path + ".") || text.starts_with(path + "=");
    });
}

} // namespace demos
