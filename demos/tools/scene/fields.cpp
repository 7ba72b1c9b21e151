#include "scene/fields.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "scene/nearest.h"

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
    return &value.emplace();
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

constexpr double far = 1e6; // metres: beyond it a float no longer resolves a wave
constexpr double turn = 360;
constexpr bool required = true;

constexpr std::array<std::string_view, 5> spectra = {"jonswap", "pierson-moskowitz", "tma", "phillips",
                                                     "table"};
constexpr std::array<std::string_view, 4> spreadings = {"hasselmann", "mitsuyasu", "donelan-banner", "cos2s"};
constexpr std::array<std::string_view, 3> backends = {"automatic", "gpu", "fftw"};
constexpr std::array<std::string_view, 4> waterTypes = {"pool", "clear-ocean", "coastal", "turbid"};
constexpr std::array<std::string_view, 5> techniques = {"sky", "sspr", "ssr", "hybrid", "planar"};

constexpr std::array skyFields = {
    Field{"file", at<&SkyDesc::file>, 0, 0, "", "lat-long HDR or EXR file", required},
    Field{"layer", at<&SkyDesc::layer>, 0, 0, "", "of an EXR with several, or empty"},
    Field{"rotation_deg", at<&SkyDesc::rotationDeg>, -turn, turn, "degrees", "turn about +Y"},
    Field{"intensity", at<&SkyDesc::intensity>, 0, 1e6, "", "scale of the radiance"},
};

constexpr std::array sunFields = {
    Field{"from_sky", at<&SunDesc::fromSky>, 0, 0, "", "take the sun from the sky's brightest spot"},
    Field{"azimuth_deg", at<&SunDesc::azimuthDeg>, -turn, turn, "degrees", "from +X towards +Z"},
    Field{"elevation_deg", at<&SunDesc::elevationDeg>, -90, 90, "degrees", "above the horizon"},
    Field{"irradiance", at<&SunDesc::irradiance>, 0, 1e6, "", "red, green, blue"},
};

constexpr std::array<std::string_view, 4> fogShapes = {"linear", "exponential", "exponential-squared",
                                                       "height"};

constexpr std::array fogFields = {
    Field{"shape", at<&FogDesc::shape>, 0, 0, "", "how it grows with distance", false, Rule::none, fogShapes},
    Field{"density_per_m", at<&FogDesc::densityPerM>, 0, 1000, "1/m",
          "of all but linear; height: at its base"},
    Field{"start_m", at<&FogDesc::startM>, 0, 1e8, "m", "linear: where it begins"},
    Field{"end_m", at<&FogDesc::endM>, 0, 1e9, "m", "linear: where it hides all", false, Rule::positive},
    Field{"falloff_per_m", at<&FogDesc::falloffPerM>, 0, 10, "1/m", "height: how fast it thins out upwards"},
    Field{"base_height_m", at<&FogDesc::baseHeightM>, -far, far, "m", "height: where it has its density"},
    Field{"color", at<&FogDesc::color>, 0, 1e6, "", "radiance: red, green, blue"},
    Field{"from_sky", at<&FogDesc::fromSky>, 0, 1, "", "share of its colour that is the sky's instead"},
    Field{"most", at<&FogDesc::most>, 0, 1, "", "share of light that it takes at most"},
    Field{"over_sky", at<&FogDesc::overSky>, 0, 0, "", "lies before the sky, too"},
};

constexpr std::array meshFields = {
    Field{"file", at<&MeshDesc::file>, 0, 0, "", "glTF file", required},
    Field{"position_m", at<&MeshDesc::positionM>, -far, far, "m", "of the mesh's origin"},
    Field{"yaw_deg", at<&MeshDesc::yawDeg>, -turn, turn, "degrees", "turn about +Y"},
    Field{"scale", at<&MeshDesc::scale>, 0, 1e6, "", "size", false, Rule::positive},
};

constexpr std::array wavesFields = {
    Field{"spectrum", at<&WavesDesc::spectrum>, 0, 0, "", "model of the spectrum", false, Rule::none,
          spectra},
    Field{"spectrum_table", at<&WavesDesc::spectrumTable>, 0, 0, "", "CSV file of Hz and m^2/Hz"},
    Field{"beaufort", at<&WavesDesc::beaufort>, 0, 12, "", "force: wind, fetch and old waves at once"},
    Field{"wind_m_s", at<&WavesDesc::windMps>, 0, 100, "m/s", "wind speed at 10 m"},
    Field{"wind_towards_deg", at<&WavesDesc::windTowardsDeg>, -turn, turn, "degrees", "from +X towards +Z"},
    Field{"fetch_m", at<&WavesDesc::fetchM>, 1, 1e6, "m", "open water upwind"},
    Field{"cap_fetch", at<&WavesDesc::capFetch>, 0, 0, "", "no further than a fully developed sea"},
    Field{"depth_m", at<&WavesDesc::depthM>, 0, 1e5, "m", "of the water, for its waves"},
    Field{"peak_enhancement", at<&WavesDesc::peakEnhancement>, 1, 10, "", "JONSWAP gamma"},
    Field{"spreading", at<&WavesDesc::spreading>, 0, 0, "", "model of the directions", false, Rule::none,
          spreadings},
    Field{"spreading_shape", at<&WavesDesc::spreadingShape>, 0, 1000, "", "s of cos2s"},
    Field{"swell", at<&WavesDesc::swell>, 0, 1, "", "elongation of the directional spreading"},
    Field{"amplitude", at<&WavesDesc::amplitude>, 0, 1, "", "scale of the heights, 1 as the wind makes them"},
    Field{"choppiness", at<&WavesDesc::choppiness>, 0, 10, "", "scale of the horizontal displacement"},
    Field{"samples", at<&WavesDesc::samples>, 16, 1024, "", "across each cascade", false, Rule::powerOfTwo},
    Field{"cascades", at<&WavesDesc::cascades>, 1, 4, "", "bands of wavelengths"},
    Field{"largest_patch_m", at<&WavesDesc::largestPatchM>, 1, 1e5, "m",
          "edge of the largest cascade, 0 chooses", false, Rule::zeroOrRange},
    // TOML's integers are signed.
    Field{"seed", at<&WavesDesc::seed>, 0, 9223372036854774784.0, "", "of the random phases"},
    Field{"backend", at<&WavesDesc::backend>, 0, 0, "", "what computes them", false, Rule::none, backends},
};

constexpr std::array swellFields = {
    Field{"height_m", at<&SwellDesc::heightM>, 0, 30, "m", "its own significant wave height"},
    Field{"period_s", at<&SwellDesc::periodS>, 1, 30, "s", "of its peak"},
    Field{"towards_deg", at<&SwellDesc::towardsDeg>, -turn, turn, "degrees", "from +X towards +Z"},
    Field{"bandwidth", at<&SwellDesc::bandwidth>, 0.02, 0.25, "", "of frequency, as a share"},
    Field{"spreading", at<&SwellDesc::spreading>, 0, 1000, "", "s of cos^2s: greater is straighter"},
};

constexpr std::array shoreFields = {
    Field{"file", at<&ShoreDesc::file>, 0, 0, "", "glTF file", required},
    Field{"position_m", at<&ShoreDesc::positionM>, -far, far, "m", "of the mesh's origin"},
    Field{"spacing_m", at<&ShoreDesc::spacingM>, 0.05, 100, "m", "between the bed's samples"},
};

constexpr std::array foamFields = {
    Field{"bias", at<&FoamDesc::bias>, -1, 1, "", "added to the Jacobian below which waves break"},
    Field{"decay_s", at<&FoamDesc::decayS>, 0.1, 20, "s", "in which foam fades to 1/e"},
    Field{"albedo", at<&FoamDesc::albedo>, 0, 1, "", "of full foam"},
};

constexpr std::array refractionFields = {
    Field{"type", at<&RefractionDesc::type>, 0, 0, "", "a real water's coefficients, whatever they are here",
          false, Rule::none, waterTypes},
    Field{"tint", at<&RefractionDesc::tint>, 0, 0.33, "",
          "what deep water sends back: linear red, green, blue", false, Rule::positive},
    Field{"visibility_m", at<&RefractionDesc::visibilityM>, 0.05, 1000, "m",
          "with tint: where 5 % of the clearest colour is left"},
    Field{"absorption_per_m", at<&RefractionDesc::absorptionPerM>, 0, 100, "1/m", "red, green, blue"},
    Field{"backscatter_per_m", at<&RefractionDesc::backscatterPerM>, 0, 100, "1/m", "red, green, blue"},
    Field{"distortion", at<&RefractionDesc::distortion>, 0, 1, "", "0 straight, 1 as Snell says"},
    Field{"scattering_per_m", at<&RefractionDesc::scatteringPerM>, 0, 100, "1/m",
          "by particles: light through crests, 0 none"},
};

constexpr std::array underwaterFields = {
    Field{"meniscus_m", at<&UnderwaterDesc::meniscusM>, 0, 0.1, "m", "width of the waterline, 0 none"},
};

constexpr std::array causticsFields = {
    Field{"strength", at<&CausticsDesc::strength>, 0, 1, "", "of their contrast, 1 as the waves say"},
    Field{"step_px", at<&CausticsDesc::stepPx>, 1, 8, "", "from one of the sun's rays to the next, each way"},
};

constexpr std::array bedFields = {
    Field{"drawn", at<&BedDesc::drawn>, 0, 0, "", "false: as without"},
    Field{"margin", at<&BedDesc::margin>, 0, 1, "", "larger on each side, share of the picture's size"},
    Field{"downscale", at<&BedDesc::downscale>, 1, 8, "",
          "pixels of the picture to one of the bed's, each way"},
};

constexpr std::array reflectionFields = {
    Field{"technique", at<&ReflectionDesc::technique>, 0, 0, "", "where reflections come from", false,
          Rule::none, techniques},
    Field{"downscale", at<&ReflectionDesc::downscale>, 1, 8, "", "pixels to one of the reflection, each way",
          false, Rule::powerOfTwo},
    Field{"height_px", at<&ReflectionDesc::heightPx>, 8, 16384, "pixels",
          "of the reflection, in the place of downscale", false, Rule::zeroOrRange},
    Field{"coarse_keys", at<&ReflectionDesc::coarseKeys>, 0, 0, "", "sspr: one key for 2 x 2 pixels"},
    Field{"edge_fade", at<&ReflectionDesc::edgeFade>, 0, 0.5, "", "share of the picture's height"},
    Field{"edge_fade_around", at<&ReflectionDesc::edgeFadeAround>, 0, 0, "", "fade at all four borders"},
    Field{"underside_light", at<&ReflectionDesc::undersideLight>, 0, 1, "",
          "of undersides not seen, as a share of their tops"},
    Field{"roof_looks", at<&ReflectionDesc::roofLooks>, 0, 8, "",
          "sspr, hybrid: for what hangs over the mirror"},
    Field{"distortion", at<&ReflectionDesc::distortion>, 0, 1, "", "0 flat mirror, 1 as geometry says"},
    Field{"blur_levels", at<&ReflectionDesc::blurLevels>, 0, 6, "", "halvings for rough surfaces, 0 sharp"},
    Field{"clear_distance_m", at<&ReflectionDesc::clearDistanceM>, 0, 1e6, "m", "scattered only beyond"},
    Field{"scatter", at<&ReflectionDesc::scatter>, 0, 1, "", "how fast reflections widen with distance"},
    Field{"sky_fade_m", at<&ReflectionDesc::skyFadeM>, 0, 1e6, "m", "where only sky is mirrored, 0 nowhere"},
    Field{"edge_reach", at<&ReflectionDesc::edgeReach>, 0, 1, "", "share of the picture's height"},
    Field{"edge_stretch_per_m", at<&ReflectionDesc::edgeStretchPerM>, 0, 100, "1/m",
          "stretches reflections over the border"},
    Field{"temporal", at<&ReflectionDesc::temporal>, 0, 0.95, "",
          "share taken from the frame before, 0 none"},
    Field{"march_cells", at<&ReflectionDesc::marchCells>, 0, 0, "",
          "ssr: pixel by pixel over cells, else in strides"},
    Field{"march_steps", at<&ReflectionDesc::marchSteps>, 8, 512, "", "ssr: looks a ray at most"},
    Field{"march_thickness_m", at<&ReflectionDesc::marchThicknessM>, 0.001, 100, "m",
          "ssr: how deep things are behind what is seen of them"},
    Field{"march_distance_m", at<&ReflectionDesc::marchDistanceM>, 0.1, 1e6, "m", "ssr: of a ray at most"},
    Field{"march_jitter", at<&ReflectionDesc::marchJitter>, 0, 1, "",
          "ssr: share of a stride, noise for bands"},
};

constexpr std::array<std::string_view, 3> extentShapes = {"rectangle", "polygon", "mesh"};

constexpr std::array extentFields = {
    Field{"shape", at<&ExtentDesc::shape>, 0, 0, "", "what says where the water ends", false, Rule::none,
          extentShapes},
    Field{"center_m", at<&ExtentDesc::centerM>, -far, far, "m", "x and z of its middle, or its origin"},
    Field{"yaw_deg", at<&ExtentDesc::yawDeg>, -turn, turn, "degrees", "turn about +Y"},
    Field{"size_m", at<&ExtentDesc::sizeM>, 0.01, 1e6, "m", "of a rectangle, along its x and z"},
    Field{"points_m", at<&ExtentDesc::pointsM>, -far, far, "m", "x and z of a polygon's corners"},
    Field{"file", at<&ExtentDesc::file>, 0, 0, "", "glTF file"},
};

constexpr std::array dryRoomFields = {
    Field{"position_m", at<&DryRoomDesc::positionM>, -far, far, "m", "of its origin"},
    Field{"yaw_deg", at<&DryRoomDesc::yawDeg>, -turn, turn, "degrees", "turn about +Y"},
    Field{"points_m", at<&DryRoomDesc::pointsM>, -1e3, 1e3, "m", "x and z of its outline's corners",
          required},
    Field{"flare_deg", at<&DryRoomDesc::flareDeg>, -80, 80, "degrees", "by which its walls lean outwards"},
    Field{"bottom_m", at<&DryRoomDesc::bottomM>, -1e3, 1e3, "m", "height of its bottom"},
};

constexpr std::array<std::string_view, 2> fresnels = {"exact", "schlick"};

constexpr std::array waterFields = {
    Field{"level_m", at<&WaterDesc::levelM>, -1e5, 1e5, "m", "height of the calm surface, at the origin"},
    Field{"tilt_deg", at<&WaterDesc::tiltDeg>, 0, 80, "degrees", "of the calm surface, 0 level"},
    Field{"tilt_towards_deg", at<&WaterDesc::tiltTowardsDeg>, -turn, turn, "degrees",
          "where it falls to, from +X towards +Z"},
    Field{"planet_radius_m", at<&WaterDesc::planetRadiusM>, 1e6, 1e9, "m",
          "of the ball on which the open sea falls away, 0: flat", false, Rule::zeroOrRange},
    Field{"cell_m", at<&WaterDesc::cellM>, 0.01, 100, "m", "edge of the finest cells"},
    Field{"cells_per_level", at<&WaterDesc::cellsPerLevel>, 128, 1024, "",
          "until twice coarser ones take over"},
    Field{"mirror_looks", at<&WaterDesc::mirrorLooks>, 1, 4, "", "at what a pixel's slopes mirror", false,
          Rule::powerOfTwo},
    Field{"refraction_looks", at<&WaterDesc::refractionLooks>, 1, 16, "",
          "for where bent light comes from, 1: straight through"},
    Field{"slope_looks", at<&WaterDesc::slopeLooks>, 1, 4, "", "at the waves along a pixel", false,
          Rule::powerOfTwo},
    Field{"wave_shadow_steps", at<&WaterDesc::waveShadowSteps>, 0, 32, "",
          "looks for the waves that hide low sky and sun, not 1; 0: a mean"},
    Field{"relief", at<&WaterDesc::relief>, 0, 1, "", "shades short waves at their own height"},
    Field{"fresnel", at<&WaterDesc::fresnel>, 0, 0, "", "what share of light is mirrored", false, Rule::none,
          fresnels},
};

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
    Field{"near_m", at<&CameraDesc::nearM>, 1e-3, 1e3, "m", "distance of the near plane"},
};

constexpr std::array sceneFields = {
    Field{"title", at<&Scene::title>, 0, 0, "", "what it shows"},
    Field{"time_s", at<&Scene::timeS>, -1e6, 1e6, "s", "when it is drawn, unless --time says"},
    Field{"exposure_ev", at<&Scene::exposureEv>, -20, 20, "stops", "added before tone mapping"},
};

constexpr Section sky = {"sky", skyFields, {}, "the light from afar"};
constexpr Section sun = {"sun", sunFields, {}, "the light from one direction"};
constexpr Section fog = {"fog", fogFields, {}, "fog in the air; without it there is none"};
constexpr Section mesh = {"mesh", meshFields, {}, "a glTF model"};
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

constexpr Section bed = {
    "bed", bedFields, {}, "the bed drawn once more for refraction; without it, it sees the picture"};

constexpr Section dryRooms = {
    "dry_rooms", dryRoomFields, {}, "hollows without water, such as a boat's inside, eight at most"};

constexpr std::array waterChildren = {
    Child{&extent, open<&WaterDesc::extent>},
    Child{&waves, open<&WaterDesc::waves>},
    Child{&shore, open<&WaterDesc::shore>},
    Child{&foam, open<&WaterDesc::foam>},
    Child{&refraction, open<&WaterDesc::refraction>},
    Child{&reflection, open<&WaterDesc::reflection>},
    Child{&underwater, open<&WaterDesc::underwater>},
    Child{&caustics, open<&WaterDesc::caustics>},
    Child{&bed, open<&WaterDesc::bed>},
    Child{&dryRooms, open<&WaterDesc::dryRooms>, true},
};

constexpr Section water = {"water", waterFields, waterChildren, "the water; without it there is none"};
constexpr std::array floorChildren = {Child{&reflection, open<&FloorDesc::reflection>}};
constexpr Section floor = {"floor", floorFields, floorChildren,
                           "a polished floor or a mirror, instead of water"};
constexpr Section camera = {"camera", cameraFields, {}, "a place to look from"};

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

struct Expectation {
    const Field& field;

    std::string operator()(const double*) const { return range(field); }
    std::string operator()(const Vec2*) const { return "two numbers, each " + range(field); }
    std::string operator()(const std::vector<Vec2>*) const {
        return "pairs of numbers, [[x, z], ...], each " + range(field);
    }
    std::string operator()(const Vec3*) const { return "three numbers, each " + range(field); }
    std::string operator()(const uint32_t*) const {
        if (field.rule == Rule::powerOfTwo) return "a power of two, " + range(field);
        return "a whole number, " + range(field);
    }
    std::string operator()(const uint64_t*) const { return "a whole number, 0 to 2^63"; }
    std::string operator()(const bool*) const { return "true or false"; }
    std::string operator()(const std::string*) const {
        if (!field.choices.empty()) return oneOf(field.choices);
        if (field.rule == Rule::identifier) return "a name of letters, digits, _ and -";
        return "a text in quotes";
    }
    std::string operator()(const std::filesystem::path*) const { return "a " + std::string(field.about); }
};

} // namespace

const Section& sceneSection() {
    return scene;
}

std::span<const std::string_view> choicesOf(std::string_view path) {
    const Section* section = &scene;
    for (size_t dot = path.find('.'); dot != path.npos; dot = path.find('.')) {
        const auto child =
            std::find_if(section->children.begin(), section->children.end(),
                         [&](const Child& c) { return c.section->key == path.substr(0, dot); });
        if (child == section->children.end()) return {};
        section = child->section;
        path.remove_prefix(dot + 1);
    }
    const auto field = std::find_if(section->fields.begin(), section->fields.end(),
                                    [&](const Field& f) { return f.key == path; });
    return field == section->fields.end() ? std::span<const std::string_view>{} : field->choices;
}

std::string expectation(const Field& field, const Target& target) {
    return std::visit(Expectation{field}, target);
}

} // namespace demos
