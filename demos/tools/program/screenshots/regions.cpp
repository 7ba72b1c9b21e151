#include "program/screenshots/regions.h"

#include <algorithm>
#include <array>

#include "host/files/image_file.h"
#include "program/screenshots/frame_name.h"
#include "scene/parse_all.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Empty: there is none.
fs::path maskBeside(const fs::path& reference) {
    std::error_code code;
    const fs::path stem = reference.stem();
    for (const std::string& name : {stem.string(), frameName(stem.string()).stem}) {
        const fs::path file = reference.parent_path() / (name + ".mask.png");
        if (fs::exists(file, code) || fs::is_symlink(file, code)) return file;
    }
    return {};
}

bool addMask(const fs::path& file, uint32_t width, uint32_t height, Mask& mask, Error& error) {
    const std::optional<Picture> picture = readPicture(file, error);
    if (!picture) {
        if (error.text.find(", expected ") == std::string::npos) error.text += ", expected a PNG mask";
        return false;
    }
    if (picture->width != width || picture->height != height) {
        error.text = file.string() + ": the mask is " + std::to_string(picture->width) + "x" +
                     std::to_string(picture->height) + ", expected its picture's " + std::to_string(width) +
                     "x" + std::to_string(height);
        return false;
    }
    for (size_t i = 0; i < mask.size(); ++i) {
        const float* const rgb = &picture->rgba[4 * i];
        if (std::max({rgb[0], rgb[1], rgb[2]}) < 0.5f) mask[i] = 1;
    }
    return true;
}

std::string toText(const Region& region) {
    return std::to_string(region.width) + "x" + std::to_string(region.height) + "+" +
           std::to_string(region.left) + "+" + std::to_string(region.top);
}

bool addRegion(const Region& region, uint32_t width, uint32_t height, Mask& mask) {
    if (region.left >= width || region.top >= height) return false;
    const size_t wide = std::min(region.width, width - region.left),
                 high = std::min(region.height, height - region.top);
    for (size_t y = region.top; y < region.top + high; ++y)
        std::fill_n(mask.begin() + static_cast<std::ptrdiff_t>(y * width + region.left), wide, uint8_t{1});
    return true;
}

} // namespace

std::optional<Region> parseRegion(const std::string& option, const std::string& text, Error& error) {
    std::array<std::optional<uint32_t>, 4> numbers;
    std::string_view rest = text;
    for (size_t i = 0; i < numbers.size(); ++i) {
        const size_t end = i + 1 < numbers.size() ? rest.find(i == 0 ? 'x' : '+') : rest.size();
        if (end == rest.npos) break;
        numbers[i] = parseAll<uint32_t>(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const bool all =
        std::all_of(numbers.begin(), numbers.end(), [](const auto& one) { return one.has_value(); });
    if (all && *numbers[0] > 0 && *numbers[1] > 0)
        return Region{*numbers[0], *numbers[1], *numbers[2], *numbers[3]};
    error.text = option + " is '" + text + "', expected WIDTHxHEIGHT+LEFT+TOP in pixels, such as 96x12+0+40";
    return std::nullopt;
}

bool isMaskName(const fs::path& file) {
    return file.extension() == ".png" && file.stem().extension() == ".mask";
}

std::optional<Mask> maskOf(const LeftOut& leftOut, const fs::path& reference, uint32_t width, uint32_t height,
                           Error& error) {
    const fs::path file = leftOut.mask.empty() ? maskBeside(reference) : leftOut.mask;
    if (file.empty() && leftOut.regions.empty()) return Mask();
    Mask mask(size_t{width} * height);
    for (const Region& region : leftOut.regions) {
        if (addRegion(region, width, height, mask)) continue;
        error.text = "--ignore " + toText(region) + ": is outside of " + reference.string() + ", which is " +
                     std::to_string(width) + "x" + std::to_string(height) + ", expected a part of it";
        return std::nullopt;
    }
    if (!file.empty() && !addMask(file, width, height, mask, error)) return std::nullopt;
    return mask;
}

} // namespace demos
