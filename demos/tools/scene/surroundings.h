// What surrounds a scene's water or floor: light, air, meshes, cameras. Metres, seconds, degrees; +Y up.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace demos {

using Vec2 = std::array<double, 2>; ///< x and z
using Vec3 = std::array<double, 3>;

/// A place in a file and what is wrong there: "harbour.toml:12: water.waves.wind_m_s is -3, expected 0 to
/// 100".
struct Error {
    std::string text;
};

struct SkyDesc {
    std::filesystem::path file; ///< lat-long HDR or EXR, absolute
    std::string layer = {};     ///< of an EXR with several; empty: the one that is the picture
    bool clear = false;         ///< computed for the sun's place instead, and the sun's irradiance with it
    double haze = 2;            ///< of a clear sky: 1 is clean air
    double rotationDeg = 0;     ///< turns it about +Y
    double intensity = 1;       ///< radiance scale
    double detail = 0;          ///< of clouds, finer than the picture's texels: 1 as ragged as cumulus is
    std::string where = {};     ///< of `file` in the scene, for errors: "harbour.toml:9: sky.file"
};

struct SunDesc {
    /// Take direction and irradiance from the brightest spot of the sky, and that spot out of the sky; the
    /// rest here is ignored. Otherwise the sky stays as it is.
    bool fromSky = false;
    double azimuthDeg = 0;    ///< of the sun, from +X towards +Z
    double elevationDeg = 30; ///< above the horizon
    Vec3 irradiance = {3, 3, 3};
};

/// seaglass::FogDesc, with the host's own of the same.
struct FogDesc {
    std::string shape = "exponential"; ///< linear | exponential | exponential-squared | height
    double densityPerM = 1e-3;         ///< of all but linear; of height at its base
    double startM = 0, endM = 1000;    ///< of linear
    double falloffPerM = 0.01;         ///< of height
    double baseHeightM = 0;            ///< of height
    Vec3 color = {0.5, 0.5, 0.5};
    double fromSky = 0; ///< share of its colour that is the sky's
    double most = 1;    ///< share of light that it takes
    bool overSky = true;
};

/// A hollow that the water stays out of, as a boat's inside: walls along a convex outline, down to a bottom.
struct ExclusionVolumeDesc {
    Vec3 positionM = {0, 0, 0};
    double yawDeg = 0;         ///< about +Y, as a mesh's
    std::vector<Vec2> pointsM; ///< of the outline, from its position and at its height
    double flareDeg = 0;       ///< by which walls lean outwards
    double bottomM = -1;       ///< likewise
};

/// Where a mesh is later than at time 0.
struct MeshKeyframe {
    double timeS = 0;
    Vec3 positionM = {0, 0, 0};
    double yawDeg = 0;
};

struct MeshDesc {
    std::filesystem::path file; ///< glTF, absolute
    Vec3 positionM = {0, 0, 0};
    double yawDeg = 0;
    double scale = 1;
    bool floats = false; ///< it heaves, pitches and rolls with the water
    bool loops = false;  ///< from the last keyframe on, where it began, all anew
    std::vector<MeshKeyframe> keyframes;
    std::vector<ExclusionVolumeDesc> exclusionVolumes; ///< in the mesh's own axes
    std::string where = {}; ///< of `file` in the scene, for errors: "harbour.toml:21: mesh.0.file"
};

/// Where a camera is later than at time 0.
struct CameraKeyframe {
    double timeS = 0;
    Vec3 positionM = {0, 2, 0};
    Vec3 targetM = {0, 2, -1};
    double rollDeg = 0;

    bool operator==(const CameraKeyframe&) const = default;
};

struct CameraDesc {
    std::string name;
    Vec3 positionM = {0, 2, 0};
    Vec3 targetM = {0, 2, -1};
    double rollDeg = 0;
    double verticalFovDeg = 45;
    double orthographicHeightM = 0; ///< of what parallel lines of sight show; 0: they come from the eye
    double nearM = 0.1;
    Vec3 offsetM = {0, 0, 0}; ///< added to every place in the scene, this camera's own included
    bool loops = false;       ///< from the last keyframe on, where it began, all anew
    std::vector<CameraKeyframe> keyframes;

    bool operator==(const CameraDesc&) const = default;
};

} // namespace demos
