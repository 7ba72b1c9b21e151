#include "program/measure.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <system_error>

#include "host/image_file.h"
#include "measure/contact_sheet.h"
#include "measure/page.h"
#include "measure/plot.h"
#include "measure/run.h"
#include "measure/table.h"
#include "program/no_device.h"
#include "program/output.h"
#include "program/progress.h"
#include "program/scene_input.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

bool checkOutputs(const MeasureOptions& options, Error& error) {
    if (!checkFolder("-o", options.folder, error)) return false;
    std::error_code code;
    if (!fs::exists(options.folder, code)) return true;
    return checkOutput("-o", options.folder / "tradeoff.json", {".json"}, error) &&
           checkOutput("-o", options.folder / "tradeoff.csv", {".csv"}, error) &&
           checkOutput("-o", options.folder / "index.html", {".html"}, error);
}

/// "1_harbour_level": a camera may be called anything.
std::string nameOf(const measure::Sheet& sheet, size_t number) {
    std::string name =
        std::to_string(number) + "_" + fs::path(sheet.scene).stem().string() + "_" + sheet.camera;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    return name;
}

bool write(const MeasureOptions& options, const measure::Tradeoff& tradeoff, Error& error) {
    std::error_code code;
    fs::create_directories(options.folder, code);
    if (code) {
        error.text = "-o " + options.folder.string() + ": cannot be made: " + code.message();
        return false;
    }
    std::vector<std::string> sheets;
    for (const measure::Sheet& sheet : tradeoff.sheets) {
        const fs::path file = options.folder / nameOf(sheet, sheets.size() + 1);
        const measure::ContactSheet contact = contactSheet(sheet, tradeoff.width, tradeoff.height);
        if (!writePng(file.string() + ".png", contact.width, contact.height, contact.rgb, error) ||
            !writeText(file.string() + ".svg", plotSvg(tradeoff, sheet), error))
            return false;
        std::ifstream png(file.string() + ".png", std::ios::binary);
        sheets.emplace_back(std::istreambuf_iterator<char>(png), std::istreambuf_iterator<char>());
    }
    return writeText(options.folder / "tradeoff.json", tradeoffJson(tradeoff), error) &&
           writeText(options.folder / "tradeoff.csv", tradeoffCsv(tradeoff), error) &&
           writeText(options.folder / "index.html", tradeoffPage(tradeoff, sheets), error);
}

std::string text(const char* format, const std::optional<double>& value) {
    char line[32] = "-";
    if (value) std::snprintf(line, sizeof(line), format, *value);
    return line;
}

void summarise(const measure::Tradeoff& tradeoff) {
    std::printf("%s, %ux%u, floor %s ms\n", tradeoff.device.c_str(), tradeoff.width, tradeoff.height,
                text("%.3f", tradeoff.floorMs()).c_str());
    std::printf("%-10s %9s %9s %8s %8s %9s %7s  %s\n", "technique", "ms", "x floor", "FLIP", "PSNR dB",
                "coverage", "wrong", "camera");
    for (const measure::Entry& entry : tradeoff.entries)
        std::printf("%-10s %9.3f %9s %8s %8s %9s %7s  %s of %s\n", entry.technique.c_str(),
                    entry.cost.reflection.ms, text("%.2f", entry.cost.xFloor).c_str(),
                    text("%.4f", entry.error.flip).c_str(), text("%.2f", entry.error.psnrDb).c_str(),
                    text("%.3f", entry.error.coverage).c_str(), text("%.3f", entry.error.wrongShare).c_str(),
                    entry.camera.c_str(), fs::path(entry.scene).filename().string().c_str());
}

} // namespace

ExitCode measureTechniques(const MeasureOptions& options, Error& error) {
    std::vector<std::vector<measure::Variant>> scenes;
    for (const fs::path& file : options.scenes) {
        std::optional<std::vector<measure::Variant>> variants = measure::variantsOf(file, error);
        if (!variants) return badInput;
        scenes.push_back(std::move(*variants));
    }
    if (!checkOutputs(options, error)) return badInput;

    Progress progress;
    progress.say("opening the device");
    const std::unique_ptr<Host> host = Host::create({options.device, false}, error);
    if (!host) {
        explainNoDevice(error);
        return badInput;
    }
    const DeviceInfo device = host->device();
    if (std::max(options.size.width, options.size.height) > device.longestSide) {
        error.text = "--size is over the limit of " + device.name + ", expected at most " +
                     std::to_string(device.longestSide) + " a side";
        return badInput;
    }
    measure::Tradeoff tradeoff;
    tradeoff.device = device.name;
    tradeoff.driver = device.driver;
    tradeoff.width = options.size.width;
    tradeoff.height = options.size.height;
    tradeoff.runs = options.runs;
    const measure::RunDesc desc = {options.size.width, options.size.height, options.runs,
                                   options.firstCameraOnly};
    const auto say = [&](const std::string& what, uint32_t done, uint32_t all) {
        progress.say(what, done, all);
    };
    for (const std::vector<measure::Variant>& variants : scenes) {
        const measure::RunResult result = measure::measureScene(*host, variants, desc, say, tradeoff, error);
        if (result == measure::RunResult::ok) continue;
        if (result == measure::RunResult::unreadable) addPlace(variants.front().scene, error);
        return result == measure::RunResult::unreadable ? badInput : runFailed;
    }
    if (!write(options, tradeoff, error)) return runFailed;
    progress.clear();
    summarise(tradeoff);
    std::printf("measured: %s\n", fs::absolute(options.folder / "index.html").lexically_normal().c_str());
    return ok;
}

} // namespace demos
