#include "program/view.h"

#include "host/files/image_file.h"
#include "program/device/device_limit.h"
#include "program/device/lost_device.h"
#include "program/device/memory.h"
#include "program/device/no_device.h"
#include "program/device/validation.h"
#include "program/measure/left_out.h"
#include "program/render/output.h"
#include "program/scene_input.h"
#include "scene/fields.h"
#include "scene/offset.h"
#include "view/viewer.h"

namespace demos {

namespace {

/// The scene's own mirror, but by another technique.
std::optional<Split> splitOf(const Scene& scene, const std::string& technique, Error& error) {
    if (!scene.water && !scene.floor) {
        error.text = "--split is '" + technique + "', expected a scene with water or a floor to mirror it";
        return std::nullopt;
    }
    const std::optional<seaglass::ReflectionDesc>& own =
        scene.water ? scene.water->reflection : scene.floor->reflection;
    Split split{own.value_or(seaglass::ReflectionDesc{})};
    split.reflection.technique = techniqueNamed(technique);
    return split;
}

/// The first state that is shown; null with `error` set.
std::optional<ViewState> startOf(const ViewOptions& options, Error& error) {
    std::optional<Scene> scene = readScene(options.picture, error);
    if (!scene) return std::nullopt;
    std::optional<CameraDesc> camera = chooseCamera(*scene, options.picture.camera, error);
    if (!camera || !fitsMemory(options.picture.size, frameBytesAPixel, error)) return std::nullopt;
    if (!options.screenshot.empty() &&
        !checkApart("--screenshot", options.screenshot, sceneFiles(*scene), error))
        return std::nullopt;
    moveCameras(*scene, camera->offsetM);
    applyOffset(*scene, *camera);
    ViewState state;
    if (options.splitReference) state.split = Split{{}, 0.5, true};
    if (!options.split.empty()) {
        state.split = splitOf(*scene, options.split, error);
        if (!state.split) return std::nullopt;
    }
    state.timeS = options.picture.timeS.value_or(scene->timeS);
    state.scene = std::move(*scene);
    state.camera = std::move(*camera);
    state.paused = options.paused;
    state.aov = options.picture.aov;
    state.panel = options.panel;
    state.lens = options.picture.lens;
    return state;
}

std::unique_ptr<Host> openHost(const ViewOptions& options, const Scene& scene, Error& error) {
    HostDesc desc{options.picture.device, options.picture.validation};
    desc.windowExtensions = Window::vulkanExtensions(error);
    if (desc.windowExtensions.empty()) return nullptr;
    std::unique_ptr<Host> host = Host::create(desc, error);
    if (!host) {
        explainNoDevice(error);
        return nullptr;
    }
    if (!fitsDevice(options.picture.size, 1, host->device(), error)) return nullptr;
    if (!host->load(scene, error)) {
        endIfLost(*host, error);
        addPlace(scene, error);
        return nullptr;
    }
    if (!sayLeftOut(host->leftOut(), scene, options.picture.strict, error)) return nullptr;
    return host;
}

bool keep(Viewer& viewer, const std::filesystem::path& file, Error& error) {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgb;
    return viewer.read(width, height, rgb, error) && writePng(file, width, height, rgb, error);
}

bool show(const ViewOptions& options, Window& window, Viewer& viewer, Error& error) {
    while ((options.endless || viewer.shown() < options.frames) && !window.shouldClose())
        if (!viewer.step(error)) return false;
    if (options.screenshot.empty()) return true;
    if (viewer.shown() == options.frames) return keep(viewer, options.screenshot, error);
    error.text = "the window was closed after " + std::to_string(viewer.shown()) + " frames, expected " +
                 std::to_string(options.frames) + " for --screenshot";
    return false;
}

} // namespace

ExitCode viewScene(const ViewOptions& options, Error& error) {
    const std::optional<ViewState> state = startOf(options, error);
    if (!state) return badInput;
    const std::unique_ptr<Window> window =
        Window::open("seaglass: " + state->scene.file.filename().string(), options.picture.size.width,
                     options.picture.size.height, error);
    if (!window) return badInput;
    const std::unique_ptr<Host> host = openHost(options, state->scene, error);
    if (!host) return badInput;
    {
        const std::unique_ptr<Viewer> viewer =
            Viewer::create(*window, *host, *state, {options.stepS, options.referenceSamples}, error);
        if (!viewer) return badInput;
        if (!show(options, *window, *viewer, error)) {
            endIfLost(*host, error);
            return runFailed;
        }
    }
    return judgeValidation(*host, error);
}

} // namespace demos
