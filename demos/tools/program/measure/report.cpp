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

/// Grey is left out.
std::vector<uint8_t> mapOf(const Pair& pair) {
    constexpr uint8_t grey = 96;
    std::vector<uint8_t> rgb = magma(pair.comparison.flipMap);
    for (size_t i = 0; i < pair.leftOut.size(); ++i)
        if (pair.leftOut[i] != 0) std::fill_n(&rgb[3 * i], 3, grey);
    return rgb;
}

bool isWithin(const fs::path& inner, const fs::path& outer) {
    std::error_code code;
    const fs::path a = fs::weakly_canonical(inner, code), b = fs::weakly_canonical(outer, code);
    return std::mismatch(b.begin(), b.end(), a.begin(), a.end()).first == b.end();
}

std::string boxHtml(const Blob& blob, const Picture& size) {
    if (blob.pixels == 0) return {};
    const auto percent = [](uint32_t of, uint32_t whole) { return 100.0 * of / whole; };
    char html[160];
    std::snprintf(html, sizeof(html),
                  "\n  <div class=\"box\" style=\"left:%.3f%%;top:%.3f%%;width:%.3f%%;height:%.3f%%\"></div>",
                  percent(blob.left, size.width), percent(blob.top, size.height),
                  percent(blob.width, size.width), percent(blob.height, size.height));
    return html;
}

/// Both pictures and the map around the most wrong pixels that touch, enlarged.
std::string zoomHtml(const Blob& blob, const Picture& size, const std::string& folder) {
    constexpr uint32_t least = 24, shownWidth = 300;
    if (blob.pixels == 0) return {};
    const uint32_t wide = std::min(std::max(blob.width + blob.width / 2, least), size.width),
                   high = std::min(std::max(blob.height + blob.height / 2, least), size.height);
    const auto from = [](uint32_t start, uint32_t extent, uint32_t shown, uint32_t whole) {
        const uint32_t middle = start + extent / 2;
        return std::min(middle - std::min(middle, shown / 2), whole - shown);
    };
    const double scale = static_cast<double>(shownWidth) / std::max(wide, high);
    char style[200];
    std::snprintf(style, sizeof(style),
                  "width:%.1fpx;height:%.1fpx;background-size:%.1fpx;background-position:%.1fpx %.1fpx",
                  scale * wide, scale * high, scale * size.width,
                  -scale * from(blob.left, blob.width, wide, size.width),
                  -scale * from(blob.top, blob.height, high, size.height));
    std::string html =
        "<p class=\"note\">Where most wrong pixels touch: reference, test, map</p>\n<div class=\"zooms\">";
    for (const char* const name : pictures)
        html +=
            "<div style=\"" + std::string(style) + ";background-image:url('" + folder + name + "')\"></div>";
    return html + "</div>\n";
}

std::string section(const CompareOptions& options, const Pair& pair, const std::string& folder,
                    double exposureEv) {
    const Picture& size = pair.expected();
    char exposure[80] = "";
    const bool linear = pair.kind == PictureKind::linear;
    if (linear) {
        std::snprintf(exposure, sizeof(exposure), " Both are tone-mapped at an exposure of %.2f EV.",
                      exposureEv);
    }
    return filled(reportPictures,
                  {{"REFERENCE", escaped(options.reference.string())},
                   {"TEST", escaped(options.test.string())},
                   {"SIZE", std::to_string(size.width) + " &times; " + std::to_string(size.height)},
                   {"SMALL", size.width < pageWidth ? "small" : ""},
                   {"ID", escaped(folder)},
                   {"FOLDER", folder},
                   {"BOX", boxHtml(pair.comparison.wrong.largest, size)},
                   {"ZOOM", zoomHtml(pair.comparison.wrong.largest, size, folder)},
                   {"EXPOSURE", exposure},
                   {"FLIP", linear ? "HDR-FLIP" : "FLIP"},
                   {"ROWS", rows(measures(pair.comparison, pair.kind, pair.limits))}});
}

std::string heading(const Judged& one) {
    return filled(reportHeading,
                  {{"PASSED", gating(one) == ok ? "passed" : "failed"},
                   {"CLASS", one.code == badInput ? "bad" : verdict(one)},
                   {"VERDICT", verdict(one)},
                   {"NAME", escaped(one.name)},
                   {"OBJECTIONS", one.why.empty() ? "" : "<p>" + escaped(one.why) + "</p>\n"}});
}

std::string page(const std::vector<Judged>& all) {
    std::vector<const Judged*> worstFirst;
    for (const Judged& one : all) worstFirst.push_back(&one);
    std::stable_sort(worstFirst.begin(), worstFirst.end(), [](const Judged* a, const Judged* b) {
        return a->code != b->code ? a->code > b->code : a->badness > b->badness;
    });
    const auto failed =
        std::count_if(all.begin(), all.end(), [](const Judged& one) { return gating(one) != ok; });
    char ppd[16];
    std::snprintf(ppd, sizeof(ppd), "%.0f", static_cast<double>(standardPixelsPerDegree));
    std::string html = filled(
        reportHead, {{"TITLE", std::to_string(failed) + " of " + std::to_string(all.size()) + " failed"},
                     {"WIDTH", std::to_string(pageWidth)},
                     {"GRADIENT", gradient()},
                     {"PPD", ppd}});
    for (const Judged* const one : worstFirst) html += heading(*one) + one->section + "</section>\n";
    return html + reportTail;
}

} // namespace

bool checkReport(const CompareOptions& options, Error& error) {
    const fs::path& folder = options.report;
    if (!checkFolder("--report", folder, error)) return false;
    std::error_code code;
    for (const fs::path& read : {options.reference, options.test}) {
        if (!fs::is_directory(read, code) || !isWithin(folder, read)) continue;
        error.text = "--report " + folder.string() + ": is within " + read.string() +
                     ", which is read, expected another folder";
        return false;
    }
    if (!fs::exists(folder, code)) return true;
    for (const char* const name : pictures) {
        if (!checkOutput("--report", folder / name, {".png"}, error) ||
            !checkApart("--report", folder / name, {options.reference, options.test}, error)) {
            return false;
        }
    }
    return checkOutput("--report", folder / "index.html", {".html"}, error);
}

bool addSection(const CompareOptions& options, const Pair& pair, const fs::path& folder, Judged& judged,
                Error& error) {
    std::error_code code;
    fs::create_directories(options.report / folder, code);
    if (code) {
        error.text = "--report " + options.report.string() + ": cannot be made: " + code.message();
        return false;
    }
    const Picture& size = pair.expected();
    const double exposureEv = options.exposureEv.value_or(middleGreyEv(pair.comparison.exposures));
    const std::array<std::vector<uint8_t>, 3> contents = {
        shown(size, pair.kind, exposureEv), shown(pair.actual(), pair.kind, exposureEv), mapOf(pair)};
    for (size_t i = 0; i < pictures.size(); ++i) {
        if (!writePng(options.report / folder / pictures[i], size.width, size.height, contents[i], error))
            return false;
    }
    judged.section = section(options, pair, folder.string(), exposureEv);
    return true;
}

bool writeReport(const CompareOptions& options, const std::vector<Judged>& all, Error& error) {
    std::error_code code;
    fs::create_directories(options.report, code);
    const fs::path index = options.report / "index.html";
    if (!writeText(index, page(all), error)) return false;
    std::printf("report: %s\n", fs::absolute(index).c_str());
    return true;
}

} // namespace demos
