#include "host/files/color/icc_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "host/ascii.h"
#include "host/big_endian.h"

namespace demos {
namespace {

using ProfileBytes = std::span<const uint8_t>;

constexpr size_t headBytes = 128, tagBytes = 12, longestName = 79;
constexpr uint32_t mostTags = 200;
constexpr Primaries d50White = {0, 0, 0, 0, 0, 0, 0.34567, 0.3585};
constexpr double sameCurve = 1e-3; ///< half a step of nine bits

std::string_view letters(ProfileBytes bytes, size_t at, size_t count) {
    if (at > bytes.size() || bytes.size() - at < count) return {};
    return {reinterpret_cast<const char*>(bytes.data()) + at, count};
}

/// s15Fixed16Number.
double fixedAt(ProfileBytes bytes, size_t at) {
    return static_cast<int32_t>(bigEndianAt(bytes, at)) / 65536.0;
}

/// Empty: not there.
ProfileBytes tagOf(ProfileBytes profile, std::string_view name) {
    const uint32_t count = std::min(bigEndianAt(profile, headBytes), mostTags);
    for (uint32_t i = 0; i < count; ++i) {
        const size_t at = headBytes + 4 + i * tagBytes;
        if (letters(profile, at, 4) != name) continue;
        const size_t from = bigEndianAt(profile, at + 4), size = bigEndianAt(profile, at + 8);
        if (from > profile.size() || profile.size() - from < size) return {};
        return profile.subspan(from, size);
    }
    return {};
}

/// Of a table of 16-bit light.
bool isSRgbTable(ProfileBytes curve, uint32_t count) {
    if (count < 16 || curve.size() < 12 + size_t{count} * 2) return false;
    for (uint32_t i = 0; i < count; ++i) {
        const double light = bigEndianAt(curve, 12 + size_t{i} * 2, 2) / 65535.0;
        if (std::abs(light - lightOf(static_cast<double>(i) / (count - 1), 0)) > sameCurve) return false;
    }
    return true;
}

/// As ProfileColor's; null where it is neither a power nor sRGB's.
std::optional<double> gammaOfCurve(ProfileBytes curve) {
    const auto power = [](double p) { return p > 0.1 && p < 10 ? std::optional(1 / p) : std::nullopt; };
    if (letters(curve, 0, 4) == "curv" && curve.size() >= 12) {
        const uint32_t count = bigEndianAt(curve, 8);
        if (count == 0) return 1;
        if (count == 1) return power(bigEndianAt(curve, 12, 2) / 256.0);
        return isSRgbTable(curve, count) ? std::optional(0.0) : std::nullopt;
    }
    if (letters(curve, 0, 4) != "para" || curve.size() < 16) return std::nullopt;
    const uint32_t form = bigEndianAt(curve, 8, 2);
    if (form == 0) return power(fixedAt(curve, 12));
    constexpr std::array<double, 5> sRgb = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
    if (form != 3 || curve.size() < 12 + 4 * sRgb.size()) return std::nullopt;
    for (size_t i = 0; i < sRgb.size(); ++i)
        if (std::abs(fixedAt(curve, 12 + 4 * i) - sRgb[i]) > sameCurve) return std::nullopt;
    return 0;
}

} // namespace

double lightOf(double stored, double gamma) {
    const double v = std::clamp(stored, 0.0, 1.0);
    if (gamma > 0) return std::pow(v, 1 / gamma);
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); // IEC 61966-2-1
}

std::optional<ProfileColor> readProfile(std::span<const uint8_t> profile) {
    // Tables go before the matrix.
    if (letters(profile, 16, 8) != "RGB XYZ " || !tagOf(profile, "A2B0").empty()) return std::nullopt;
    ProfileColor out{0, d50White};
    for (size_t i = 0; i < 3; ++i) {
        const std::string color(1, "rgb"[i]);
        const ProfileBytes xyz = tagOf(profile, color + "XYZ");
        const std::optional<double> gamma = gammaOfCurve(tagOf(profile, color + "TRC"));
        const double x = fixedAt(xyz, 8), y = fixedAt(xyz, 12), sum = x + y + fixedAt(xyz, 16);
        if (!gamma || xyz.size() < 20 || sum < 0.01) return std::nullopt;
        if (i > 0 && std::abs(*gamma - out.gamma) > sameCurve) return std::nullopt;
        out.gamma = *gamma;
        out.primaries[2 * i] = x / sum;
        out.primaries[2 * i + 1] = y / sum;
    }
    return out;
}

std::string profileName(std::span<const uint8_t> profile) {
    const ProfileBytes desc = tagOf(profile, "desc");
    std::string name;
    if (letters(desc, 0, 4) == "desc") {
        const size_t count = std::min<size_t>(bigEndianAt(desc, 8), longestName);
        name = letters(desc, 12, count);
    } else if (letters(desc, 0, 4) == "mluc" && bigEndianAt(desc, 8) > 0) {
        const size_t count = std::min<size_t>(bigEndianAt(desc, 20) / 2, longestName),
                     from = bigEndianAt(desc, 24);
        for (size_t i = 0; i < count; ++i) {
            const uint32_t unit = bigEndianAt(desc, from + 2 * i, 2);
            name += unit < 0x7f ? static_cast<char>(unit) : '?';
        }
    }
    return printable(name.substr(0, name.find('\0')));
}

bool isCalledSRgb(const std::string& name) {
    return lowerCase(name).find("srgb") != name.npos;
}

} // namespace demos
