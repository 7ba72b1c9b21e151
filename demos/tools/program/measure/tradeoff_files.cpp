#include "program/measure/tradeoff_files.h"

#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>

#include "host/files/image_file.h"
#include "measure/page/contact_sheet.h"
#include "measure/page/page.h"
#include "measure/page/plot.h"
#include "measure/page/table.h"
#include "program/measure/gnuplot.h"
#include "program/render/output.h"

namespace demos {

namespace fs = std::filesystem;

namespace {

/// "1_harbour_level": a camera may be called anything.
std::string nameOf(const measure::ViewResult& view, size_t number) {
    std::string name =
        std::to_string(number) + "_" + fs::path(view.scene).stem().string() + "_" + view.camera;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    return name;
}

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

bool checkTradeoffFiles(const fs::path& folder, Error& error) {
    if (!checkFolder("-o", folder, error)) return false;
    std::error_code code;
    if (!fs::exists(folder, code)) return true;
    return checkOutput("-o", folder / "tradeoff.json", {".json"}, error) &&
           checkOutput("-o", folder / "tradeoff.csv", {".csv"}, error) &&
           checkOutput("-o", folder / "tradeoff.md", {".md"}, error) &&
           checkOutput("-o", folder / "index.html", {".html"}, error);
}

bool TradeoffFiles::makeFolder(Error& error) const {
    std::error_code code;
    fs::create_directories(folder_, code);
    if (code) {
        error.text = "-o " + folder_.string() + ": cannot be made: " + code.message();
        return false;
    }
    // Neither rights nor the file system's kind tell for certain.
    const fs::path probe = folder_ / ".seaglass";
    if (!writeText(probe, "", error)) {
        error.text = "-o " + folder_.string() + ": cannot be written to, expected a folder that can";
        return false;
    }
    fs::remove(probe, code);
    return true;
}

bool TradeoffFiles::add(measure::ViewResult view, Error& error) {
    const measure::Sheet sheet = {view.scene, view.camera, nameOf(view, tradeoff_.sheets.size() + 1),
                                  tradeoff_.entries.size(), view.entries.size()};
    const measure::ContactSheet contact = contactSheet(view, tradeoff_.width, tradeoff_.height);
    if (!writePng(folder_ / (sheet.file + ".png"), contact.width, contact.height, contact.rgb, error))
        return false;
    std::move(view.entries.begin(), view.entries.end(), std::back_inserter(tradeoff_.entries));
    tradeoff_.sheets.push_back(sheet);
    return plot(sheet, error) && writeTables(error);
}

bool TradeoffFiles::plot(const measure::Sheet& sheet, Error& error) {
    const fs::path script = folder_ / (sheet.file + ".gp");
    if (!writeText(script, plotScript(tradeoff_, sheet, sheet.file + ".svg"), error)) return false;
    Error problem;
    if (runGnuplot(script, problem) != Plotted::yes) whyNoPlots_ = problem.text;
    return true;
}

bool TradeoffFiles::writeTables(Error& error) const {
    std::vector<measure::SheetFiles> files;
    for (const measure::Sheet& sheet : tradeoff_.sheets)
        files.push_back({bytesOf(folder_ / (sheet.file + ".png")), bytesOf(folder_ / (sheet.file + ".svg"))});
    return writeText(folder_ / "tradeoff.json", tradeoffJson(tradeoff_), error) &&
           writeText(folder_ / "tradeoff.csv", tradeoffCsv(tradeoff_), error) &&
           writeText(folder_ / "tradeoff.md", tradeoffMarkdown(tradeoff_), error) &&
           writeText(page(), tradeoffPage(tradeoff_, files), error);
}

} // namespace demos
