#include "measure/page/page.h"

#include <cstdint>
#include <cstdio>

#include "measure/page/html.h"

namespace demos::measure {

namespace {

constexpr const char* head = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Cost and error of reflections</title>
<style>
:root { color-scheme: dark; }
body { margin: 0 auto; padding: 1.5rem; max-width: 80rem; background: #1b1d1f; color: #dcdfe2;
       font: 15px/1.5 system-ui, sans-serif; }
h1 { margin: 0 0 .25rem; font-size: 1.3rem; font-weight: 600; }
h2 { margin: 2.5rem 0 .5rem; font-size: 1rem; font-weight: 600; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; }
th, td { padding: .2rem .9rem .2rem 0; border-bottom: 1px solid #3a3e42; text-align: right; white-space: nowrap;
         font-variant-numeric: tabular-nums; }
th:first-child, td:first-child { text-align: left; }
th { font-weight: 600; }
.note { max-width: 60rem; color: #a4abb2; font-size: .85rem; }
img { display: block; width: 100%; }
.plot { max-width: 45rem; margin: 1rem 0; }
</style>
</head>
<body>
<h1>Cost and error of reflections</h1>
)html";

constexpr const char* notes =
    R"html(<p class="note">Cost is that of the reflection's own passes; the surface's drawing is given beside it, and the whole surface: its waves, its
reflection and its drawing, also as a multiple of a trivial pass, a full-screen triangle that copies a picture. The
floor is a compute copy of the frame's colour (RGBA16F) and depth (R32F), timed between the same frames, or in their
submissions where whole frames are timed. &plusmn; is the interquartile range. FLIP and wrong (the share that is off by more than 5 % of white in some channel) compare the
tone-mapped picture with the ray-traced one over the pixels of the surface that mirrors, water or polished floor. What is
mirrored can be recovered where it is seen elsewhere in the picture: PSNR is that of the reflection there, before Fresnel;
found is the share that the technique found, and off by how far from the mirrored point it was then taken. Sky as solid
and solid as sky are mistakes about the sky. A dash is what was not measured or has no pixel. In the plots, filled marks
are beaten by no other in both cost and error.</p>
)html";

std::string print(const char* format, const std::optional<double>& value) {
    char text[32] = "&ndash;";
    if (value) std::snprintf(text, sizeof(text), format, *value);
    return text;
}

std::optional<double> drawingMs(const Entry& entry) {
    for (const PassTime& pass : entry.cost.passes)
        if (pass.name == "water_draw" || pass.name == "mirror_draw") return pass.ms;
    return std::nullopt;
}

std::string table(const Tradeoff& tradeoff, const Sheet& sheet) {
    std::string html = "<div class=\"scroll\"><table>\n<tr>";
    for (const char* const name :
         {"technique", "ms", "&plusmn;", "&times; floor", "floor, ms", "surface drawn, ms",
          "whole surface, ms", "&times; trivial", "MB", "FLIP", "wrong", "PSNR, dB", "exactly placed",
          "found", "off, px: median", "p95", "sky as solid", "inside it", "solid as sky"})
        html += std::string("<th>") + name + "</th>";
    html += "</tr>\n";
    for (const Entry& entry : tradeoff.of(sheet)) {
        const Cost& cost = entry.cost;
        const PictureError& error = entry.error;
        std::optional<double> megabytes;
        if (cost.bytes) megabytes = static_cast<double>(*cost.bytes) / 1e6;
        html += "<tr><td>" + escaped(entry.name()) + "</td>";
        for (const std::string& cell :
             {print("%.3f", cost.reflection.ms), print("%.3f", cost.reflection.spreadMs),
              print("%.2f", cost.xFloor), print("%.3f", cost.floor.ms), print("%.1f", drawingMs(entry)),
              print("%.1f", cost.surfaceMs), print("%.1f", cost.xTrivial), print("%.1f", megabytes),
              print("%.4f", error.flip), print("%.4f", error.wrongShare), print("%.2f", error.psnrDb),
              print("%.2f", error.psnrExactDb), print("%.4f", error.coverage),
              print("%.2f", error.positionPxP50), print("%.2f", error.positionPxP95),
              print("%.4f", error.falseSkyHits), print("%.4f", error.falseSkyHitsInside),
              print("%.4f", error.skyOnGeometry)})
            html += "<td>" + cell + "</td>";
        html += "</tr>\n";
    }
    return html + "</table></div>\n";
}

/// RFC 4648.
std::string base64(const std::string& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (size_t j = i; j < i + 3; ++j)
            group = group << 8 | (j < bytes.size() ? static_cast<uint8_t>(bytes[j]) : 0u);
        for (size_t digit = 0; digit < 4; ++digit)
            text += i + digit > bytes.size() ? '=' : digits[group >> (18 - 6 * digit) & 63];
    }
    return text;
}

} // namespace

std::string tradeoffPage(const Tradeoff& tradeoff, const std::vector<SheetFiles>& files) {
    char size[256];
    std::snprintf(size, sizeof(size), "%u &times; %u, medians of %u by %s, floor %s ms", tradeoff.width,
                  tradeoff.height, tradeoff.runs, describe(tradeoff.clock),
                  print("%.3f", tradeoff.floorMs()).c_str());
    std::string html = head;
    html += "<p>" + escaped(tradeoff.device) + ", " + escaped(tradeoff.driver) + "; " + size +
            (tradeoff.flat ? ", the water stilled" : "") + "</p>\n" + notes;
    for (size_t i = 0; i < files.size(); ++i) {
        const Sheet& sheet = tradeoff.sheets[i];
        html += "<h2>" + escaped(sheet.scene) + ", camera " + escaped(sheet.camera) + "</h2>\n" +
                table(tradeoff, sheet);
        if (!files[i].svg.empty())
            html += "<img class=\"plot\" alt=\"Error against cost\" src=\"data:image/svg+xml;base64," +
                    base64(files[i].svg) + "\">\n";
        html += "<p class=\"note\">Pictures, row by row: reference";
        for (const Entry& entry : tradeoff.of(sheet)) html += "; " + escaped(entry.name());
        html += "</p>\n<img alt=\"The reference and each technique\" src=\"data:image/png;base64," +
                base64(files[i].png) + "\">\n";
    }
    return html + "</body>\n</html>\n";
}

} // namespace demos::measure
