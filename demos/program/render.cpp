#include "program/render.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>

#include "host/image_file.h"
#include "program/no_device.h"
#include "program/output.h"
#include "program/progress.h"
#include "program/stats.h"
#include "program/supersample.h"
#include "program/visualise.h"
#include "scene/nearest.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Attachments, their copies, reflections and read-back of a frame, for each pixel. On a CPU device all of it
/// is ordinary memory.
constexpr double bytesAPixel = 160;

constexpr double timingSeconds = 2;
constexpr uint32_t timingRuns = 3;
constexpr uint32_t statsRuns = 15;

bool isRegularFile(const std::string& option, const fs::path& file, const std::string& expected,
                   Error& error) {
    std::error_code code;
    if (fs::is_regular_file(file, code)) return true;
    const std::string why = fs::is_directory(file, code) ? "is a folder" : "no such file";
    error.text = option + " " + file.string() + ": " + why + ", expected " + expected;
    return false;
}

/// The scene with --sky, --mesh and --set applied, in this order.
std::optional<Scene> readScene(const RenderOptions& options, Error& error) {
    std::vector<std::string> overrides;
    const bool sky = !options.sky.empty(), mesh = !options.mesh.empty();
    if (sky) {
        if (!isRegularFile("--sky", options.sky, "a lat-long HDR or EXR file", error)) return std::nullopt;
        overrides.push_back("sky.file=" + fs::absolute(options.sky).string());
    }
    if (mesh) {
        if (!isRegularFile("--mesh", options.mesh, "a glTF file", error)) return std::nullopt;
        overrides.push_back("mesh=[{}]");
        overrides.push_back("mesh.0.file=" + fs::absolute(options.mesh).string());
    }
    overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
    std::optional<Scene> scene = loadScene(options.scene, overrides, error);
    if (scene && sky) scene->sky.where = "--sky";
    if (scene && mesh && !scene->meshes.empty()) scene->meshes.front().where = "--mesh";
    return scene;
}

std::optional<CameraDesc> chooseCamera(const Scene& scene, const std::string& name, Error& error) {
    if (name.empty()) return scene.cameras.front();
    std::vector<std::string_view> names;
    std::string list;
    for (const CameraDesc& camera : scene.cameras) {
        if (camera.name == name) return camera;
        names.push_back(camera.name);
        list += (list.empty() ? "" : ", ") + camera.name;
    }
    error.text = "--camera is '" + name + "', expected one of " + scene.file.filename().string() + ": " +
                 list + "; the nearest is " + std::string(nearest(name, names));
    return std::nullopt;
}

/// Linux says what could be had without swapping; elsewhere nothing is known, and nothing checked.
double availableBytes() {
    std::ifstream info("/proc/meminfo");
    for (std::string key, rest; info >> key && std::getline(info, rest);) {
        if (key == "MemAvailable:") return std::stod(rest) * 1024;
    }
    return std::numeric_limits<double>::infinity();
}

bool checkMemory(const RenderOptions& options, Error& error) {
    const Size& size = options.size;
    const double samples = options.supersample * options.supersample;
    const double needed = bytesAPixel * samples * size.width * size.height, available = availableBytes();
    if (needed <= available) return true;
    char text[160];
    std::snprintf(text, sizeof(text),
                  "--size is '%ux%u', which needs about %.1f GB, expected at most the %.1f GB free",
                  size.width, size.height, needed / 1e9, available / 1e9);
    error.text = text;
    return false;
}

bool checkOutputs(const RenderOptions& options, const Scene& scene, Error& error) {
    std::vector<fs::path> inputs = {scene.file, scene.sky.file};
    for (const MeshDesc& mesh : scene.meshes) inputs.push_back(mesh.file);
    for (const fs::path& file : options.outputs) {
        const fs::path first = options.numbered ? numbered(file, 0) : file;
        if (!checkOutput("-o", first, {".png", ".exr"}, error)) return false;
        if (!checkApart("-o", first, inputs, error)) return false;
    }
    if (options.stats.empty()) return true;
    return checkOutput("--stats", options.stats, {".json"}, error);
}

bool isPng(const fs::path& file) {
    const std::string extension = file.extension().string();
    return extension.size() == 4 && (extension[1] == 'p' || extension[1] == 'P');
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
        : options_(options), scene_(scene), host_(host) {
        frame_ = {options.size.width * options.supersample, options.size.height * options.supersample, camera,
                  options.timeS.value_or(scene.timeS), options.aov};
    }

    bool all(Progress& progress, Error& error) {
        double lastMs = 0;
        const double start = frame_.timeS;
        for (uint32_t i = 0; i < options_.frames; ++i) {
            progress.say("rendering frame", i, options_.frames);
            frame_.timeS = start + i / options_.fps;
            const auto began = std::chrono::steady_clock::now();
            const std::optional<Picture> picture = host_.render(frame_, error);
            if (!picture) return false;
            lastMs = millisecondsSince(began);
            const bool larger = options_.supersample > 1;
            if (!keep(larger ? averaged(*picture, options_.supersample) : *picture, i, progress, error))
                return false;
        }
        progress.say("measuring");
        const uint32_t affordable =
            static_cast<uint32_t>(std::clamp(1000 * timingSeconds / lastMs, 1.0, 1e3));
        const uint32_t runs = options_.stats.empty() ? std::min(affordable, timingRuns) : statsRuns;
        const std::optional<FrameTimes> times = host_.measure(frame_, runs, error);
        if (!times) return false;
        times_ = *times;
        if (options_.stats.empty()) return true;
        return writeText(options_.stats,
                         statsJson(host_.device(), options_.size, scene_, frame_.camera, times_), error);
    }

    void summarise() const {
        if (!options_.stats.empty()) std::fputs(statsTable(times_).c_str(), stdout);
        if (!scale_.empty()) std::printf("scale: %s\n", scale_.c_str());
        for (const auto& [first, last] : written_) {
            const std::string until = first == last ? "" : " .. " + last.filename().string();
            const std::string sampled =
                options_.supersample == 1 ? "" : " from " + sizeText(frame_.width, frame_.height);
            std::printf("%s: %s%s, %.1f ms a frame, %s%s\n", host_.device().name.c_str(),
                        sizeText(options_.size.width, options_.size.height).c_str(), sampled.c_str(),
                        times_.frameMs, first.string().c_str(), until.c_str());
        }
    }

  private:
    bool keep(const Picture& picture, uint32_t index, Progress& progress, Error& error) {
        if (const uint64_t broken = countBroken(picture, options_.aov)) {
            progress.clear();
            std::fprintf(stderr, "warning: frame %u holds %llu pixels of NaN or infinity\n", index,
                         static_cast<unsigned long long>(broken));
        }
        std::optional<Visualised> visualised;
        if (std::any_of(options_.outputs.begin(), options_.outputs.end(), isPng)) {
            visualised = visualise(picture, options_.aov, scene_.exposureEv);
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
    FrameTimes times_;
    std::string scale_;
    std::vector<std::pair<fs::path, fs::path>> written_; // first and last, of each output
};

/// Says where in the scene the file was named that the host could not read.
void addPlace(const Scene& scene, Error& error) {
    const auto prefix = [&error](const fs::path& file, const std::string& where) {
        const bool names = error.text.find(file.filename().string()) != std::string::npos;
        if (!names || where.empty() || error.text.starts_with(where)) return false;
        error.text = where + ": " + error.text;
        return true;
    };
    if (prefix(scene.sky.file, scene.sky.where)) return;
    for (const MeshDesc& mesh : scene.meshes) {
        if (prefix(mesh.file, mesh.where)) return;
    }
}

} // namespace

ExitCode renderScene(const RenderOptions& options, Error& error) {
    const std::optional<Scene> scene = readScene(options, error);
    if (!scene) return badInput;
    const std::optional<CameraDesc> camera = chooseCamera(*scene, options.camera, error);
    if (!camera || !checkOutputs(options, *scene, error) || !checkMemory(options, error)) return badInput;

    Progress progress;
    progress.say("opening the device");
    const std::unique_ptr<Host> host = Host::create({options.device, options.validation}, error);
    if (!host) {
        explainNoDevice(error);
        return badInput;
    }
    progress.say("loading " + scene->file.filename().string());
    if (!host->load(*scene, error)) {
        addPlace(*scene, error);
        return badInput;
    }
    Run run(options, *scene, *camera, *host);
    if (!run.all(progress, error)) return runFailed;
    progress.clear();
    run.summarise();
    if (const uint32_t messages = host->validationMessages()) {
        error.text =
            "validation: " + std::to_string(messages) + " messages, expected none (they are printed above)";
        return runFailed;
    }
    return ok;
}

} // namespace demos
