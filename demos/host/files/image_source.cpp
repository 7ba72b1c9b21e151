#include "host/files/image_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "host/files/color/icc_profile.h"
#include "host/files/color/png_color.h"
#include "host/files/color/primaries.h"
#include "host/files/exr_header.h"
#include "host/files/quiet.h"
#include "host/files/radiance_header.h"
#include "host/files/unpacking.h"
#include "host/files/whole_pixels.h"
#include "scene/reading/input_file.h"

namespace demos {
namespace {

constexpr int rowsAtOnce = 64;

ImageWindow dataWindow(const OIIO::ImageSpec& spec) {
    return {spec.x, spec.y, spec.width, spec.height};
}

ImageWindow displayWindow(const OIIO::ImageSpec& spec) {
    return {spec.full_x, spec.full_y, spec.full_width, spec.full_height};
}

bool isUpright(int orientation) {
    return orientation < 5;
}

std::string sizeProblem(const ImageWindow& window) {
    if (window.width >= 1 && window.height >= 1 && window.width <= limits::pictureSide &&
        window.height <= limits::pictureSide)
        return "";
    return "is " + std::to_string(window.width) + "x" + std::to_string(window.height) +
           ", expected 1 to 16384 each way";
}

/// What a file says of its colours that numbers alone do not.
struct ColorMeaning {
    glm::dvec3 scale{1};
    glm::dmat3 rec709{1};
    int orientation = 1;
    double pixelAspect = 1;
    double gamma = 0;     ///< of integers, light to that power; 0: by sRGB's curve
    std::string encoding; ///< ImageHeader's
};

std::optional<Primaries> statedPrimaries(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const stated =
        spec.find_attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8));
    if (stated) {
        Primaries out{};
        std::copy_n(static_cast<const float*>(stated->data()), out.size(), out.begin());
        return out;
    }
    if (spec.get_int_attribute("acesImageContainerFlag") == 1) return acesAp0;
    return std::nullopt;
}

/// What is wrong, empty when nothing is.
std::string setPrimaries(const std::optional<Primaries>& primaries, ColorMeaning& out) {
    if (!primaries) return "";
    const std::optional<glm::dmat3> matrix = rec709From(*primaries);
    if (!matrix)
        return "states primaries that span no colours, expected chromaticities of red, green, blue and white";
    out.rec709 = *matrix;
    return "";
}

bool isNearlyOne(const glm::dmat3& matrix) {
    constexpr double within = 2e-3; // profiles are rounded to 2^-16, and say white of their own
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (std::abs(matrix[i][j] - (i == j)) > within) return false;
    return true;
}

/// Names what an ICC profile says, and whether it is followed. `name` is the file's for it.
std::string setProfileMeaning(const OIIO::ImageSpec& spec, std::string name, ColorMeaning& out) {
    const OIIO::ParamValue* const stored = spec.find_attribute("ICCProfile");
    std::span<const uint8_t> profile;
    if (stored)
        profile = {static_cast<const uint8_t*>(stored->data()), static_cast<size_t>(stored->datasize())};
    if (const std::string own = profileName(profile); !own.empty()) name = own;
    const std::optional<ProfileColor> color = readProfile(profile);
    if (!color) {
        if (!isCalledSRgb(name)) out.encoding = "ICC profile '" + name + "', taken for sRGB";
        return "";
    }
    const std::string problem = setPrimaries(color->primaries, out);
    if (!problem.empty()) return problem;
    if (isNearlyOne(out.rec709)) out.rec709 = glm::dmat3(1);
    out.gamma = color->gamma;
    if (out.gamma > 0 || out.rec709 != glm::dmat3(1))
        out.encoding = "ICC profile '" + name + "', brought to sRGB";
    return "";
}

/// Names what is said, and whether it is followed.
std::string setPngMeaning(const std::filesystem::path& file, const OIIO::ImageSpec& spec, ColorMeaning& out) {
    const PngColor color = readPngColor(file);
    if (color.profile) return setProfileMeaning(spec, *color.profile, out);
    const std::string problem = setPrimaries(color.primaries, out);
    if (!problem.empty()) return problem;
    out.gamma = color.gamma;
    std::array<char, 32> gamma{};
    if (color.gamma > 0) std::snprintf(gamma.data(), gamma.size(), "gamma %.5g", color.gamma);
    out.encoding = gamma.data();
    if (out.rec709 != glm::dmat3(1)) out.encoding += out.encoding.empty() ? "primaries" : " and primaries";
    if (!out.encoding.empty()) out.encoding += ", brought to sRGB";
    if (!color.unread.empty()) out.encoding = color.unread + ", taken for sRGB";
    return "";
}

std::string setMeaning(const std::filesystem::path& file, const OIIO::ImageInput& input, ColorMeaning& out) {
    if (std::string_view(input.format_name()) == "png") return setPngMeaning(file, input.spec(), out);
    if (std::string_view(input.format_name()) != "hdr") {
        const OIIO::ImageSpec& spec = input.spec();
        const int orientation = spec.get_int_attribute("Orientation", 1);
        out.orientation = orientation >= 1 && orientation <= 8 ? orientation : 1;
        const auto aspect = static_cast<double>(spec.get_float_attribute("PixelAspectRatio", 1));
        out.pixelAspect = aspect > 0 && std::isfinite(aspect) ? aspect : 1;
        if (std::string_view(input.format_name()) == "jpeg" && spec.find_attribute("ICCProfile"))
            return setProfileMeaning(spec, "", out);
        return setPrimaries(statedPrimaries(spec), out);
    }
    Error error;
    const std::optional<RadianceHeader> header = readRadianceHeader(file, error);
    if (!header) return error.text.empty() ? "is no Radiance HDR" : error.text;
    out.scale = 1.0 / glm::dvec3(header->scale[0], header->scale[1], header->scale[2]);
    out.orientation = header->orientation;
    out.pixelAspect = header->pixelAspect;
    return setPrimaries(header->primaries, out);
}

/// Channels that lie side by side and go to slots side by side, so that one call reads them.
struct Run {
    int first = 0, end = 0;
    size_t slot = 0;
};

std::vector<Run> runsOf(const std::array<int, 4>& channels) {
    std::vector<Run> runs;
    for (size_t slot = 0; slot < channels.size(); ++slot) {
        const int channel = channels[slot];
        if (channel < 0) continue;
        const bool goesOn = !runs.empty() && runs.back().end == channel &&
                            runs.back().slot + static_cast<size_t>(channel - runs.back().first) == slot;
        if (goesOn)
            ++runs.back().end;
        else
            runs.push_back({channel, channel + 1, slot});
    }
    return runs;
}

/// Where a pixel of the stored picture goes, `size` being that of the stored display window (TIFF 6.0,
/// "Orientation").
glm::ivec2 upright(int orientation, const glm::ivec2& size, const glm::ivec2& p) {
    const glm::ivec2 back = size - 1 - p;
    switch (orientation) {
    case 2:
        return {back.x, p.y};
    case 3:
        return back;
    case 4:
        return {p.x, back.y};
    case 5:
        return {p.y, p.x};
    case 6:
        return {back.y, p.x};
    case 7:
        return {back.y, back.x};
    case 8:
        return {p.y, back.x};
    default:
        return p;
    }
}

/// What floats do not hold would be compared as if it were alike.
std::string wholeNumbersProblem(const OIIO::ImageSpec& spec, const ImageLayer& layer) {
    for (size_t i = 0; i < 3; ++i)
        if (const int channel = layer.channels[i];
            channel >= 0 && !spec.channelformat(channel).is_floating_point())
            return "its channel " + std::string(spec.channel_name(channel)) +
                   " holds whole numbers, expected half or float";
    return "";
}

double sRgbOf(double light) {
    const double v = std::clamp(light, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// Of an integer picture.
glm::vec3 broughtToSRgb(const glm::vec3& color, const ColorMeaning& meaning) {
    glm::dvec3 light(0);
    for (int i = 0; i < 3; ++i) light[i] = lightOf(double{color[i]}, meaning.gamma);
    light = meaning.rec709 * light;
    return {sRgbOf(light.r), sRgbOf(light.g), sRgbOf(light.b)};
}

/// By the first bytes, whatever its name is. Empty: none that is read.
std::string formatOf(const std::filesystem::path& file) {
    std::array<char, 4> bytes{};
    std::ifstream(file, std::ios::binary).read(bytes.data(), bytes.size());
    const std::string_view start(bytes.data(), bytes.size());
    if (start == "\x76\x2f\x31\x01") return "openexr";
    if (start == "\x89PNG") return "png";
    if (start.starts_with("\xff\xd8")) return "jpeg";
    return start.starts_with("#?") ? "hdr" : "";
}

} // namespace

std::string toText(const ImageWindow& window) {
    const auto withSign = [](int value) { return (value < 0 ? "" : "+") + std::to_string(value); };
    return std::to_string(window.width) + "x" + std::to_string(window.height) + withSign(window.x) +
           withSign(window.y);
}

struct ImageSource::Opened {
    std::string name;
    std::optional<BarePicture> bare; ///< what `input` reads by `memory`
    std::optional<OIIO::Filesystem::IOMemReader> memory;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    ImageLayer layer;
    ColorMeaning meaning;
    ImageHeader header;
    std::vector<uint16_t> wholes; ///< a band as the file has it, of up to 16 bits a value

    bool openAs(const std::string& format, const std::filesystem::path& file, const limits::Allowance& pixels,
                Error& error);
    bool makeBare(const std::filesystem::path& file, const limits::Allowance& pixels, Error& error);
    bool find(const std::filesystem::path& file, const LayerChoice& choice, Error& error);
    bool checkPixels(const ImageWindow& window, const std::filesystem::path& file,
                     const limits::Allowance& pixels, Error& error) const;
    void describe();
    void nameChannels(const std::vector<ImagePart>& parts);
    bool readBand(int y, int rows, std::vector<glm::vec4>& out);
    bool readWholes(int y, int rows, std::vector<glm::vec4>& out);
    bool readFloats(int y, int rows, std::vector<glm::vec4>& out);
    void convert(std::span<glm::vec4> pixels) const;
    void visitRow(int y, std::span<const glm::vec4> pixels,
                  const std::function<void(const ImageRow&)>& visit) const;
};

bool ImageSource::Opened::openAs(const std::string& format, const std::filesystem::path& file,
                                 const limits::Allowance& pixels, Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = name + ": " + what;
        return false;
    };
    if (format.empty()) return fail("is no picture that is known, expected PNG, EXR or HDR");
    if (format == "openexr") {
        const std::string problem = exrHeaderProblem(file);
        if (!problem.empty()) return fail(problem);
    }
    // XYZ, for one, is what OpenImageIO only calls no format.
    if (format == "hdr" && !readRadianceHeader(file, error)) return false;
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    if (format == "png" || format == "jpeg") {
        if (!makeBare(file, pixels, error)) return false;
        OIIO::Filesystem::IOProxy* proxy = &*memory;
        hints.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    }
    input = OIIO::ImageInput::create(format);
    if (!input) return fail(OIIO::geterror());
    return input->open(name, spec, hints) || fail(input->geterror());
}

bool ImageSource::Opened::makeBare(const std::filesystem::path& file, const limits::Allowance& pixels,
                                   Error& error) {
    std::vector<uint8_t> bytes;
    std::string problem;
    if (readWhole(file, limits::pictureFileBytes, bytes, problem)) bare = barePicture(bytes, problem);
    const ImageWindow frame =
        bare ? ImageWindow{0, 0, static_cast<int>(bare->width), static_cast<int>(bare->height)}
             : ImageWindow{};
    const bool known = frame.width > 0 && frame.height > 0;
    if (known && problem.empty()) problem = sizeProblem(frame);
    if (!problem.empty()) {
        error.text = name + ": " + problem;
        return false;
    }
    if (known && !checkPixels(frame, file, pixels, error)) return false;
    memory.emplace(bare->bytes.data(), bare->bytes.size());
    return true;
}

bool ImageSource::Opened::find(const std::filesystem::path& file, const LayerChoice& choice, Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = what.starts_with(name) ? what : name + ": " + what;
        return false;
    };
    std::vector<ImagePart> parts;
    bool deep = false;
    for (int part = 0; part < limits::exrParts; ++part) {
        const OIIO::ImageSpec stated = input->spec(part);
        if (stated.format == OIIO::TypeDesc::UNKNOWN) break;
        deep = deep || stated.deep;
        // None of a deep part's channels can be chosen.
        parts.push_back({stated.get_string_attribute("oiio:subimagename"),
                         stated.deep ? std::vector<std::string>{} : stated.channelnames});
    }
    if (deep &&
        std::all_of(parts.begin(), parts.end(), [](const ImagePart& p) { return p.channels.empty(); }))
        return fail("is deep, expected a flat picture");
    const std::optional<ImageLayer> chosen = chooseLayer(parts, choice, error);
    if (!chosen) return fail(error.text);
    layer = *chosen;
    if (!input->seek_subimage(layer.part, 0)) return fail(input->geterror());
    spec = input->spec();
    if (spec.depth > 1) return fail("is a volume, expected a flat picture");
    for (const ImageWindow& window : {dataWindow(spec), displayWindow(spec)}) {
        const std::string problem = sizeProblem(window);
        if (!problem.empty()) return fail(problem);
    }
    if (int64_t(spec.width) * std::min(spec.tile_height, spec.height) > limits::tilePixels)
        return fail("has tiles of " + std::to_string(spec.tile_width) + "x" +
                    std::to_string(spec.tile_height) + ", expected at most 2^24 pixels in a row of them");
    std::string problem = setMeaning(file, *input, meaning);
    if (problem.empty() && std::string_view(input->format_name()) == "openexr")
        problem = wholeNumbersProblem(spec, layer);
    if (!problem.empty()) return fail(problem);
    describe();
    nameChannels(parts);
    return true;
}

bool ImageSource::Opened::checkPixels(const ImageWindow& window, const std::filesystem::path& file,
                                      const limits::Allowance& pixels, Error& error) const {
    std::error_code ignored;
    const uint64_t bytes = std::filesystem::file_size(file, ignored), most = pixels.of(bytes);
    if (static_cast<uint64_t>(window.width) * static_cast<uint64_t>(window.height) <= most) return true;
    error.text = name + ": is " + std::to_string(window.width) + "x" + std::to_string(window.height) +
                 " in " + std::to_string(bytes) + " bytes, expected at most " + std::to_string(most) +
                 (most < pixels.most ? unpacksFar : " pixels");
    return false;
}

void ImageSource::Opened::describe() {
    header.data = dataWindow(spec);
    header.display = displayWindow(spec);
    const bool across = isUpright(meaning.orientation);
    header.width = static_cast<uint32_t>(across ? spec.full_width : spec.full_height);
    header.height = static_cast<uint32_t>(across ? spec.full_height : spec.full_width);
    header.integer = !spec.channelformat(layer.channels[0]).is_floating_point();
    header.cubeMap = std::string(spec.get_string_attribute("textureformat")).starts_with("CubeFace");
    header.pixelAspect = meaning.pixelAspect;
    header.layer = layer.name;
    header.encoding = meaning.encoding;
}

void ImageSource::Opened::nameChannels(const std::vector<ImagePart>& parts) {
    const auto isColor = [this](size_t part, size_t channel) {
        return static_cast<int>(part) == layer.part &&
               std::find(layer.channels.begin(), layer.channels.begin() + 3, static_cast<int>(channel)) !=
                   layer.channels.begin() + 3;
    };
    for (size_t part = 0; part < parts.size(); ++part)
        for (size_t i = 0; i < parts[part].channels.size(); ++i)
            (isColor(part, i) ? header.color : header.others)
                .push_back((parts.size() > 1 ? parts[part].name + ":" : "") + parts[part].channels[i]);
}

bool ImageSource::Opened::readBand(int y, int rows, std::vector<glm::vec4>& out) {
    return header.integer ? readWholes(y, rows, out) : readFloats(y, rows, out);
}

/// OpenImageIO would multiply by a rounded inverse: then 8 and 16 bits of one value are not the same.
bool ImageSource::Opened::readWholes(int y, int rows, std::vector<glm::vec4>& out) {
    const auto channels = static_cast<size_t>(spec.nchannels);
    const size_t pixels = static_cast<size_t>(spec.width) * static_cast<size_t>(rows);
    const bool bytes = spec.format == OIIO::TypeDesc::UINT8;
    wholes.resize(pixels * channels);
    if (!input->read_scanlines(layer.part, 0, y, y + rows, spec.z, 0, spec.nchannels,
                               bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16, wholes.data()))
        return false;
    const std::span<glm::vec4> to(out.data(), pixels);
    if (bytes)
        spreadWholes(reinterpret_cast<const uint8_t*>(wholes.data()), channels, layer.channels, to);
    else
        spreadWholes(wholes.data(), channels, layer.channels, to);
    return true;
}

bool ImageSource::Opened::readFloats(int y, int rows, std::vector<glm::vec4>& out) {
    constexpr auto pixel = static_cast<OIIO::stride_t>(sizeof(glm::vec4));
    for (const Run& run : runsOf(layer.channels)) {
        float* const at = &out.front()[0] + run.slot;
        const bool ok = spec.tile_width > 0
                            ? input->read_tiles(layer.part, 0, spec.x, spec.x + spec.width, y, y + rows,
                                                spec.z, spec.z + 1, run.first, run.end, OIIO::TypeDesc::FLOAT,
                                                at, pixel, pixel * spec.width)
                            : input->read_scanlines(layer.part, 0, y, y + rows, spec.z, run.first, run.end,
                                                    OIIO::TypeDesc::FLOAT, at, pixel, pixel * spec.width);
        if (!ok) return false;
    }
    const bool grey = layer.channels[1] < 0, opaque = layer.channels[3] < 0;
    const bool ofTwo = !grey && layer.channels[2] < 0;
    for (glm::vec4& to : std::span(out.data(), static_cast<size_t>(spec.width) * static_cast<size_t>(rows))) {
        if (grey) to.g = to.b = to.r;
        if (ofTwo) to.b = 0;
        if (opaque) to.a = 1;
    }
    return true;
}

void ImageSource::Opened::convert(std::span<glm::vec4> pixels) const {
    if (meaning.scale == glm::dvec3(1) && meaning.rec709 == glm::dmat3(1) && meaning.gamma == 0) return;
    const glm::mat3 matrix(meaning.rec709 *
                           glm::dmat3(meaning.scale.r, 0, 0, 0, meaning.scale.g, 0, 0, 0, meaning.scale.b));
    for (glm::vec4& pixel : pixels)
        pixel =
            glm::vec4(header.integer ? broughtToSRgb(pixel, meaning) : matrix * glm::vec3(pixel), pixel.a);
}

void ImageSource::Opened::visitRow(int y, std::span<const glm::vec4> pixels,
                                   const std::function<void(const ImageRow&)>& visit) const {
    const int row = y - spec.full_y;
    const int first = std::max(spec.x, spec.full_x);
    const int end = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
    if (row < 0 || row >= spec.full_height || first >= end) return;
    const glm::ivec2 size(spec.full_width, spec.full_height);
    const glm::ivec2 start = upright(meaning.orientation, size, {first - spec.full_x, row});
    const glm::ivec2 step = upright(meaning.orientation, size, {first - spec.full_x + 1, row}) - start;
    visit({pixels.subspan(static_cast<size_t>(first - spec.x), static_cast<size_t>(end - first)), start.x,
           start.y, step.x, step.y});
}

std::optional<ImageSource> ImageSource::open(const std::filesystem::path& file, const LayerChoice& choice,
                                             const limits::Allowance& pixels, Error& error) {
    if (const std::string problem = unreadable(file); !problem.empty()) {
        error.text = file.string() + ": " + problem;
        return std::nullopt;
    }
    const QuietStderr quiet;
    auto opened = std::make_unique<Opened>();
    opened->name = file.string();
    if (!opened->openAs(formatOf(file), file, pixels, error) || !opened->find(file, choice, error))
        return std::nullopt;
    for (const ImageWindow& window : {dataWindow(opened->spec), displayWindow(opened->spec)})
        if (!opened->checkPixels(window, file, pixels, error)) return std::nullopt;
    return ImageSource(std::move(opened));
}

ImageSource::ImageSource(std::unique_ptr<Opened> opened) : opened_(std::move(opened)) {}
ImageSource::ImageSource(ImageSource&&) noexcept = default;
ImageSource::~ImageSource() = default;

const ImageHeader& ImageSource::header() const {
    return opened_->header;
}

bool ImageSource::read(const std::function<void(const ImageRow&)>& visit, Error& error) {
    const QuietStderr quiet;
    const OIIO::ImageSpec& spec = opened_->spec;
    const int band = spec.tile_height > 0 ? spec.tile_height : rowsAtOnce;
    const auto width = static_cast<size_t>(spec.width);
    std::vector<glm::vec4> pixels(width * static_cast<size_t>(std::min(band, spec.height)));
    for (int y = 0; y < spec.height; y += band) {
        const int rows = std::min(band, spec.height - y);
        if (!opened_->readBand(spec.y + y, rows, pixels)) {
            error.text = opened_->name + ": " + opened_->input->geterror();
            return false;
        }
        const std::span<glm::vec4> read(pixels.data(), width * static_cast<size_t>(rows));
        opened_->convert(read);
        for (int i = 0; i < rows; ++i)
            opened_->visitRow(spec.y + y + i, read.subspan(width * static_cast<size_t>(i), width), visit);
    }
    return true;
}

} // namespace demos
