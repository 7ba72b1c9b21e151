#include "measure/run.h"

#include <algorithm>

#include "measure/picture_error.h"
#include "reference/reference.h"

namespace demos::measure {

namespace {

/// One camera's truth, and what was found by it so far.
struct View {
    CameraDesc camera;
    reference::Pictures truth;
    Sheet sheet;
    std::vector<Entry> entries;
};

bool trace(const Scene& scene, const RunDesc& desc, const ProgressFunction& progress,
           std::vector<View>& views, RunResult& result, Error& error) {
    reference::World world;
    result = RunResult::unreadable;
    if (!reference::loadWorld(scene, world, error)) return false;
    result = RunResult::failed;
    for (View& view : views) {
        reference::FrameDesc frameDesc;
        frameDesc.width = desc.width;
        frameDesc.height = desc.height;
        frameDesc.camera = view.camera;
        frameDesc.timeS = scene.timeS;
        reference::Frame frame;
        if (!reference::prepareFrame(world, frameDesc, frame, error)) return false;
        const std::string what = "tracing " + view.sheet.scene + ", " + view.camera.name + ", row";
        view.truth =
            renderReference(frame, true, [&](uint32_t done, uint32_t all) { progress(what, done, all); });
        view.sheet.pictures.push_back({"reference", toneMap(view.truth.color, scene.exposureEv)});
    }
    return true;
}

bool measureView(Host& host, const Variant& variant, const RunDesc& desc, View& view, Error& error) {
    FrameDesc frame = {desc.width, desc.height, view.camera, variant.scene.timeS, Aov::color};
    const std::optional<Picture> color = host.render(frame, error);
    if (!color) return false;
    frame.aov = Aov::reflectionClass;
    const std::optional<Picture> classes = host.render(frame, error);
    if (!classes) return false;
    frame.aov = Aov::color;
    const std::optional<FrameTimes> times = host.measure(frame, desc.runs, error, true);
    if (!times) return false;

    Entry entry;
    entry.scene = view.sheet.scene;
    entry.camera = view.camera.name;
    entry.technique = variant.technique->name;
    entry.quality = variant.technique->quality;
    entry.cost.reflection = times->reflection;
    entry.cost.floor = *times->floor;
    if (times->floor->ms > 0) entry.cost.xFloor = times->reflection.ms / times->floor->ms;
    entry.cost.passes = times->passes;
    std::vector<uint8_t> shown = toneMap(*color, variant.scene.exposureEv);
    const Shots shots = {view.sheet.pictures.front().rgb, shown, &view.truth.truth, &*classes};
    entry.error = errorOf(shots, variant.technique->answers);
    view.entries.push_back(std::move(entry));
    view.sheet.pictures.push_back(
        {variant.technique->name + ", " + variant.technique->quality, std::move(shown)});
    return true;
}

} // namespace

std::optional<double> Tradeoff::floorMs() const {
    if (entries.empty()) return std::nullopt;
    std::vector<double> ms;
    for (const Entry& entry : entries) ms.push_back(entry.cost.floor.ms);
    std::sort(ms.begin(), ms.end());
    return (ms[(ms.size() - 1) / 2] + ms[ms.size() / 2]) / 2;
}

RunResult measureScene(Host& host, std::span<const Variant> variants, const RunDesc& desc,
                       const ProgressFunction& progress, Tradeoff& out, Error& error) {
    const Scene& plain = variants.front().scene;
    std::vector<View> views;
    for (const CameraDesc& camera : plain.cameras) {
        if (desc.firstCameraOnly && !views.empty()) break;
        View& view = views.emplace_back();
        view.camera = camera;
        view.sheet.scene = variants.front().file;
        view.sheet.camera = camera.name;
    }
    RunResult result = RunResult::ok;
    if (!trace(plain, desc, progress, views, result, error)) return result;

    const auto all = static_cast<uint32_t>(views.size() * variants.size());
    uint32_t done = 0;
    for (const Variant& variant : variants) {
        if (!host.load(variant.scene, error)) return RunResult::unreadable;
        for (View& view : views) {
            progress("measuring " + view.sheet.scene + ", " + view.camera.name + ", " +
                         variant.technique->name,
                     done++, all);
            if (!measureView(host, variant, desc, view, error)) return RunResult::failed;
        }
    }
    for (View& view : views) {
        view.sheet.firstEntry = out.entries.size();
        std::move(view.entries.begin(), view.entries.end(), std::back_inserter(out.entries));
        out.sheets.push_back(std::move(view.sheet));
    }
    return RunResult::ok;
}

} // namespace demos::measure
