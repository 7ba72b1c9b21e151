#include "program/render/reference.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

#include "host/files/image_file.h"
#include "host/lens/meter.h"
#include "program/measure/left_out.h"
#include "program/render/output.h"
#include "program/render/progress.h"
#include "program/scene_input.h"
#include "reference/reference.h"
#include "scene/offset.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

struct TruthOutput {
    const char* option;
    const fs::path& file; ///< empty: not wished for
};

std::array<TruthOutput, 2> truthOutputs(const ReferenceOptions& options) {
    return {{{"--truth", options.truth}, {"--mirrored", options.mirrored}}};
}

bool checkOutputs(const ReferenceOptions& options, const Scene& scene, Error& error) {
    if (!checkPictures(options.picture, scene, error)) return false;
    const auto whole = [](const fs::path& file) { return fs::absolute(file).lexically_normal(); };
    std::vector<fs::path> taken;
    for (const fs::path& file : options.picture.outputs) taken.push_back(whole(file));
    for (const auto& [option, file] : truthOutputs(options)) {
        if (file.empty()) continue;
        if (std::find(taken.begin(), taken.end(), whole(file)) != taken.end()) {
            error.text = std::string(option) + " " + file.string() +
                         ": is another output as well, expected another file";
            return false;
        }
        taken.push_back(whole(file));
        if (!checkOutput(option, file, {".exr"}, error) ||
            !checkApart(option, file, sceneFiles(scene), error))
            return false;
    }
    return true;
}

bool write(const ReferenceOptions& options, const reference::Pictures& pictures, double exposureEv,
           Error& error) {
    for (const fs::path& file : options.picture.outputs) {
        const Picture& color = pictures.color;
        const bool written =
            isPng(file) ? writePng(file, color.width, color.height, toneMap(color, exposureEv), error)
                        : writeExr(file, color, error);
        if (!written) return false;
    }
    return (options.truth.empty() || writeExr(options.truth, pictures.truth, error)) &&
           (options.mirrored.empty() || writeExr(options.mirrored, pictures.mirrored, error));
}

} // namespace

ExitCode renderReference(const ReferenceOptions& options, Error& error) {
    const RenderOptions& picture = options.picture;
    std::optional<Scene> scene = readScene(picture, error);
    if (!scene) return badInput;
    std::optional<CameraDesc> camera = chooseCamera(*scene, picture.camera, error);
    if (!camera || !checkOutputs(options, *scene, error)) return badInput;
    applyOffset(*scene, *camera);

    Progress progress;
    progress.say("loading " + scene->file.filename().string());
    const auto began = std::chrono::steady_clock::now();
    reference::World world;
    reference::Frame frame;
    reference::FrameDesc desc;
    desc.width = picture.size.width;
    desc.height = picture.size.height;
    desc.camera = *camera;
    desc.timeS = picture.timeS.value_or(scene->timeS);
    desc.samples = options.samples;
    desc.seed = options.seed;
    if (!reference::loadWorld(*scene, world, error) || !reference::prepareFrame(world, desc, frame, error)) {
        addPlace(*scene, error);
        return badInput;
    }
    progress.clear();
    if (!sayLeftOut(world.leftOut, *scene, picture.strict, error)) return badInput;
    const bool withTruth = !options.truth.empty() || !options.mirrored.empty();
    const reference::Pictures pictures =
        reference::renderReference(frame, withTruth, [&](uint32_t done, uint32_t all) {
            progress.say("tracing row", done, all);
            return true;
        });
    const double exposureEv = picture.metered ? meteredEv(pictures.color) : scene->exposureEv;
    if (!write(options, pictures, exposureEv, error)) return runFailed;
    progress.clear();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    for (const fs::path& file : picture.outputs)
        std::printf("reference: %ux%u, %u samples a pixel, %.1f s, %s\n", desc.width, desc.height,
                    desc.samples, seconds, fs::absolute(file).string().c_str());
    return ok;
}

} // namespace demos
