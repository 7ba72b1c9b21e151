#include "program/reference.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "host/image_file.h"
#include "program/output.h"
#include "program/progress.h"
#include "program/scene_input.h"
#include "reference/reference.h"
#include "scene/offset.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

bool checkOutputs(const ReferenceOptions& options, const Scene& scene, Error& error) {
    if (!checkPictures(options.picture, scene, error)) return false;
    if (options.truth.empty()) return true;
    const auto same = [&](const fs::path& file) {
        return fs::absolute(file).lexically_normal() == fs::absolute(options.truth).lexically_normal();
    };
    const std::vector<fs::path>& outputs = options.picture.outputs;
    if (std::any_of(outputs.begin(), outputs.end(), same)) {
        error.text = "--truth " + options.truth.string() + ": is an -o as well, expected another file";
        return false;
    }
    return checkOutput("--truth", options.truth, {".exr"}, error) &&
           checkApart("--truth", options.truth, sceneFiles(scene), error);
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
    return options.truth.empty() || writeExr(options.truth, pictures.truth, error);
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
    const reference::Pictures pictures =
        reference::renderReference(frame, !options.truth.empty(), [&](uint32_t done, uint32_t all) {
            progress.say("tracing row", done, all);
            return true;
        });
    if (!write(options, pictures, scene->exposureEv, error)) return runFailed;
    progress.clear();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    for (const fs::path& file : picture.outputs)
        std::printf("reference: %ux%u, %u samples a pixel, %.1f s, %s\n", desc.width, desc.height,
                    desc.samples, seconds, fs::absolute(file).string().c_str());
    return ok;
}

} // namespace demos
