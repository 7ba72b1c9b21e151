// A scene file as plain data: what to draw, from where, in what light. Metres, seconds, degrees; +Y up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/floor.h"
#include "scene/surroundings.h"
#include "seaglass/water.h"

namespace demos {

/// Waves from afar: seaglass::SwellDesc.
struct SwellDesc {
    double heightM = 1;
    double periodS = 12;
    double towardsDeg = 0; ///< from +X towards +Z
    double bandwidth = 0.08;
    double spreading = 50;
};

struct WavesDesc {
    static constexpr uint32_t noForce = 13;

    std::string spectrum = "jonswap";    ///< one of seaglass::spectrumModels
    std::filesystem::path spectrumTable; ///< CSV of `table`: Hz, m^2/Hz; absolute
    uint32_t beaufort = noForce;         ///< sets wind, fetch and the first swell in place of those here
    double windMps = 10;
    double windTowardsDeg = 0; ///< from +X towards +Z
    double fetchM = 300e3;
    bool capFetch = true;
    double depthM = std::numeric_limits<double>::infinity(); ///< deep unless it is said
    double peakEnhancement = 3.3;
    std::string spreading = "hasselmann"; ///< one of seaglass::spreadingModels
    double spreadingShape = 5;            ///< s of cos2s
    double swell = 0;
    std::vector<SwellDesc> swells;
    double amplitude = 1;
    double choppiness = 1;
    uint32_t samples = 256;
    uint32_t cascades = 3;
    double largestPatchM = 0;
    double warp = 1;
    uint64_t seed = 1;
    std::string backend = "automatic"; ///< automatic | gpu | fftw: where they are computed
};

struct RefractionDesc {
    std::string type;       ///< pool | clear-ocean | coastal | turbid, or empty: the coefficients that follow
    Vec3 tint = {0, 0, 0};  ///< with a visibility, in place of them: seaglass::tintedWater()
    double visibilityM = 0; ///< 0: no tint
    Vec3 absorptionPerM = {0.345, 0.0622, 0.0253};
    Vec3 backscatterPerM = {0.0011, 0.0016, 0.0030};
    double distortion = 1;
    double scatteringPerM = 0;
};

/// What water covers: seaglass::ExtentDesc. It is moved by `centerM` and turned about it.
struct ExtentDesc {
    std::string shape = "rectangle"; ///< rectangle | polygon | mesh
    Vec2 centerM = {0, 0};
    double yawDeg = 0;          ///< about +Y, as a mesh's
    Vec2 sizeM = {0, 0};        ///< of a rectangle
    std::vector<Vec2> pointsM;  ///< of a polygon
    std::filesystem::path file; ///< of a mesh: glTF, whose heights do not count; absolute
    std::string where = {};     ///< of `file` in the scene, for errors
};

/// What waves run up: seaglass::ShoreDesc, as the highest of a mesh at each sample.
struct ShoreDesc {
    std::filesystem::path file; ///< glTF, absolute
    Vec3 positionM = {0, 0, 0};
    double spacingM = 1;
    std::string where = {}; ///< of `file` in the scene, for errors
};

struct WaterDesc {
    double levelM = 0;         ///< over the origin, where it is tilted
    double tiltDeg = 0;        ///< of its surface; its extent then lies along the plane's own axes
    double tiltTowardsDeg = 0; ///< where that falls to, from +X towards +Z
    double planetRadiusM = 0;  ///< that it falls away on, without an extent; 0: flat
    seaglass::MeshDesc mesh;
    seaglass::ShadingDesc shading;
    bool saysGlitter = false;         ///< else its 0 is what addPhotographicDefaults() makes of it
    bool saysWaveShadows = false;     ///< likewise
    std::optional<ExtentDesc> extent; ///< none: to the horizon
    std::optional<WavesDesc> waves;
    std::optional<ShoreDesc> shore; ///< none: no bed is felt
    std::optional<seaglass::FoamDesc> foam;
    std::optional<RefractionDesc> refraction;
    std::optional<seaglass::ReflectionDesc> reflection;
    std::optional<seaglass::UnderwaterDesc> underwater;
    std::optional<seaglass::CausticsDesc> caustics;
    std::optional<seaglass::SprayDesc> spray;
    std::optional<seaglass::BedDesc> bed; ///< none: refraction sees what the picture shows
    bool bedDrawn = true;                 ///< false: as without a bed
    std::vector<ExclusionVolumeDesc> exclusionVolumes;
};

struct Scene {
    std::filesystem::path file;
    std::string title;
    double timeS = 0;
    double exposureEv = 0; ///< stops added before tone mapping
    SkyDesc sky;
    SunDesc sun;
    std::optional<FogDesc> fog;
    std::vector<MeshDesc> meshes;
    std::optional<WaterDesc> water;  ///< or
    std::optional<FloorDesc> floor;  ///< but not both
    std::vector<CameraDesc> cameras; ///< at least one; the first is the default
    std::vector<std::string> notes;  ///< what of the file is out of date, a line each
};

/// The surface that mirrors.
using SurfaceDesc = std::variant<WaterDesc, FloorDesc>;

/// Null when there is none.
inline std::optional<SurfaceDesc> surfaceOf(const Scene& scene) {
    if (scene.water) return *scene.water;
    if (scene.floor) return *scene.floor;
    return std::nullopt;
}

/// Reads a scene file, with "path=value" overrides (values in TOML syntax; a bare word is taken as a string)
/// applied before it is checked. A camera is addressed by name: camera.low.vertical_fov_deg=60.
std::optional<Scene> loadScene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                               Error& error);

/// What photographs show, where the file does not say it: haze, water that glitters, and waves of an open sea
/// that hide sky and sun from each other.
void addPhotographicDefaults(Scene& scene);

/// A setting of the water among these.
struct PhotographicDefault {
    std::string_view key;
    bool WaterDesc::*isSaid;
    void (*unset)(WaterDesc&); ///< gives it a value that no file holds
};
std::span<const PhotographicDefault> photographicDefaults();

} // namespace demos
