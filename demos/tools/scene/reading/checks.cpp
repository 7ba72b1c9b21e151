#include "scene/reading/checks.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "scene/motion/motion.h"
#include "scene/reading/either_way.h"
#include "scene/reading/places.h"

namespace demos::reading {
namespace {

bool checkOrthographic(const Scene& scene, const CameraDesc& camera, const toml::table& table,
                       const std::string& path, Reader& reader) {
    if (camera.orthographicHeightM == 0) return true;
    const auto fail = [&](const char* why) {
        return reader.fail(place(*table.get("orthographic_height_m"), reader.file()),
                           path + ".orthographic_height_m is set, " + why);
    };
    if (table.contains("vertical_fov_deg"))
        return fail("expected no vertical_fov_deg then: a camera shows an angle or a height");
    return scene.floor ? fail("expected no [floor], which is seen from an eye") : true;
}

/// Keyframes come one after another, and what loops ends where it began.
template<class Moving>
bool checkKeyframes(const Moving& moving, const toml::table& table, const std::string& path, Reader& reader) {
    if (moving.keyframes.empty()) {
        return !moving.loops || reader.fail(place(*table.get("loops"), reader.file()),
                                            path + ".loops is true, expected keyframes to go through");
    }
    const auto keyframe = [&](size_t i) { return path + ".keyframes." + std::to_string(i); };
    const toml::array& tables = *table.get_as<toml::array>("keyframes");
    for (size_t i = 1; i < moving.keyframes.size(); ++i) {
        if (moving.keyframes[i].timeS > moving.keyframes[i - 1].timeS) continue;
        const toml::node& time = *tables[i].as_table()->get("time_s");
        return reader.fail(place(time, reader.file()), keyframe(i) + ".time_s is " + quote(time) +
                                                           ", expected a later time than that of " +
                                                           keyframe(i - 1));
    }
    if (!moving.loops || endsWhereItBegins(moving)) return true;
    return reader.fail(place(tables.back(), reader.file()),
                       keyframe(moving.keyframes.size() - 1) + " is elsewhere than " + path +
                           " begins, expected the same pose: " + path + ".loops is true");
}

bool checkCameras(const Scene& scene, const toml::table& root, Reader& reader) {
    const toml::array& tables = *root.get_as<toml::array>("camera");
    for (size_t i = 0; i < scene.cameras.size(); ++i) {
        const CameraDesc& camera = scene.cameras[i];
        const toml::table& table = *tables[i].as_table();
        const std::string path = "camera." + std::to_string(i);
        const auto first =
            std::find_if(scene.cameras.begin(), scene.cameras.end(),
                         [&camera](const CameraDesc& other) { return other.name == camera.name; });
        if (&*first != &camera) {
            return reader.fail(place(*table.get("name"), reader.file()),
                               path + ".name is '" + camera.name + "', expected a name that camera." +
                                   std::to_string(first - scene.cameras.begin()) + " does not have");
        }
        const double away =
            std::hypot(camera.targetM[0] - camera.positionM[0], camera.targetM[1] - camera.positionM[1],
                       camera.targetM[2] - camera.positionM[2]);
        if (away < 1e-6) {
            return reader.fail(place(*table.get("target_m"), reader.file()),
                               path + ".target_m is its position_m, expected a point away from the eye");
        }
        if (!checkOrthographic(scene, camera, table, path, reader)) return false;
        if (!checkKeyframes(camera, table, path, reader)) return false;
    }
    return true;
}

bool checkMeshes(const Scene& scene, const toml::table& root, Reader& reader) {
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
        const toml::table& table = *root["mesh"][i].as_table();
        const std::string path = "mesh." + std::to_string(i);
        if (!checkKeyframes(scene.meshes[i], table, path, reader)) return false;
        if (scene.meshes[i].floats && !(scene.water && scene.water->tiltDeg == 0))
            return reader.fail(place(*table.get("floats"), reader.file()),
                               path + ".floats is true, expected [water], and water.tilt_deg of 0");
    }
    return true;
}

bool checkWater(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || scene.water->waves) return true;
    if (scene.water->shore)
        return reader.fail(place(*root["water"]["shore"].node(), reader.file()),
                           "water.shore is set, expected [water.waves] too: it is they who run up a shore");
    if (!scene.water->foam) return true;
    return reader.fail(place(*root["water"]["foam"].node(), reader.file()),
                       "water.foam is set, expected [water.waves] too: foam comes from waves");
}

bool checkWaves(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || !scene.water->waves) return true;
    const WavesDesc& waves = *scene.water->waves;
    const toml::table& table = *root["water"]["waves"].as_table();
    constexpr size_t mostSwells = 4;
    const size_t most = waves.beaufort == WavesDesc::noForce ? mostSwells : mostSwells - 1;
    if (waves.swells.size() > most) {
        return reader.fail(place(*table.get("swells"), reader.file()),
                           "water.waves.swells are " + std::to_string(waves.swells.size()) +
                               ", expected at most " + std::to_string(most) +
                               (most < mostSwells ? ": beaufort has one of its own" : ""));
    }
    if (waves.spectrum != "table" || !waves.spectrumTable.empty()) return true;
    return reader.fail(place(*table.get("spectrum"), reader.file()),
                       "water.waves.spectrum is 'table', expected water.waves.spectrum_table too");
}

/// The first of `keys` that a table has, or null.
const char* firstOf(const toml::table& table, std::span<const char* const> keys) {
    const auto found = std::ranges::find_if(keys, [&](const char* key) { return table.contains(key); });
    return found == keys.end() ? nullptr : *found;
}

bool checkRefraction(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || !scene.water->refraction) return true;
    const toml::table& table = *root["water"]["refraction"].as_table();
    const char* const set = firstOf(table, colorByTint);
    if (!set) return true;
    const char* const other = firstOf(table, colorByWater);
    const auto fail = [&](const char* key, const std::string& expected) {
        return reader.fail(place(*table.get(key), reader.file()),
                           std::string("water.refraction.") + key + " is set, expected " + expected);
    };
    if (other)
        return fail(other, std::string("no water.refraction.") + set + " then: a water has one colour");
    for (const char* const key : colorByTint)
        if (!table.contains(key)) return fail(set, std::string("water.refraction.") + key + " too");
    return true;
}

bool checkExtent(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.water || !scene.water->extent) return true;
    if (scene.water->planetRadiusM != 0)
        return reader.fail(place(*root["water"]["planet_radius_m"].node(), reader.file()),
                           "water.planet_radius_m is set, expected no water.extent then: its water is level");
    const ExtentDesc& extent = *scene.water->extent;
    const char* missing = nullptr;
    if (extent.shape == "rectangle" && extent.sizeM[0] == 0) missing = "size_m";
    if (extent.shape == "polygon" && extent.pointsM.empty()) missing = "points_m";
    if (extent.shape == "mesh" && extent.file.empty()) missing = "file";
    if (!missing) return true;
    return reader.fail(place(*root["water"]["extent"].node(), reader.file()),
                       "water.extent is a " + extent.shape + ", expected water.extent." + missing + " too");
}

bool checkFloor(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.floor) return true;
    if (scene.water) {
        return reader.fail(place(*root["floor"].node(), reader.file()),
                           "floor is set, expected no [water] then: a scene has one surface that mirrors");
    }
    const Vec3& normal = scene.floor->normal;
    if (std::hypot(normal[0], normal[1], normal[2]) >= 1e-6) return true;
    return reader.fail(place(*root["floor"]["normal"].node(), reader.file()),
                       "floor.normal has no length, expected a direction, such as [0, 1, 0]");
}

bool checkSky(const Scene& scene, const toml::table& root, Reader& reader) {
    if (scene.sky.clear || !scene.sky.file.empty()) return true;
    return reader.fail(place(*root["sky"].node(), reader.file()),
                       "sky.file is missing, expected a lat-long HDR or EXR file, or sky.clear = true");
}

bool checkFog(const Scene& scene, const toml::table& root, Reader& reader) {
    if (!scene.fog || scene.fog->shape != "linear" || scene.fog->startM < scene.fog->endM) return true;
    const toml::table& table = *root["fog"].as_table();
    const char* const keys[] = {"start_m", "end_m"};
    const char* const set = firstOf(table, keys);
    return reader.fail(place(*table.get(set), reader.file()),
                       std::string("fog.") + set +
                           " leaves no way from fog.start_m to fog.end_m, expected a start before the end");
}

} // namespace

bool goTogether(const Scene& scene, const toml::table& root, Reader& reader) {
    return checkSky(scene, root, reader) && checkCameras(scene, root, reader) &&
           checkMeshes(scene, root, reader) && checkWater(scene, root, reader) &&
           checkRefraction(scene, root, reader) && checkExtent(scene, root, reader) &&
           checkWaves(scene, root, reader) && checkFloor(scene, root, reader) &&
           checkFog(scene, root, reader);
}

} // namespace demos::reading
