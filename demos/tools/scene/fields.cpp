#include "scene/fields.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "gpu/interface/fields/fog.h"
#include "reflection/interface/fields/reflection.h"
#include "scene/nearest.h"
#include "scene/settings.h"
#include "water/interface/fields/sea.h"
#include "water/interface/fields/water.h"

namespace demos {

namespace {

template<class Member>
struct MemberOf;
template<class Owner, class Type>
struct MemberOf<Type Owner::*> {
    using owner = Owner;
    using type = Type;
};

/// The address of a member, its owner's type taken from the member itself.
template<auto member>
Target at(void* owner) {
    return &(static_cast<typename MemberOf<decltype(member)>::owner*>(owner)->*member);
}

template<class T>
void* addressOf(T& value) {
    return &value;
}
template<class T>
void* addressOf(std::optional<T>& value) {
    return value ? &*value : &value.emplace();
}
template<class T>
void* addressOf(std::vector<T>& values) {
    return &values.emplace_back();
}

template<class T>
std::vector<void*> allOf(T& value) {
    return {&value};
}
template<class T>
std::vector<void*> allOf(std::optional<T>& value) {
    return value ? std::vector<void*>{&*value} : std::vector<void*>{};
}
template<class T>
std::vector<void*> allOf(std::vector<T>& values) {
    std::vector<void*> all;
    for (T& value : values) all.push_back(&value);
    return all;
}

template<auto member>
auto& of(void* owner) {
    return static_cast<typename MemberOf<decltype(member)>::owner*>(owner)->*member;
}

template<auto member>
constexpr Access open = {[](void* owner) { return addressOf(of<member>(owner)); },
                         [](void* owner) { return allOf(of<member>(owner)); }};

/// Of a child whose fields live in its owner's other members, too.
template<auto member>
constexpr Access beside = {
    [](void* owner) {
        of<member>(owner).emplace();
        return owner;
    },
    [](void* owner) { return of<member>(owner) ? std::vector<void*>{owner} : std::vector<void*>{}; }};

/// As a row of a table says, but in a member of the scene's own.
template<const seaglass::FieldTable& table, auto member>
consteval Field like(std::string_view name, std::string_view key,
                     std::span<const std::string_view> choices = {}) {
    return described(table, rowOf(table, name), key, at<member>, choices);
}

consteval Field upTo(double most, Field field) {
    field.most = most;
    return field;
}

consteval Field positive(Field field) {
    field.rule = Rule::positive;
    return field;
}

constexpr double far = 1e7; // metres, as of glTF: what is drawn is relative to the eye
constexpr double turn = 360;
constexpr bool required = true;

constexpr std::array<std::string_view, 3> backends = {"automatic", "gpu", "fftw"};
constexpr std::array<std::string_view, 4> waterTypes = {"pool", "clear-ocean", "coastal", "turbid"};

constexpr std::array skyFields = {
    Field{"file", at<&SkyDesc::file>, 0, 0, "", "lat-long HDR or EXR file"},
    Field{"layer", at<&SkyDesc::layer>, 0, 0, "", "of an EXR with several, or empty"},
    Field{"clear", at<&SkyDesc::clear>, 0, 0, "",
          "a clear sky of the sun's own elevation in place of a file, and the irradiance of such a sun"},
    Field{"haze", at<&SkyDesc::haze>, 0.1, 20, "", "of a clear sky: 1 clean air, 10 a hazy day"},
    Field{"rotation_deg", at<&SkyDesc::rotationDeg>, -turn, turn, "degrees",
          "turn about +Y, from +X towards +Z"},
    Field{"intensity", at<&SkyDesc::intensity>, 0, 1e6, "", "scale of the radiance"},
    Field{"detail", at<&SkyDesc::detail>, 0, 1, "",
          "how ragged clouds are between the file's texels, where those are larger than pixels"},
};

constexpr std::array sunFields = {
    Field{"from_sky", at<&SunDesc::fromSky>, 0, 0, "", "take the sun from the sky's brightest spot"},
    Field{"azimuth_deg", at<&SunDesc::azimuthDeg>, -turn, turn, "degrees", "from +X towards +Z"},
    Field{"elevation_deg", at<&SunDesc::elevationDeg>, -90, 90, "degrees", "above the horizon"},
    Field{"irradiance", at<&SunDesc::irradiance>, 0, 1e6, "", "red, green, blue"},
};

constexpr std::array fogFields = {
    like<seaglass::fogFields, &FogDesc::shape>("shape", "shape", wordsOf<seaglass::fogShapes>),
    like<seaglass::fogFields, &FogDesc::densityPerM>("density", "density_per_m"),
    upTo(1e8, like<seaglass::fogFields, &FogDesc::startM>("start", "start_m")),
    positive(like<seaglass::fogFields, &FogDesc::endM>("end", "end_m")),
    like<seaglass::fogFields, &FogDesc::falloffPerM>("falloff", "falloff_per_m"),
    like<seaglass::fogFields, &FogDesc::baseHeightM>("baseHeight", "base_height_m"),
    upTo(1e6, like<seaglass::fogFields, &FogDesc::color>("color", "color")),
    like<seaglass::fogFields, &FogDesc::fromSky>("fromSky", "from_sky"),
    like<seaglass::fogFields, &FogDesc::most>("most", "most"),
    like<seaglass::fogFields, &FogDesc::overSky>("overSky", "over_sky"),
};

constexpr std::array meshFields = {
    Field{"file", at<&MeshDesc::file>, 0, 0, "", "glTF file", required},
    Field{"position_m", at<&MeshDesc::positionM>, -far, far, "m", "of the mesh's origin"},
    Field{"yaw_deg", at<&MeshDesc::yawDeg>, -turn, turn, "degrees", "turn about +Y, from +X towards -Z"},
    Field{"scale", at<&MeshDesc::scale>, 0, 1e6, "", "size", false, Rule::positive},
    Field{"floats", at<&MeshDesc::floats>, 0, 0, "", "heave, pitch and roll with the water"},
    Field{"loops", at<&MeshDesc::loops>, 0, 0, "", "after the last keyframe, where it began, all anew"},
};

constexpr std::array meshKeyframeFields = {
    Field{"time_s", at<&MeshKeyframe::timeS>, 0, 1e6, "s", "when it is there", required, Rule::positive},
    Field{"position_m", at<&MeshKeyframe::positionM>, -far, far, "m", "of the mesh's origin", required},
    Field{"yaw_deg", at<&MeshKeyframe::yawDeg>, -turn, turn, "degrees",
          "turn about +Y, the short way from that before", required},
};

constexpr std::array wavesFields = {
    like<seaglass::seaFields, &WavesDesc::spectrum>("spectrum", "spectrum",
                                                    wordsOf<seaglass::spectrumModels>),
    Field{"spectrum_table", at<&WavesDesc::spectrumTable>, 0, 0, "", "CSV file of Hz and m^2/Hz"},
    Field{"beaufort", at<&WavesDesc::beaufort>, 0, 12, "", "force: wind, fetch and old waves at once"},
    like<seaglass::seaFields, &WavesDesc::windMps>("windSpeed", "wind_m_s"),
    Field{"wind_towards_deg", at<&WavesDesc::windTowardsDeg>, -turn, turn, "degrees",
          "where it blows towards, from +X towards +Z"},
    like<seaglass::seaFields, &WavesDesc::fetchM>("fetch", "fetch_m"),
    like<seaglass::seaFields, &WavesDesc::capFetch>("capFetch", "cap_fetch"),
    upTo(1e30, like<seaglass::seaFields, &WavesDesc::depthM>("depth", "depth_m")),
    like<seaglass::seaFields, &WavesDesc::peakEnhancement>("peakEnhancement", "peak_enhancement"),
    like<seaglass::seaFields, &WavesDesc::spreading>("spreading", "spreading",
                                                     wordsOf<seaglass::spreadingModels>),
    like<seaglass::seaFields, &WavesDesc::spreadingShape>("spreadingShape", "spreading_shape"),
    like<seaglass::seaFields, &WavesDesc::swell>("swell", "swell"),
    like<seaglass::seaFields, &WavesDesc::amplitude>("amplitude", "amplitude"),
    like<seaglass::seaFields, &WavesDesc::choppiness>("choppiness", "choppiness"),
    like<seaglass::seaFields, &WavesDesc::samples>("samples", "samples"),
    like<seaglass::seaFields, &WavesDesc::cascades>("cascades", "cascades"),
    like<seaglass::seaFields, &WavesDesc::largestPatchM>("largestPatch", "largest_patch_m"),
    like<seaglass::seaFields, &WavesDesc::warp>("warp", "warp"),
    // TOML's integers are signed.
    Field{"seed", at<&WavesDesc::seed>, 0, 9223372036854774784.0, "", "of the random phases"},
    Field{"backend", at<&WavesDesc::backend>, 0, 0, "", "what computes them", false, Rule::none, backends},
};

constexpr std::array swellFields = {
    like<seaglass::swellFields, &SwellDesc::heightM>("height", "height_m"),
    like<seaglass::swellFields, &SwellDesc::periodS>("peakPeriod", "period_s"),
    Field{"towards_deg", at<&SwellDesc::towardsDeg>, -turn, turn, "degrees",
          "where it runs towards, from +X towards +Z"},
    like<seaglass::swellFields, &SwellDesc::bandwidth>("bandwidth", "bandwidth"),
    like<seaglass::swellFields, &SwellDesc::spreading>("spreading", "spreading"),
};

constexpr std::array shoreFields = {
    Field{"file", at<&ShoreDesc::file>, 0, 0, "", "glTF file", required},
    Field{"position_m", at<&ShoreDesc::positionM>, -1e6, 1e6, "m", "of the mesh's origin"},
    like<seaglass::shoreFields, &ShoreDesc::spacingM>("spacing", "spacing_m"),
};

using FoamSettings = Settings<seaglass::foamFields, seaglass::FoamDesc>;
constexpr std::array foamFields =
    joined(FoamSettings::allBut<1>({"decayTime"}), std::array{FoamSettings::one("decayTime", "decay_s")});

constexpr std::array refractionFields = {
    Field{"type", at<&RefractionDesc::type>, 0, 0, "", "a real water's coefficients, whatever they are here",
          false, Rule::none, waterTypes},
    Field{"tint", at<&RefractionDesc::tint>, 0, 0.33, "",
          "what deep water sends back: linear red, green, blue", false, Rule::positive},
    Field{"visibility_m", at<&RefractionDesc::visibilityM>, 0.05, 1000, "m",
          "with tint: where 5 % of the clearest colour is left"},
    like<seaglass::refractionFields, &RefractionDesc::absorptionPerM>("absorption", "absorption_per_m"),
    like<seaglass::refractionFields, &RefractionDesc::backscatterPerM>("backscatter", "backscatter_per_m"),
    like<seaglass::refractionFields, &RefractionDesc::distortion>("distortion", "distortion"),
    like<seaglass::refractionFields, &RefractionDesc::scatteringPerM>("scattering", "scattering_per_m"),
};

/// Parts of the water whose sections hold their settings of ShadingDesc, too.
constexpr std::string_view bedPart = "bed", causticPart = "caustic", sprayPart = "spray";

using ShadingSettings = Settings<seaglass::shadingFields, WaterDesc, &WaterDesc::shading>;
using MeshSettings = Settings<seaglass::meshFields, WaterDesc, &WaterDesc::mesh>;

constexpr std::array underwaterFields =
    Settings<seaglass::underwaterFields, seaglass::UnderwaterDesc>::allBut();

constexpr std::array causticsFields =
    joined(Settings<seaglass::causticsFields, WaterDesc, &WaterDesc::caustics>::allBut(),
           ShadingSettings::of<causticPart>());

constexpr std::array sprayFields =
    joined(Settings<seaglass::sprayFields, WaterDesc, &WaterDesc::spray>::allBut<1>({"shutterTime"}),
           std::array{Settings<seaglass::sprayFields, WaterDesc, &WaterDesc::spray>::one("shutterTime",
                                                                                         "shutter_s")},
           ShadingSettings::of<sprayPart>());

constexpr std::array bedFields = joined(
    std::array{Field{"drawn", at<&WaterDesc::bedDrawn>, 0, 0, "", "false: as without"}},
    Settings<seaglass::bedFields, WaterDesc, &WaterDesc::bed>::allBut(), ShadingSettings::of<bedPart>());

using ReflectionSettings = Settings<seaglass::reflectionFields, seaglass::ReflectionDesc>;
constexpr std::array reflectionFields =
    joined(ReflectionSettings::allBut<1>({"skyFadeDistance"}),
           std::array{ReflectionSettings::one("skyFadeDistance", "sky_fade_m")});

constexpr std::array<std::string_view, 3> extentShapes = {"rectangle", "polygon", "mesh"};

constexpr std::array extentFields = {
    Field{"shape", at<&ExtentDesc::shape>, 0, 0, "", "what says where the water ends", false, Rule::none,
          extentShapes},
    Field{"center_m", at<&ExtentDesc::centerM>, -far, far, "m", "x and z of its middle, or its origin"},
    Field{"yaw_deg", at<&ExtentDesc::yawDeg>, -turn, turn, "degrees", "turn about +Y, from +X towards -Z"},
    Field{"size_m", at<&ExtentDesc::sizeM>, 0.01, 1e6, "m", "of a rectangle, along its x and z"},
    Field{"points_m", at<&ExtentDesc::pointsM>, -far, far, "m", "x and z of a polygon's corners"},
    Field{"file", at<&ExtentDesc::file>, 0, 0, "", "glTF file"},
};

constexpr std::array exclusionVolumeFields = {
    Field{"position_m", at<&ExclusionVolumeDesc::positionM>, -far, far, "m", "of its origin"},
    Field{"yaw_deg", at<&ExclusionVolumeDesc::yawDeg>, -turn, turn, "degrees",
          "turn about +Y, from +X towards -Z"},
    Field{"points_m", at<&ExclusionVolumeDesc::pointsM>, -1e3, 1e3, "m", "x and z of its outline's corners",
          required},
    Field{"flare_deg", at<&ExclusionVolumeDesc::flareDeg>, -80, 80, "degrees",
          "by which its walls lean outwards"},
    Field{"bottom_m", at<&ExclusionVolumeDesc::bottomM>, -1e3, 1e3, "m", "height of its bottom"},
};

constexpr std::array ownWaterFields = {
    Field{"level_m", at<&WaterDesc::levelM>, -1e5, 1e5, "m", "height of the calm surface, at the origin"},
    Field{"tilt_deg", at<&WaterDesc::tiltDeg>, 0, 80, "degrees", "of the calm surface, 0 level"},
    Field{"tilt_towards_deg", at<&WaterDesc::tiltTowardsDeg>, -turn, turn, "degrees",
          "where it falls to, from +X towards +Z"},
    Field{"planet_radius_m", at<&WaterDesc::planetRadiusM>, 1e6, 1e9, "m",
          "of the ball on which the open sea falls away, 0: flat", false, Rule::zeroOrRange},
};

constexpr std::array waterFields = joined(ownWaterFields, MeshSettings::allBut<1>({"cellSize"}),
                                          std::array{MeshSettings::one("cellSize", "cell_m")},
                                          ShadingSettings::butOf<bedPart, causticPart, sprayPart>());

constexpr std::array floorFields = {
    Field{"point_m", at<&FloorDesc::pointM>, -far, far, "m", "of its middle"},
    Field{"normal", at<&FloorDesc::normal>, -1e6, 1e6, "", "towards its front"},
    Field{"width_m", at<&FloorDesc::widthM>, 0, 1e5, "m", "along +X, or the horizontal", false,
          Rule::positive},
    Field{"length_m", at<&FloorDesc::lengthM>, 0, 1e5, "m", "across its width", false, Rule::positive},
    Field{"color", at<&FloorDesc::color>, 0, 1, "", "red, green, blue"},
    Field{"texture", at<&FloorDesc::texture>, 0, 0, "", "PNG file"},
    Field{"texture_m", at<&FloorDesc::textureM>, 1e-3, 1e4, "m", "what one repeat covers"},
    Field{"reflectance", at<&FloorDesc::reflectance>, 0, 1, "", "of the mirror, seen straight on"},
    Field{"roughness", at<&FloorDesc::roughness>, 0, 1, "", "0 a mirror, 1 matt"},
};

constexpr std::array cameraFields = {
    Field{"name", at<&CameraDesc::name>, 0, 0, "", "what --camera calls it", required, Rule::identifier},
    Field{"position_m", at<&CameraDesc::positionM>, -far, far, "m", "of the eye", required},
    Field{"target_m", at<&CameraDesc::targetM>, -far, far, "m", "a point looked at", required},
    Field{"roll_deg", at<&CameraDesc::rollDeg>, -turn, turn, "degrees", "about the view axis"},
    Field{"vertical_fov_deg", at<&CameraDesc::verticalFovDeg>, 1, 179, "degrees", "angle of view"},
    Field{"orthographic_height_m", at<&CameraDesc::orthographicHeightM>, 0.01, 1e4, "m",
          "of what parallel lines of sight show, in the place of an angle of view"},
    Field{"offset_m", at<&CameraDesc::offsetM>, -far, far, "m", "how far the whole scene is moved"},
    Field{"loops", at<&CameraDesc::loops>, 0, 0, "", "after the last keyframe, where it began, all anew"},
    Field{"near_m", at<&CameraDesc::nearM>, 1e-6, 1e3, "m", "distance of the near plane"},
};

constexpr std::array cameraKeyframeFields = {
    Field{"time_s", at<&CameraKeyframe::timeS>, 0, 1e6, "s", "when it is there", required, Rule::positive},
    Field{"position_m", at<&CameraKeyframe::positionM>, -far, far, "m", "of the eye", required},
    Field{"target_m", at<&CameraKeyframe::targetM>, -far, far, "m", "a point looked at", required},
    Field{"roll_deg", at<&CameraKeyframe::rollDeg>, -turn, turn, "degrees",
          "about the view axis, the short way from that before"},
};

constexpr std::array sceneFields = {
    Field{"title", at<&Scene::title>, 0, 0, "", "what it shows"},
    Field{"time_s", at<&Scene::timeS>, -1e9, 1e9, "s", "when it is drawn, unless --time says"},
    Field{"exposure_ev", at<&Scene::exposureEv>, -20, 20, "stops", "added before tone mapping"},
};

constexpr Section sky = {"sky", skyFields, {}, "the light from afar"};
constexpr Section sun = {"sun", sunFields, {}, "the light from one direction"};
constexpr Section fog = {"fog", fogFields, {}, "fog in the air; without it there is none"};
constexpr Section meshKeyframes = {
    "keyframes", meshKeyframeFields, {}, "where it is later; at time 0 it is where the mesh itself says"};
constexpr Section exclusionVolumes = {
    "exclusion_volumes",
    exclusionVolumeFields,
    {},
    "hollows without water, such as a boat's inside, eight at most; of a mesh, they go with it"};

constexpr std::array meshChildren = {
    Child{&meshKeyframes, open<&MeshDesc::keyframes>, true},
    Child{&exclusionVolumes, open<&MeshDesc::exclusionVolumes>, true},
};
constexpr Section mesh = {"mesh", meshFields, meshChildren, "a glTF model"};
constexpr Section swells = {"swells", swellFields, {}, "waves from afar, four systems at most"};
constexpr std::array wavesChildren = {Child{&swells, open<&WavesDesc::swells>, true}};
constexpr Section waves = {"waves", wavesFields, wavesChildren,
                           "the sea's waves; without it the water is flat"};
constexpr Section shore = {"shore", shoreFields, {}, "the bed that waves run up; without it they feel none"};
constexpr Section foam = {"foam", foamFields, {}, "foam on breaking waves"};
constexpr Section refraction = {
    "refraction", refractionFields, {}, "light that enters; without it the water is opaque"};
constexpr Section reflection = {
    "reflection", reflectionFields, {}, "what the surface mirrors; without it the sky alone"};

constexpr Section underwater = {
    "underwater", underwaterFields, {}, "the view from within; without it the water is seen from above"};
constexpr Section extent = {"extent", extentFields, {}, "what the water covers; without it, all"};

constexpr Section caustics = {
    "caustics", causticsFields, {}, "sunlight that waves gather below; without it light is even"};

constexpr Section spray = {
    "spray", sprayFields, {}, "drops that wind tears off breaking crests; without it there are none"};

constexpr Section bed = {
    "bed", bedFields, {}, "the bed drawn once more for refraction; without it, it sees the picture"};

constexpr std::array waterChildren = {
    Child{&extent, open<&WaterDesc::extent>},
    Child{&waves, open<&WaterDesc::waves>},
    Child{&shore, open<&WaterDesc::shore>},
    Child{&foam, open<&WaterDesc::foam>},
    Child{&refraction, open<&WaterDesc::refraction>},
    Child{&reflection, open<&WaterDesc::reflection>},
    Child{&underwater, open<&WaterDesc::underwater>},
    Child{&caustics, beside<&WaterDesc::caustics>},
    Child{&spray, beside<&WaterDesc::spray>},
    Child{&bed, beside<&WaterDesc::bed>},
    Child{&exclusionVolumes, open<&WaterDesc::exclusionVolumes>, true},
};

constexpr Section water = {"water", waterFields, waterChildren, "the water; without it there is none"};
constexpr std::array floorChildren = {Child{&reflection, open<&FloorDesc::reflection>}};
constexpr Section floor = {"floor", floorFields, floorChildren,
                           "a polished floor or a mirror, instead of water"};
constexpr Section cameraKeyframes = {
    "keyframes", cameraKeyframeFields, {}, "where it is later; at time 0 it is where the camera itself says"};
constexpr std::array cameraChildren = {Child{&cameraKeyframes, open<&CameraDesc::keyframes>, true}};
constexpr Section camera = {"camera", cameraFields, cameraChildren, "a place to look from"};

constexpr std::array sceneChildren = {
    Child{&sky, open<&Scene::sky>, false, required},
    Child{&sun, open<&Scene::sun>},
    Child{&fog, open<&Scene::fog>},
    Child{&mesh, open<&Scene::meshes>, true},
    Child{&water, open<&Scene::water>},
    Child{&floor, open<&Scene::floor>},
    Child{&camera, open<&Scene::cameras>, true, required},
};

constexpr Section scene = {"", sceneFields, sceneChildren, "a scene"};

std::string text(double value) {
    std::array<char, 32> out{};
    const auto end = std::to_chars(out.data(), out.data() + out.size(), value).ptr;
    return {out.data(), end};
}

std::string range(const Field& field) {
    std::string words = text(field.least) + " to " + text(field.most);
    if (field.rule == Rule::positive)
        words = "more than " + text(field.least) + ", up to " + text(field.most);
    if (field.rule == Rule::zeroOrRange) words = "0 or " + words;
    if (!field.unit.empty()) words.append(" ").append(field.unit);
    return words;
}

std::string wholeNumber(const Field& field) {
    return (field.rule == Rule::powerOfTwo ? "a power of two, " : "a whole number, ") + range(field);
}

struct Expectation {
    const Field& field;

    std::string operator()(const double*) const { return range(field); }
    std::string operator()(const Vec2*) const { return "two numbers, each " + range(field); }
    std::string operator()(const std::vector<Vec2>*) const {
        return "pairs of numbers, [[x, z], ...], each " + range(field);
    }
    std::string operator()(const Vec3*) const { return "three numbers, each " + range(field); }
    std::string operator()(const uint32_t*) const { return wholeNumber(field); }
    std::string operator()(const uint64_t*) const { return "a whole number, 0 to 2^63"; }
    std::string operator()(const bool*) const { return "true or false"; }
    std::string operator()(const std::string*) const {
        if (!field.choices.empty()) return oneOf(field.choices);
        if (field.rule == Rule::identifier) return "a name of letters, digits, _ and -";
        return "a text in quotes";
    }
    std::string operator()(const std::filesystem::path*) const { return "a " + std::string(field.about); }
    std::string operator()(const Setting& setting) const {
        switch (setting.field->type) {
        case seaglass::FieldType::boolean:
            return "true or false";
        case seaglass::FieldType::choice:
            return oneOf(field.choices);
        case seaglass::FieldType::integer:
            return wholeNumber(field);
        default:
            return range(field);
        }
    }
};

} // namespace

const Section& sceneSection() {
    return scene;
}

const Section& sectionOf(std::string_view path) {
    const Section* section = &scene;
    while (!path.empty()) {
        const std::string_view key = path.substr(0, path.find('.'));
        section = std::ranges::find(section->children, key, [](const Child& child) {
                      return child.section->key;
                  })->section;
        path.remove_prefix(std::min(key.size() + 1, path.size()));
    }
    return *section;
}

std::span<const std::string_view> choicesOf(std::string_view path) {
    const size_t dot = path.rfind('.');
    const std::span<const Field> fields = sectionOf(path.substr(0, dot)).fields;
    return std::ranges::find(fields, path.substr(dot + 1), &Field::key)->choices;
}

seaglass::ReflectionTechnique techniqueNamed(std::string_view name) {
    const auto* const named = std::ranges::find(seaglass::reflectionTechniques, name);
    return static_cast<seaglass::ReflectionTechnique>(named - seaglass::reflectionTechniques);
}

std::string expectation(const Field& field, const Target& target) {
    return std::visit(Expectation{field}, target);
}

} // namespace demos
