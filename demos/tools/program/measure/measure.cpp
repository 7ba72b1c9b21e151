#include "program/measure/measure.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "measure/run.h"
#include "program/device/device_limit.h"
#include "program/device/lost_device.h"
#include "program/device/memory.h"
#include "program/device/no_device.h"
#include "program/interrupt.h"
#include "program/measure/left_out.h"
#include "program/measure/tradeoff_files.h"
#include "program/render/progress.h"
#include "program/scene_input.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Those of the folder that have a surface to measure, by name; all that cannot be read as well, for the
/// error to be told.
std::vector<fs::path> scenesThatMirror(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().extension() != ".toml") continue;
        Error unread;
        const std::optional<Scene> scene = loadScene(entry.path(), {}, unread);
        if (!scene || surfaceOf(*scene)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::optional<std::vector<measure::Subject>> readAll(const MeasureOptions& options, Error& error) {
    const std::optional<std::vector<const measure::Technique*>> techniques =
        measure::chooseTechniques(options.techniques, error);
    if (!techniques) return std::nullopt;
    const fs::path usual = "demos/scenes";
    const std::vector<fs::path> files = options.scenes.empty() ? scenesThatMirror(usual) : options.scenes;
    if (files.empty()) {
        error.text = "no scenes in " + usual.string() + ", expected SCENE.toml";
        return std::nullopt;
    }
    std::vector<measure::Subject> subjects;
    for (const fs::path& file : files) {
        const measure::SubjectDesc desc = {
            file, options.overrides, *techniques, options.cameras, options.firstCameraOnly, options.flat};
        std::optional<std::vector<measure::Subject>> found = measure::readSubjects(desc, error);
        if (!found) return std::nullopt;
        std::move(found->begin(), found->end(), std::back_inserter(subjects));
    }
    return subjects;
}

/// Beside the frame: the reference, what is drawn for a comparison, and each technique's images and picture.
double bytesAPixel(const std::vector<measure::Subject>& subjects, uint32_t supersample) {
    constexpr double pictures = 8 * 16, technique = 48;
    size_t most = 0;
    for (const measure::Subject& subject : subjects) most = std::max(most, subject.variants.size());
    return frameBytesAPixel * supersample * supersample + pictures + technique * static_cast<double>(most);
}

/// All of them before any is measured: what cannot be read is bad input, and leaves nothing behind.
bool canBeLoaded(Host& host, const std::vector<measure::Subject>& subjects, bool strict, Progress& progress,
                 Error& error) {
    for (const measure::Subject& subject : subjects) {
        progress.say("loading " + subject.file);
        if (!host.load(subject.scene, error)) {
            addPlace(subject.scene, error);
            return false;
        }
        progress.clear();
        if (!sayLeftOut(host.leftOut(), subject.scene, strict, error)) return false;
    }
    return true;
}

measure::Tradeoff emptyTradeoff(const MeasureOptions& options, const Host& host) {
    measure::Tradeoff tradeoff;
    tradeoff.device = host.device().name;
    tradeoff.driver = host.device().driver;
    tradeoff.clock = host.clock();
    tradeoff.width = options.size.width;
    tradeoff.height = options.size.height;
    tradeoff.runs = options.rounds;
    tradeoff.samples = options.samples;
    tradeoff.supersample = options.supersample;
    tradeoff.flat = options.flat;
    return tradeoff;
}

std::string text(const char* format, const std::optional<double>& value) {
    char line[32] = "-";
    if (value) std::snprintf(line, sizeof(line), format, *value);
    return line;
}

void summarise(const measure::Tradeoff& tradeoff) {
    std::printf("%s, %ux%u, by %s, floor %s ms\n", tradeoff.device.c_str(), tradeoff.width, tradeoff.height,
                describe(tradeoff.clock), text("%.3f", tradeoff.floorMs()).c_str());
    std::printf("%-18s %9s %9s %8s %8s %9s %8s  %s\n", "technique", "ms", "x floor", "FLIP", "PSNR dB",
                "coverage", "off px", "camera");
    for (const measure::Entry& entry : tradeoff.entries)
        std::printf("%-18s %9.3f %9s %8s %8s %9s %8s  %s of %s\n", entry.name().c_str(),
                    entry.cost.reflection.ms, text("%.2f", entry.cost.xFloor).c_str(),
                    text("%.4f", entry.error.flip).c_str(), text("%.2f", entry.error.psnrDb).c_str(),
                    text("%.3f", entry.error.coverage).c_str(),
                    text("%.2f", entry.error.positionPxP50).c_str(), entry.camera.c_str(),
                    fs::path(entry.scene).filename().string().c_str());
}

/// `why` it ended early.
void sayWhatIsDone(const std::string& why, const TradeoffFiles& files, size_t views, Error& error) {
    const size_t done = files.tradeoff().sheets.size();
    error.text = why + ": " + std::to_string(done) + " of " + std::to_string(views) + " views measured";
    if (done > 0) error.text += ", see " + fs::absolute(files.page()).lexically_normal().string();
}

/// Of each subject what its views give, to the files as it is known.
ExitCode measureAll(Host& host, const std::vector<measure::Subject>& subjects, const MeasureOptions& options,
                    TradeoffFiles& files, Progress& progress, Error& error) {
    const Interrupt interrupt;
    const auto say = [&](const std::string& what, uint32_t done, uint32_t all) {
        progress.say(what, done, all);
        return !interrupt.wished();
    };
    const auto write = [&](measure::ViewResult&& view, Error& problem) {
        return files.add(std::move(view), problem);
    };
    size_t views = 0;
    for (const measure::Subject& subject : subjects) views += subject.cameras.size();
    const measure::RunDesc desc = {options.size.width, options.size.height, options.rounds, options.samples,
                                   options.supersample};
    for (const measure::Subject& subject : subjects)
        switch (measure::measureSubject(host, subject, desc, say, write, error)) {
        case measure::RunResult::ok:
            break;
        case measure::RunResult::failed:
            progress.clear();
            if (host.lost()) sayWhatIsDone(error.text, files, views, error);
            endIfLost(host, error);
            return runFailed;
        case measure::RunResult::stopped:
            sayWhatIsDone("interrupted", files, views, error);
            return interrupted;
        }
    progress.clear();
    return ok;
}

} // namespace

ExitCode measureTechniques(const MeasureOptions& options, Error& error) {
    const std::optional<std::vector<measure::Subject>> subjects = readAll(options, error);
    if (!subjects || !checkTradeoffFiles(options.folder, error) ||
        !fitsMemory(options.size, bytesAPixel(*subjects, options.supersample), error))
        return badInput;

    Progress progress;
    progress.say("opening the device");
    const std::unique_ptr<Host> host = Host::create({options.device, false}, error);
    if (!host) {
        explainNoDevice(error);
        return badInput;
    }
    TradeoffFiles files(options.folder, emptyTradeoff(options, *host));
    if (!fitsDevice(options.size, options.supersample, host->device(), error) ||
        !canBeLoaded(*host, *subjects, options.strict, progress, error) || !files.makeFolder(error)) {
        endIfLost(*host, error);
        return badInput;
    }

    if (const ExitCode code = measureAll(*host, *subjects, options, files, progress, error); code != ok)
        return code;
    if (!files.whyNoPlots().empty()) std::fprintf(stderr, "warning: %s\n", files.whyNoPlots().c_str());
    summarise(files.tradeoff());
    std::printf("measured: %s\n", fs::absolute(files.page()).lexically_normal().c_str());
    return ok;
}

} // namespace demos
