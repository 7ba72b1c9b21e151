#include "program/measure/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

#include "measure/page/html.h"
#include "metrics/magma.h"
#include "program/measure/report_gathered.h"
#include "program/measure/report_page.h"
#include "program/measure/report_section.h"
#include "program/render/output.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

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

bool isWithin(const fs::path& inner, const fs::path& outer) {
    std::error_code code;
    const fs::path a = fs::weakly_canonical(inner, code), b = fs::weakly_canonical(outer, code);
    return std::mismatch(b.begin(), b.end(), a.begin(), a.end()).first == b.end();
}

std::string heading(const Judged& one) {
    return filled(reportHeading,
                  {{"PASSED", gating(one) == ok ? "passed" : "failed"},
                   {"CLASS", one.code == badInput ? "bad" : verdict(one)},
                   {"VERDICT", verdict(one)},
                   {"NAME", escaped(one.name)},
                   {"OBJECTIONS", one.why.empty() ? "" : "<p>" + escaped(one.why) + "</p>\n"}});
}

std::string countOf(const std::vector<Judged>& all) {
    const auto failed =
        std::count_if(all.begin(), all.end(), [](const Judged& one) { return gating(one) != ok; });
    return std::to_string(failed) + " of " + std::to_string(all.size()) + " failed";
}

std::string page(const std::vector<Judged>& all, const std::string& title) {
    std::vector<const Judged*> worstFirst;
    for (const Judged& one : all) worstFirst.push_back(&one);
    std::stable_sort(worstFirst.begin(), worstFirst.end(), [](const Judged* a, const Judged* b) {
        return a->code != b->code ? a->code > b->code : a->badness > b->badness;
    });
    char ppd[16];
    std::snprintf(ppd, sizeof(ppd), "%.0f", static_cast<double>(standardPixelsPerDegree));
    std::string html = filled(reportHead, {{"TITLE", title.empty() ? countOf(all) : title},
                                           {"WIDTH", std::to_string(reportWidth)},
                                           {"GRADIENT", gradient()},
                                           {"PPD", ppd}});
    for (const Judged* const one : worstFirst)
        html += heading(*one) + filled(one->section, {{"FOLDER", ""}}) + "</section>\n";
    return html + reportTail;
}

bool writePage(const fs::path& folder, const std::vector<Judged>& all, const std::string& title,
               Error& error) {
    const fs::path index = folder / "index.html";
    if (!writeText(index, page(all, title), error)) return false;
    std::printf("report: %s\n", fs::absolute(index).c_str());
    return true;
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
    for (const char* const name : reportFiles) {
        if (!checkOutput("--report", folder / name, {".png"}, error) ||
            !checkApart("--report", folder / name, {options.reference, options.test}, error)) {
            return false;
        }
    }
    return checkOutput("--report", folder / "index.html", {".html"}, error);
}

bool writeReport(const fs::path& folder, const std::vector<Judged>& all, Error& error,
                 const std::string& title) {
    std::error_code code;
    fs::create_directories(folder, code);
    return writeText(folder / gatheredName, gatherable(all), error) && writePage(folder, all, title, error);
}

ExitCode gatherReports(const fs::path& folder, Error& error) {
    const std::vector<Judged> all = gathered(folder);
    if (!all.empty()) return writePage(folder, all, {}, error) ? ok : badInput;
    error.text = folder.string() + ": no folder in it has a " + gatheredName +
                 ", expected those that seaglass compare --report FOLDER/NAME leaves";
    return badInput;
}

} // namespace demos
