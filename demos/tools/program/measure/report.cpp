#include "program/measure/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <system_error>

#include "host/files/image_file.h"
#include "measure/page/html.h"
#include "metrics/magma.h"
#include "program/measure/measures.h"
#include "program/measure/report_page.h"
#include "program/render/output.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Narrower pictures are enlarged to the page's width, and then show their pixels.
constexpr uint32_t pageWidth = 960;

constexpr std::array<const char*, 3> pictures = {"reference.png", "test.png", "flip.png"};

std::string filled(std::string page, const std::map<std::string, std::string>& values) {
    for (const auto& [name, value] : values) {
        const std::string mark = "@" + name + "@";
        for (size_t at = page.find(mark); at != page.npos; at = page.find(mark, at + value.size())) {
            page.replace(at, mark.size(), value);
        }
    }
    return page;
}

std::string gradient() {
    constexpr int stops = 16;
    std::string list;
    for (int i = 0; i <= stops; ++i) {
        const std::array<uint8_t, 3> rgb = magma(static_cast<float>(i) / stops);
        char color[16];
        std::snprintf(color, sizeof(color), "%s#%02x%02x%02x", i > 0 ? ", " : "", rgb[0], rgb[1], rgb[2]);
        list += color;
    }
    return list;
}

std::string rows(const std::vector<Measure>& measures) {
    std::string html;
    for (const Measure& measure : measures) {
        html += "<tr><td>" + escaped(measure.name) + "</td><td>" + escaped(measure.value) + "</td><td>" +
                escaped(measure.limit) + "</td></tr>\n";
    }
    return html;
}

std::vector<uint8_t> shown(const Picture& picture, PictureKind kind, double exposureEv) {
    if (kind == PictureKind::linear) return toneMap(picture, exposureEv);
    std::vector<uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (size_t i = 0; i < picture.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        rgb.push_back(static_cast<uint8_t>(std::lround(std::clamp(picture.rgba[i], 0.0f, 1.0f) * 255)));
    }
    return rgb;
}

std::string page(const CompareOptions& options, PictureKind kind, const Picture& size,
                 const Comparison& comparison, double exposureEv) {
    const std::vector<std::string> found = objections(comparison, options.limits);
    std::string listed;
    for (const std::string& objection : found) listed += "<p>" + escaped(objection) + "</p>\n";
    char exposure[80] = "", ppd[16];
    const bool linear = kind == PictureKind::linear;
    if (linear) {
        std::snprintf(exposure, sizeof(exposure), " Both are tone-mapped at an exposure of %.2f EV.",
                      exposureEv);
    }
    std::snprintf(ppd, sizeof(ppd), "%.0f", static_cast<double>(standardPixelsPerDegree));
    return filled(reportPage,
                  {{"VERDICT", found.empty() ? "same" : "different"},
                   {"CLASS", found.empty() ? "same" : "different"},
                   {"OBJECTIONS", listed},
                   {"REFERENCE", escaped(options.reference.string())},
                   {"TEST", escaped(options.test.string())},
                   {"SIZE", std::to_string(size.width) + " &times; " + std::to_string(size.height)},
                   {"WIDTH", std::to_string(std::max(size.width, pageWidth))},
                   {"RENDERING", size.width < pageWidth ? "image-rendering: pixelated;" : ""},
                   {"GRADIENT", gradient()},
                   {"EXPOSURE", exposure},
                   {"FLIP", linear ? "HDR-FLIP" : "FLIP"},
                   {"PPD", ppd},
                   {"ROWS", rows(measures(comparison, kind, options.limits))}});
}

} // namespace

bool checkReport(const CompareOptions& options, Error& error) {
    const fs::path& folder = options.report;
    if (!checkFolder("--report", folder, error)) return false;
    std::error_code code;
    if (!fs::exists(folder, code)) return true;
    for (const char* const name : pictures) {
        if (!checkOutput("--report", folder / name, {".png"}, error) ||
            !checkApart("--report", folder / name, {options.reference, options.test}, error)) {
            return false;
        }
    }
    return checkOutput("--report", folder / "index.html", {".html"}, error);
}

bool writeReport(const CompareOptions& options, PictureKind kind, const Picture& reference,
                 const Picture& test, const Comparison& comparison, Error& error) {
    std::error_code code;
    fs::create_directories(options.report, code);
    if (code) {
        error.text = "--report " + options.report.string() + ": cannot be made: " + code.message();
        return false;
    }
    const double exposureEv = options.exposureEv.value_or(middleGreyEv(comparison.exposures));
    const std::array<std::vector<uint8_t>, 3> contents = {
        shown(reference, kind, exposureEv), shown(test, kind, exposureEv), magma(comparison.flipMap)};
    for (size_t i = 0; i < pictures.size(); ++i) {
        if (!writePng(options.report / pictures[i], reference.width, reference.height, contents[i], error)) {
            return false;
        }
    }
    return writeText(options.report / "index.html", page(options, kind, reference, comparison, exposureEv),
                     error);
}

} // namespace demos
