// Times of one view with each of its surfaces in turn, round after round, so that all see the same machine.
#include "host/host_impl.h"
#include "host/timing/stage_times.h"

namespace demos {

namespace {

constexpr StageName sceneStages[] = {stages[1], stages[2]};
constexpr StageName copyStage = stages[4];
constexpr StageName surfaceStages[] = {stages[0], stages[3], stages[5], stages[6],
                                       stages[7], stages[8], stages[9], stages[10]};
static_assert(sceneStages[0].stage == Stage::shadow && copyStage.stage == Stage::copy);
static_assert(surfaceStages[1].stage == Stage::caustics && surfaceStages[7].stage == Stage::mirror);

/// What one surface took, round by round.
struct SurfaceSamples {
    StageTimes times;
    std::vector<double> reflectionMs, ofFloor, simulateMs, gpuFrameMs;
    uint64_t hostBytes = 0;
};

struct Samples {
    StageTimes scene;
    std::vector<double> floorMs, fullScreenMs;
    std::vector<SurfaceSamples> surfaces;

    void add(const YardstickMs& beside) {
        floorMs.push_back(beside.floor);
        fullScreenMs.push_back(beside.fullScreen);
    }
};

/// One round of all surfaces.
class RoundTimer {
  public:
    RoundTimer(Device& device, FrameRecorder& recorder, LoadedScene& scene, const FrameDesc& frame,
               Yardsticks& yardsticks)
        : device_(device), recorder_(recorder), scene_(scene), frame_(frame), yardsticks_(yardsticks) {
        frame_.follows = true;
    }

    bool round(uint32_t number, Samples& samples, Error& error) {
        const bool whole = device_.clock() == PassClock::timestamps;
        if (!whole && !timeScene(samples, error)) return false;
        // Another one begins each time: none is always behind the same one.
        const auto count = static_cast<uint32_t>(samples.surfaces.size());
        for (uint32_t i = 0; i < count; ++i) {
            frame_.surface = (number + i) % count;
            SurfaceSamples& surface = samples.surfaces[frame_.surface];
            const bool timed = whole ? timeWhole(samples, surface, error) : timeOver(surface, error);
            if (!timed) return false;
            surface.hostBytes = recorder_.hostBytes();
            surface.reflectionMs.push_back(surface.times.reflectionMs);
            if (beside_.floor > 0) surface.ofFloor.push_back(surface.times.reflectionMs / beside_.floor);
            surface.simulateMs.push_back(recorder_.cpuSimulateMs());
        }
        return true;
    }

  private:
    /// The opaque scene, which all are drawn over, and the yardsticks.
    bool timeScene(Samples& samples, Error& error) {
        const auto copy = [&](VkCommandBuffer commands, Error&) {
            recorder_.targets().copyScene(commands);
            return true;
        };
        if (!recorder_.begin(scene_, frame_, error) ||
            !timeStages(device_, recorder_, sceneStages, samples.scene, error) || !device_.run(copy, error))
            return false;
        copyMs_ = device_.lastRunMs();
        if (!yardsticks_.time(recorder_.targets(), beside_, error)) return false;
        samples.add(beside_);
        return true;
    }

    /// One surface over the scene as it is restored from its copy.
    bool timeOver(SurfaceSamples& samples, Error& error) {
        const auto restore = [&](VkCommandBuffer commands, Error&) {
            recorder_.targets().restoreScene(commands);
            return true;
        };
        if (!recorder_.begin(scene_, frame_, error) || !device_.run(restore, error)) return false;
        // All are restored from it, but in a frame of their own some would do without.
        if (recorder_.needed(copyStage.stage)) samples.times.passes.add(copyStage.name, copyMs_);
        return timeStages(device_, recorder_, surfaceStages, samples.times, error);
    }

    /// A whole frame with one surface, the yardsticks in the same submission.
    bool timeWhole(Samples& samples, SurfaceSamples& surface, Error& error) {
        if (!recorder_.begin(scene_, frame_, error) ||
            !timeFrame(device_, recorder_, yardsticks_, surface.times, beside_, error))
            return false;
        surface.gpuFrameMs.push_back(surface.times.gpuFrameMs);
        samples.add(beside_);
        return true;
    }

    Device& device_;
    FrameRecorder& recorder_;
    LoadedScene& scene_;
    FrameDesc frame_;
    Yardsticks& yardsticks_;
    YardstickMs beside_;
    double copyMs_ = 0;
};

SurfaceTimes timesOf(const SurfaceSamples& samples, const std::vector<PassTime>& scenePasses) {
    SurfaceTimes times;
    times.reflection = summary("reflection", samples.reflectionMs);
    times.ofFloor = summary("of_floor", samples.ofFloor);
    times.cpuSimulateMs = quantile(samples.simulateMs, 0.5);
    if (!samples.gpuFrameMs.empty()) times.gpuFrameMs = quantile(samples.gpuFrameMs, 0.5);
    times.hostBytes = samples.hostBytes;
    times.passes = scenePasses;
    for (PassTime& pass : samples.times.passes.medians()) times.passes.push_back(std::move(pass));
    return times;
}

} // namespace

std::vector<PassTime> SurfaceTimes::surfacePasses() const {
    std::vector<PassTime> chosen;
    for (const PassTime& pass : passes)
        for (const StageName& stage : surfaceStages)
            if (pass.name == stage.name) chosen.push_back(pass);
    return chosen;
}

double SurfaceTimes::surfaceMs() const {
    double sum = cpuSimulateMs;
    for (const PassTime& pass : surfacePasses()) sum += pass.ms;
    return sum;
}

std::optional<ComparedTimes> Host::measureSurfaces(const FrameDesc& frame, uint32_t rounds,
                                                   const RoundFunction& goOn, Error& error) {
    Impl& impl = *impl_;
    if (!impl.ready(error)) return std::nullopt;
    if (rounds == 0 || impl.scene->surfaces.empty()) {
        error.text = "measuring needs at least one round and one surface";
        return std::nullopt;
    }
    Yardsticks yardsticks;
    if (!yardsticks.create(*impl.device, {frame.width, frame.height}, error)) return std::nullopt;
    RoundTimer timer(*impl.device, *impl.recorder, *impl.scene, frame, yardsticks);
    Samples samples, ignored;
    samples.surfaces.resize(impl.scene->surfaces.size());
    ignored.surfaces.resize(impl.scene->surfaces.size());
    for (uint32_t i = 0; i < Impl::warmUps + rounds; ++i) {
        if (goOn && !goOn(i, Impl::warmUps + rounds)) return ComparedTimes{};
        if (!timer.round(i, i < Impl::warmUps ? ignored : samples, error)) return std::nullopt;
    }
    ComparedTimes found;
    found.yardsticks = {summary("floor", samples.floorMs), summary("full_screen", samples.fullScreenMs)};
    const std::vector<PassTime> scenePasses = samples.scene.passes.medians();
    for (const SurfaceSamples& surface : samples.surfaces)
        found.surfaces.push_back(timesOf(surface, scenePasses));
    return found;
}

} // namespace demos
