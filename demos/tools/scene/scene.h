// A scene file as plain data: what to draw, from where, in what light. Metres, seconds, degrees; +Y up.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
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
    double rotationDeg = 0;     ///< turns it about +Y
    double intensity = 1;       ///< radiance scale
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

struct MeshDesc {
    std::filesystem::path file; ///< glTF, absolute
    Vec3 positionM = {0, 0, 0};
    double yawDeg = 0;
    double scale = 1;
    std::string where = {}; ///< of `file` in the scene, for errors: "harbour.toml:21: mesh.0.file"
};

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

    std::string spectrum = "jonswap";    ///< jonswap | pierson-moskowitz | tma | phillips | table
    std::filesystem::path spectrumTable; ///< CSV of `table`: Hz, m^2/Hz; absolute
    uint32_t beaufort = noForce;         ///< sets wind, fetch and the first swell in place of those here
    double windMps = 10;
    double windTowardsDeg = 0; ///< from +X towards +Z
    double fetchM = 300e3;
    bool capFetch = true;
    double depthM = std::numeric_limits<double>::infinity(); ///< deep unless it is said
    double peakEnhancement = 3.3;
    std::string spreading = "hasselmann"; ///< hasselmann | mitsuyasu | donelan-banner | cos2s
    double spreadingShape = 5;            ///< s of cos2s
    double swell = 0;
    std::vector<SwellDesc> swells;
    double amplitude = 1;
    double choppiness = 1;
    uint32_t samples = 256;
    uint32_t cascades = 3;
    double largestPatchM = 0;
    uint64_t seed = 1;
    std::string backend = "automatic"; ///< automatic | gpu | fftw: where they are computed
};

struct FoamDesc {
    double bias = 0;
    double decayS = 3.85;
    double albedo = 0.6;
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

struct UnderwaterDesc {
    double meniscusM = 0.003;
};

struct CausticsDesc {
    double strength = 1;
    uint32_t stepPx = 1; ///< from one of the sun's rays to the next, each way
};

struct ReflectionDesc {
    std::string technique = "sspr"; ///< sky | sspr | ssr | hybrid | planar
    uint32_t downscale = 1;         ///< pixels of the picture to one of the reflection, each way
    uint32_t heightPx = 0;          ///< of the reflection, in the place of downscale; 0: by that
    bool coarseKeys = false;        ///< sspr: one key for 2 x 2 pixels
    double edgeFade = 0.08;
    bool edgeFadeAround = false;  ///< at all four borders
    double undersideLight = 0.15; ///< of undersides not seen, as a share of their tops
    uint32_t roofLooks = 0;       ///< sspr, hybrid: for what hangs over the water
    double distortion = 1;
    uint32_t blurLevels = 4;
    double clearDistanceM = 0;
    double scatter = 0;
    double skyFadeM = 0;
    double edgeReach = 0;
    double edgeStretchPerM = 0;
    double temporal = 0; ///< share of each pixel taken from the last frame
    // Of ssr and hybrid, as in seaglass/reflection.h.
    bool marchCells = true;
    uint32_t marchSteps = 64;
    double marchThicknessM = 1;
    double marchDistanceM = 10000;
    double marchJitter = 0;
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

/// A hollow that the water stays out of, as a boat's inside: walls along a convex outline, down to a bottom.
struct DryRoomDesc {
    Vec3 positionM = {0, 0, 0};
    double yawDeg = 0;         ///< about +Y, as a mesh's
    std::vector<Vec2> pointsM; ///< of the outline, from its position and at its height
    double flareDeg = 0;       ///< by which walls lean outwards
    double bottomM = -1;       ///< likewise
};

/// The bed as a picture of its own.
struct BedDesc {
    bool drawn = true;
    double margin = 0.1;    ///< by which it is larger on each side, of the picture's size
    uint32_t downscale = 1; ///< pixels of the picture to one of it, each way
};

struct WaterDesc {
    double levelM = 0;         ///< over the origin, where it is tilted
    double tiltDeg = 0;        ///< of its surface; its extent then lies along the plane's own axes
    double tiltTowardsDeg = 0; ///< where that falls to, from +X towards +Z
    double planetRadiusM = 0;  ///< that it falls away on, without an extent; 0: flat
    double cellM = 0.25;
    uint32_t cellsPerLevel = 128;
    uint32_t mirrorLooks = 2;
    uint32_t refractionLooks = 6;
    uint32_t slopeLooks = 1;
    uint32_t waveShadowSteps = 0;
    bool relief = false;
    std::string fresnel = "exact";    ///< exact | schlick
    std::optional<ExtentDesc> extent; ///< none: to the horizon
    std::optional<WavesDesc> waves;
    std::optional<ShoreDesc> shore; ///< none: no bed is felt
    std::optional<FoamDesc> foam;
    std::optional<RefractionDesc> refraction;
    std::optional<ReflectionDesc> reflection;
    std::optional<UnderwaterDesc> underwater;
    std::optional<CausticsDesc> caustics;
    std::optional<BedDesc> bed; ///< none: refraction sees what the picture shows
    std::vector<DryRoomDesc> dryRooms;
};

/// A polished floor, or a mirror: a rectangle of a plane, seen from its front alone.
struct FloorDesc {
    Vec3 pointM = {0, 0, 0};       ///< its middle
    Vec3 normal = {0, 1, 0};       ///< towards its front, of any length
    double widthM = 20;            ///< along +X if it is level, else along the horizontal
    double lengthM = 20;           ///< across that
    Vec3 color = {0.5, 0.5, 0.5};  ///< diffuse reflectance; scales the texture's
    std::filesystem::path texture; ///< PNG, absolute, or empty; its alpha says how polished each spot is
    double textureM = 2;           ///< what one repeat of the texture covers
    double reflectance = 0.04;     ///< of the mirror, seen straight on: Schlick's F0
    double roughness = 0;          ///< square root of GGX's alpha; 0: a mirror
    std::optional<ReflectionDesc> reflection;
    std::string where = {}; ///< of `texture` in the scene, for errors: "floor.toml:21: floor.texture"
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

    bool operator==(const CameraDesc&) const = default;
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

} // namespace demos
