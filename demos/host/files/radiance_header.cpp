#include "host/files/radiance_header.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "scene/input_limits.h"

namespace demos {
namespace {

constexpr size_t mostLines = 100; ///< that OpenImageIO reads

/// The numbers of a line's right side; false unless all are there and finite.
template<size_t count>
bool numbers(const std::string& text, std::array<double, count>& out) {
    std::istringstream stream(text);
    return std::all_of(out.begin(), out.end(), [&stream](double& value) {
        stream >> value;
        return !stream.fail() && std::isfinite(value);
    });
}

/// The first axis is that of the scanlines. +Y is up.
std::optional<int> orientationOf(const std::string& resolution) {
    constexpr std::array<const char*, 8> axes = {"-Y+X", "-Y-X", "+Y-X", "+Y+X",
                                                 "+X-Y", "-X-Y", "-X+Y", "+X+Y"};
    std::istringstream stream(resolution);
    std::string first, second;
    int rows = 0, columns = 0;
    stream >> first >> rows >> second >> columns;
    const auto found = std::find(axes.begin(), axes.end(), first + second);
    if (stream.fail() || found == axes.end()) return std::nullopt;
    return 1 + static_cast<int>(found - axes.begin());
}

/// What is wrong with the line, empty when nothing is. Lines that say nothing of the pixels are passed over.
/// OpenImageIO wants the line of the format as it is here, with nothing before or behind it.
std::string take(const std::string& name, const std::string& value, RadianceHeader& out) {
    const auto bad = [&](const std::string& expected) {
        return name + "=" + value.substr(0, 40) + ", expected " + expected;
    };
    if (name == "FORMAT" && value.starts_with("32-bit_rle_xyze"))
        return bad("32-bit_rle_rgbe: ra_xyze -r converts it");
    if (name == "FORMAT" && value != "32-bit_rle_rgbe") return bad("32-bit_rle_rgbe without spaces");
    if (name == "EXPOSURE" || name == "PIXASPECT" || name == "GAMMA") {
        std::array<double, 1> number{};
        if (!numbers(value, number) || number[0] <= 0) return bad("a positive number");
        if (name == "GAMMA" && number[0] != 1) return bad("1: linear light");
        if (name == "EXPOSURE")
            for (double& channel : out.scale) channel *= number[0];
        if (name == "PIXASPECT") out.pixelAspect /= number[0];
    }
    if (name == "COLORCORR") {
        std::array<double, 3> factors{};
        if (!numbers(value, factors) || *std::min_element(factors.begin(), factors.end()) <= 0)
            return bad("three positive numbers");
        for (size_t i = 0; i < 3; ++i) out.scale[i] *= factors[i];
    }
    if (name == "PRIMARIES") {
        std::array<double, 8> primaries{};
        if (!numbers(value, primaries)) return bad("eight numbers");
        // Some programs write zeros for what they do not know.
        if (std::any_of(primaries.begin(), primaries.end(), [](double v) { return v != 0; }))
            out.primaries = primaries;
    }
    return "";
}

/// All lines up to the empty one. What is wrong, empty when nothing is.
std::string takeLines(std::istream& lines, RadianceHeader& out) {
    constexpr const char* lineEnds = "its header's lines end in CR and LF, expected LF alone";
    bool hasFormat = false;
    std::string line;
    for (size_t count = 0; std::getline(lines, line); ++count) {
        if (line.empty() && hasFormat) return "";
        if (line.empty()) return "its header has no FORMAT, expected FORMAT=32-bit_rle_rgbe";
        if (count == mostLines) return "its header has over 100 lines, expected an empty one before";
        if (orientationOf(line))
            return "its header has '" + line.substr(0, 40) + "', expected an empty line before";
        const bool windows = line.back() == '\r';
        if (windows) line.pop_back();
        if (line.empty()) return lineEnds;
        const size_t equals = line.find('=');
        if (line.front() == '#' || equals == line.npos) continue;
        const std::string name = line.substr(0, equals);
        const std::string problem = take(name, line.substr(equals + 1), out);
        if (!problem.empty()) return problem;
        if (name == "FORMAT" && windows) return lineEnds;
        hasFormat = hasFormat || name == "FORMAT";
    }
    return "its header does not end, expected an empty line and a size such as -Y 1024 +X 2048";
}

} // namespace

std::optional<RadianceHeader> readRadianceHeader(const std::filesystem::path& file, Error& error) {
    std::ifstream stream(file, std::ios::binary);
    std::string text(limits::hdrHeaderBytes, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<size_t>(stream.gcount()));
    if (!text.starts_with("#?")) return std::nullopt;
    std::istringstream lines(text);
    RadianceHeader header;
    std::string line, problem = takeLines(lines, header);
    const auto measurable = [](double scale) { return scale >= 1e-30 && scale <= 1e30; };
    if (problem.empty() && !std::all_of(header.scale.begin(), header.scale.end(), measurable))
        problem = "its EXPOSURE and COLORCORR multiply to what no light survives, expected 1e-30 to 1e30";
    if (problem.empty() && std::getline(lines, line)) {
        const std::optional<int> orientation = orientationOf(line);
        if (orientation)
            header.orientation = *orientation;
        else
            problem = "its size is '" + line.substr(0, 40) + "', expected such as -Y 1024 +X 2048";
    }
    if (problem.empty()) return header;
    error.text = file.string() + ": " + problem;
    return std::nullopt;
}

} // namespace demos
