#include "program/measure/report_section.h"

#include <algorithm>
#include <cstdio>
#include <system_error>

#include <nlohmann/json.hpp>

#include "host/files/image_file.h"
#include "measure/page/html.h"
#include "program/measure/measures.h"
#include "program/measure/report_page.h"
#include "program/measure/report_pictures.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// In place of the page's way to a section's pictures, which each page fills in.
constexpr const char* toReport = "@FOLDER@";

std::string rows(const std::vector<Measure>& measures) {
    std::string html;
    for (const Measure& measure : measures) {
        html += "<tr><td>" + escaped(measure.name) + "</td><td>" + escaped(measure.value) + "</td><td>" +
                escaped(measure.limit) + "</td></tr>\n";
    }
    return html;
}

std::string smallClass(const Picture& picture) {
    return picture.width < reportWidth ? "small" : "";
}

std::string boxHtml(const Blob& blob, const Picture& size) {
    const auto percent = [](uint32_t of, uint32_t whole) { return 100.0 * of / whole; };
    char html[160];
    std::snprintf(html, sizeof(html),
                  "\n  <div class=\"box\" style=\"left:%.3f%%;top:%.3f%%;width:%.3f%%;height:%.3f%%\"></div>",
                  percent(blob.left, size.width), percent(blob.top, size.height),
                  percent(blob.width, size.width), percent(blob.height, size.height));
    return html;
}

/// Both pictures and the map around wrong pixels that touch, enlarged.
std::string zoomHtml(const Blob& blob, const Picture& size, const std::string& folder) {
    constexpr uint32_t least = 24, shownWidth = 300;
    const uint32_t wide = std::min(std::max(blob.width + blob.width / 2, least), size.width),
                   high = std::min(std::max(blob.height + blob.height / 2, least), size.height);
    const auto from = [](uint32_t start, uint32_t extent, uint32_t shown, uint32_t whole) {
        const uint32_t middle = start + extent / 2;
        return std::min(middle - std::min(middle, shown / 2), whole - shown);
    };
    const double scale = static_cast<double>(shownWidth) / std::max(wide, high);
    char text[240];
    std::snprintf(text, sizeof(text), "%ux%u at %u,%u, %llu wrong pixels: reference, test, map", blob.width,
                  blob.height, blob.left, blob.top, static_cast<unsigned long long>(blob.pixels));
    std::string html = "<p class=\"note\">" + std::string(text) + "</p>\n<div class=\"zooms\">";
    std::snprintf(text, sizeof(text),
                  "width:%.1fpx;height:%.1fpx;background-size:%.1fpx;background-position:%.1fpx %.1fpx",
                  scale * wide, scale * high, scale * size.width,
                  -scale * from(blob.left, blob.width, wide, size.width),
                  -scale * from(blob.top, blob.height, high, size.height));
    for (const char* const name : reportFiles)
        html +=
            "<div style=\"" + std::string(text) + ";background-image:url('" + folder + name + "')\"></div>";
    return html + "</div>\n";
}

bool makeFolder(const fs::path& folder, Error& error) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) error.text = "--report " + folder.string() + ": cannot be made: " + code.message();
    return !code;
}

std::string section(const CompareOptions& options, const Pair& pair, const std::string& folder,
                    const ReportPictures& pictures) {
    const Picture& size = pair.expected();
    std::string boxes, zooms;
    for (const Blob& blob : pictures.blobs) {
        boxes += boxHtml(blob, size);
        zooms += zoomHtml(blob, size, folder);
    }
    return filled(reportPair,
                  {{"REFERENCE", escaped(options.reference.string())},
                   {"TEST", escaped(options.test.string())},
                   {"SIZE", std::to_string(size.width) + " &times; " + std::to_string(size.height)},
                   {"SMALL", smallClass(size)},
                   {"ID", folder},
                   {"FOLDER", folder},
                   {"BOXES", boxes},
                   {"ZOOMS", zooms},
                   {"NOTE", pictures.note},
                   {"MAP", pictures.mapName},
                   {"LOW", pictures.ticks[0]},
                   {"QUARTER", pictures.ticks[1]},
                   {"HALF", pictures.ticks[2]},
                   {"THREE", pictures.ticks[3]},
                   {"HIGH", pictures.ticks[4]},
                   {"ROWS", rows(measures(pair.comparison, pair.kind, pair.limits))}});
}

} // namespace

std::string filled(std::string text, const std::map<std::string, std::string>& values) {
    for (const auto& [name, value] : values) {
        const std::string mark = "@" + name + "@";
        for (size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + value.size()))
            text.replace(at, mark.size(), value);
    }
    return text;
}

bool addSection(const CompareOptions& options, const Pair& pair, const fs::path& folder, Judged& judged,
                Error& error) {
    if (!makeFolder(options.report / folder, error)) return false;
    const Picture& size = pair.expected();
    const ReportPictures pictures = reportPictures(options, pair);
    const std::array<const std::vector<uint8_t>*, 3> contents = {&pictures.reference, &pictures.test,
                                                                 &pictures.map};
    for (size_t i = 0; i < reportFiles.size(); ++i) {
        if (!writePng(options.report / folder / reportFiles[i], size.width, size.height, *contents[i], error))
            return false;
    }
    judged.section = section(options, pair, toReport + folder.string(), pictures);
    return true;
}

bool addUnpaired(const CompareOptions& options, const fs::path& folder, Judged& judged, Error& error) {
    const std::array<std::pair<const char*, const fs::path*>, 2> sides = {
        {{"Reference", &options.reference}, {"Test", &options.test}}};
    for (size_t i = 0; i < sides.size(); ++i) {
        const auto& [which, file] = sides[i];
        Error unread; // the page says already what is wrong
        const std::optional<PictureFile> picture =
            readPictureFile(*file, {{}, "--layer", true}, limits::comparedPixels, unread);
        if (!picture) continue;
        if (!makeFolder(options.report / folder, error)) return false;
        std::string note;
        const std::vector<uint8_t> rgb = reportPicture(*picture, note);
        const uint32_t width = picture->picture.width, height = picture->picture.height;
        if (!writePng(options.report / folder / reportFiles[i], width, height, rgb, error)) return false;
        judged.section +=
            filled(reportAlone, {{"WHICH", which},
                                 {"FILE", escaped(file->string())},
                                 {"SIZE", std::to_string(width) + " &times; " + std::to_string(height)},
                                 {"NOTE", note},
                                 {"SMALL", smallClass(picture->picture)},
                                 {"PICTURE", toReport + folder.string() + reportFiles[i]}});
    }
    return true;
}

std::string sequenceSection(const nlohmann::ordered_json& steps) {
    std::string html;
    for (const auto& step : steps) {
        html += "<tr><td>" + escaped(fs::path(step["to"].get<std::string>()).filename().string()) + "</td>";
        for (const char* const measure : {"mean", "p99"}) {
            for (const char* const which : {"reference", "test"}) {
                char cell[48];
                std::snprintf(cell, sizeof(cell), "<td>%.4f</td>", step[which][measure].get<double>());
                html += cell;
            }
        }
        html += "</tr>\n";
    }
    return filled(reportSteps, {{"ROWS", html}});
}

} // namespace demos
