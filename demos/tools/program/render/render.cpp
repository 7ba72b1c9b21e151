#include "program/render/render.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "host/files/image_file.h"
#include "host/lens/meter.h"
#include "host/passes/supersample.h"
#include "metrics/finite.h"
#include "program/compare/visualise.h"
#include "program/device/device_limit.h"
#include "program/device/lost_device.h"
#include "program/device/memory.h"
#include "program/device/no_device.h"
#include "program/device/validation.h"
#include "program/measure/left_out.h"
#include "program/render/output.h"
#include "program/render/progress.h"
#include "program/render/stats.h"
#include "program/scene_input.h"
#include "program/sea/lost_waves.h"
#include "scene/offset.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

constexpr double timingSeconds = 2;
constexpr uint32_t timingRuns = 3;
constexpr uint32_t statsRuns = 15;

bool checkMemory(const RenderOptions& options, Error& error) {
    return fitsMemory(options.size, frameBytesAPixel * options.supersample * options.supersample, error);
}

/// Nobody has asked for it, so that it may be left.
void supersampleWherePossible(RenderOptions& options, const DeviceInfo& device) {
    RenderOptions larger = options;
    larger.supersample = 2;
    Error unheard;
    if (fitsDevice(larger.size, larger.supersample, device, unheard) && checkMemory(larger, unheard))
        options.supersample = larger.supersample;
}

bool checkOutputs(const RenderOptions& options, const Scene& scene, Error& error) {
    if (!checkPictures(options, scene, error)) return false;
    if (options.stats.empty()) return true;
    return checkOutput("--stats", options.stats, {".json"}, error);
}

bool write(const fs::path& file, const Picture& picture, const std::optional<Visualised>& visualised,
           Error& error) {
    if (!isPng(file)) return writeExr(file, picture, error);
    return writePng(file, picture.width, picture.height, visualised->rgb, error);
}

std::string sizeText(uint32_t width, uint32_t height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

class Run {
  public:
    Run(const RenderOptions& options, const Scene& scene, const CameraDesc& camera, Host& host)
        : options_(options), scene_(scene), host_(host), exposureEv_(scene.exposureEv) {
        frame_ = {options.size.width * options.supersample,
                  options.size.height * options.supersample,
                  camera,
                  options.timeS.value_or(scene.timeS),
                  options.aov,
                  0,
                  options.mistake};
        frame_.bloom = frame_.skyDetail = options.lens;
    }

    bool all(Progress& progress, Error& error) {
        double lastMs = 0;
        const double start = frame_.timeS;
        for (uint32_t i = 0; i < options_.frames; ++i) {
            progress.say("rendering frame", i, options_.frames);
            frame_.timeS = start + i / options_.fps;
            frame_.follows = i > 0;
            const auto began = std::chrono::steady_clock::now();
            const std::optional<Picture> picture = host_.render(frame_, error);
            if (!picture) return false;
            lastMs = millisecondsSince(began);
            if (options_.metered && i == 0) exposureEv_ = meteredEv(*picture);
            const bool larger = options_.supersample > 1;
            if (!keep(larger ? averaged(*picture, options_.supersample) : *picture, i, progress, error))
                return false;
        }
        if (options_.untimed) return true;
        progress.say("measuring");
        return options_.stats.empty() ? timeAtHand(lastMs, error) : timeByPass(error);
    }

    void summarise() const {
        if (times_) std::fputs(statsTable(*times_).c_str(), stdout);
        if (!scale_.empty()) std::printf("scale: %s\n", scale_.c_str());
        if (options_.metered) std::printf("exposure_ev: %.2f, metered\n", exposureEv_);
        for (const auto& [first, last] : written_) {
            const std::string until = first == last ? "" : " .. " + last.filename().string();
            const std::string sampled =
                options_.supersample == 1 ? "" : " from " + sizeText(frame_.width, frame_.height);
            std::printf("%s: %s%s, %s%s%s\n", host_.device().name.c_str(),
                        sizeText(options_.size.width, options_.size.height).c_str(), sampled.c_str(),
                        timeText().c_str(), first.string().c_str(), until.c_str());
        }
    }

  private:
    std::string timeText() const {
        if (options_.untimed) return {};
        char text[48];
        std::snprintf(text, sizeof(text), "%.1f ms a frame, ", frameMs_);
        return text;
    }

    /// As often as there is patience for: nobody asked.
    bool timeAtHand(double lastMs, Error& error) {
        const auto affordable = static_cast<uint32_t>(std::clamp(1000 * timingSeconds / lastMs, 1.0, 1e3));
        const std::optional<double> ms = host_.frameMs(frame_, std::min(affordable, timingRuns), error);
        frameMs_ = ms.value_or(0);
        return ms.has_value();
    }

    bool timeByPass(Error& error) {
        times_ = host_.measure(frame_, statsRuns, error);
        if (!times_) return false;
        frameMs_ = times_->frameMs;
        return writeText(options_.stats,
                         statsJson(host_.device(), options_.size, scene_, frame_.camera, *times_), error);
    }

    bool keep(const Picture& picture, uint32_t index, Progress& progress, Error& error) {
        const Infinity infinity = options_.aov == Aov::depth ? Infinity::far : Infinity::broken;
        const PixelView image{picture.width, picture.height, picture.rgba};
        if (const uint64_t broken = countNotFinite(image, infinity)) {
            progress.clear();
            std::fprintf(stderr, "warning: frame %u holds %llu pixels of NaN or infinity\n", index,
                         static_cast<unsigned long long>(broken));
        }
        std::optional<Visualised> visualised;
        if (std::any_of(options_.outputs.begin(), options_.outputs.end(), isPng)) {
            visualised = visualise(picture, options_.aov, exposureEv_);
            scale_ = visualised->scale;
        }
        written_.resize(options_.outputs.size());
        for (size_t i = 0; i < options_.outputs.size(); ++i) {
            const fs::path& output = options_.outputs[i];
            const fs::path file = fs::absolute(options_.numbered ? numbered(output, index) : output);
            if (!write(file, picture, visualised, error)) return false;
            if (index == 0) written_[i].first = file;
            written_[i].second = file;
        }
        return true;
    }

    const RenderOptions& options_;
    const Scene& scene_;
    Host& host_;
    FrameDesc frame_;
    double exposureEv_; // of all frames
    double frameMs_ = 0;
    std::optional<FrameTimes> times_; // by pass, if asked for
    std::string scale_;
    std::vector<std::pair<fs::path, fs::path>> written_; // first and last, of each output
};

} // namespace

ExitCode renderScene(const RenderOptions& asked, Error& error) {
    RenderOptions options = asked;
    options.supersample = std::max(asked.supersample, 1u);
    std::optional<Scene> scene = readScene(options, error);
    if (!scene) return badInput;
    std::optional<CameraDesc> camera = chooseCamera(*scene, options.camera, error);
    if (!camera || !checkOutputs(options, *scene, error) || !checkMemory(options, error)) return badInput;
    applyOffset(*scene, *camera);

    Progress progress;
    progress.say("opening the device");
    const std::unique_ptr<Host> host = Host::create({options.device, options.validation}, error);
    if (!host) {
        explainNoDevice(error);
        return badInput;
    }
    if (!fitsDevice(options.size, options.supersample, host->device(), error)) return badInput;
    if (asked.supersample == 0 && options.lens) supersampleWherePossible(options, host->device());
    progress.say("loading " + scene->file.filename().string());
    if (!host->load(*scene, error)) {
        endIfLost(*host, error);
        addPlace(*scene, error);
        return badInput;
    }
    progress.clear();
    if (!sayLeftOut(host->leftOut(), *scene, options.strict, error)) return badInput;
    warnOfLostWaves(host->resolvedShare(), leastResolvedInPictures, scene->file.filename().string() + ": ",
                    "water.waves.largest_patch_m", "water.waves.samples and water.waves.cascades");
    Run run(options, *scene, *camera, *host);
    const bool done = run.all(progress, error);
    progress.clear();
    if (!done) {
        endIfLost(*host, error);
        return runFailed;
    }
    run.summarise();
    return judgeValidation(*host, error);
}

} // namespace demos
