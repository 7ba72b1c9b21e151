#include "measure/run.h"

#include "host/lens/halton.h"
#include "host/passes/supersample.h"
#include "measure/picture_error.h"
#include "reference/reference.h"

namespace demos::measure {

namespace {

constexpr uint32_t settlingFrames = 8;

bool reusesFrames(const SurfaceDesc& desc) {
    return std::visit(
        [](const auto& surface) { return surface.reflection && surface.reflection->temporal > 0; }, desc);
}

bool load(Host& host, const Subject& subject, reference::World& world, Error& error) {
    if (!host.load(subject.scene, error) || !reference::loadWorld(subject.scene, world, error)) return false;
    for (size_t i = 1; i < subject.variants.size(); ++i)
        if (!host.addSurface(subject.variants[i].surface, error)) return false;
    return true;
}

/// One camera of a subject that is loaded.
class View {
  public:
    View(Host& host, const Subject& subject, const CameraDesc& camera, const RunDesc& desc,
         const ProgressFunction& progress)
        : host_(host), subject_(subject), progress_(progress), rounds_(desc.rounds), samples_(desc.samples),
          supersample_(desc.supersample), frame_{desc.width,          desc.height, camera,
                                                 subject.scene.timeS, Aov::color,  0} {
        result_.scene = subject.file;
        result_.camera = camera.name;
    }

    RunResult measure(const reference::World& world, Error& error) {
        if (const RunResult traced = trace(world, error); traced != RunResult::ok) return traced;
        if (const RunResult timed = time(error); timed != RunResult::ok) return timed;
        for (uint32_t i = 0; i < subject_.variants.size(); ++i)
            if (!compare(i, error)) return RunResult::failed;
        return RunResult::ok;
    }
    ViewResult takeResult() { return std::move(result_); }

  private:
    reference::ProgressFunction telling(const std::string& what) {
        return [this, what](uint32_t done, uint32_t all) {
            goesOn_ = goesOn_ && progress_(what + " " + result_.scene + ", " + result_.camera, done, all);
            return goesOn_;
        };
    }

    RunResult trace(const reference::World& world, Error& error) {
        reference::FrameDesc desc;
        desc.width = frame_.width;
        desc.height = frame_.height;
        desc.camera = frame_.camera;
        desc.timeS = frame_.timeS;
        desc.samples = samples_;
        reference::Frame frame;
        if (!reference::prepareFrame(world, desc, frame, error)) return RunResult::failed;
        truth_ = renderReference(frame, true, telling("tracing"));
        result_.reference = toneMap(truth_.color, subject_.scene.exposureEv);
        return goesOn_ ? RunResult::ok : RunResult::stopped;
    }

    RunResult time(Error& error) {
        const std::optional<ComparedTimes> times =
            host_.measureSurfaces(frame_, rounds_, telling("measuring"), error);
        if (!goesOn_) return RunResult::stopped;
        if (!times) return RunResult::failed;
        for (size_t i = 0; i < subject_.variants.size(); ++i) {
            Entry& entry = result_.entries.emplace_back();
            const Technique& technique = *subject_.variants[i].technique;
            entry.scene = result_.scene;
            entry.camera = result_.camera;
            entry.technique = technique.name;
            entry.quality = technique.quality;
            entry.cost = costOf(times->surfaces[i], *times);
            entry.cost.bytes =
                host_.reflectionBytes(subject_.variants[i].surface, frame_.width, frame_.height, error);
            if (!entry.cost.bytes) return RunResult::failed;
        }
        return RunResult::ok;
    }

    static Cost costOf(const SurfaceTimes& times, const ComparedTimes& all) {
        Cost cost;
        cost.reflection = times.reflection;
        cost.floor = all.yardsticks.floor;
        if (all.yardsticks.floor.ms > 0) {
            cost.xFloor = times.ofFloor.ms;
            cost.xFloorSpread = times.ofFloor.spreadMs;
        }
        cost.surfaceMs = times.surfaceMs();
        if (all.yardsticks.fullScreen.ms > 0) cost.xTrivial = cost.surfaceMs / all.yardsticks.fullScreen.ms;
        cost.gpuFrameMs = times.gpuFrameMs;
        cost.hostBytes = times.hostBytes;
        cost.passes = times.passes;
        return cost;
    }

    /// What a frame before it left is reused: as many as it takes, each of another part of the pixels.
    bool settle(uint32_t surface, Error& error) {
        if (!reusesFrames(subject_.variants[surface].surface)) return true;
        FrameDesc frame = frame_;
        frame.surface = surface;
        for (uint32_t i = 0; i < settlingFrames; ++i) {
            frame.follows = i > 0;
            frame.jitterPx = haltonPx(i);
            if (!host_.render(frame, error)) return false;
        }
        return true;
    }

    /// Reuses no frame: those before are smaller.
    bool supersample(FrameDesc frame, Error& error) {
        if (supersample_ == 1) return true;
        frame.width *= supersample_;
        frame.height *= supersample_;
        frame.follows = false;
        const std::optional<Picture> large = host_.render(frame, error);
        if (large) shots_.color = averaged(*large, supersample_);
        return large.has_value();
    }

    bool compare(uint32_t surface, Error& error) {
        FrameDesc frame = frame_;
        frame.surface = surface;
        frame.follows = true;
        if (!settle(surface, error) || !takeShots(host_, frame, shots_, error) || !supersample(frame, error))
            return false;
        const double exposureEv = subject_.scene.exposureEv;
        const std::optional<PictureError> found = errorOf(truth_, shots_, exposureEv, error);
        if (!found) {
            error.text = result_.scene + ", camera " + result_.camera + ", " +
                         result_.entries[surface].name() + ": " + error.text;
            return false;
        }
        result_.pictures.push_back(toneMap(shots_.color, exposureEv));
        result_.entries[surface].error = *found;
        return true;
    }

    Host& host_;
    const Subject& subject_;
    const ProgressFunction& progress_;
    uint32_t rounds_, samples_, supersample_;
    FrameDesc frame_;
    reference::Pictures truth_;
    Shots shots_; ///< of the water that was compared last
    ViewResult result_;
    bool goesOn_ = true;
};

} // namespace

RunResult measureSubject(Host& host, const Subject& subject, const RunDesc& desc,
                         const ProgressFunction& progress, const FinishedFunction& finished, Error& error) {
    reference::World world;
    if (!load(host, subject, world, error)) return RunResult::failed;
    for (const CameraDesc& camera : subject.cameras) {
        View view(host, subject, camera, desc, progress);
        if (const RunResult result = view.measure(world, error); result != RunResult::ok) return result;
        if (!finished(view.takeResult(), error)) return RunResult::failed;
    }
    return RunResult::ok;
}

} // namespace demos::measure
