// Times of one view with each of its surfaces in turn, round after round, so that all see the same machine.
#include "host/floor_pass.h"
#include "host/full_screen_pass.h"
#include "host/host_impl.h"
#include "host/stage_times.h"

namespace demos {

namespace {

constexpr StageName sceneStages[] = {stages[1], stages[2]};
constexpr StageName copyStage = stages[4];
constexpr StageName surfaceStages[] = {stages[0], stages[3], stages[5], stages[6],
                                       stages[7], stages[8], stages[9]};
static_assert(sceneStages[0].stage == Stage::shadow && copyStage.stage == Stage::copy);
static_assert(surfaceStages[1].stage == Stage::caustics && surfaceStages[6].stage == Stage::mirror);

/// What one surface took, round by round.
struct SurfaceSamples {
    StageTimes times;
    std::vector<double> reflectionMs, ofFloor, simulateMs;
    uint64_t hostBytes = 0;
};

struct Samples {
    StageTimes scene;
    std::vector<double> floorMs, fullScreenMs;
    std::vector<SurfaceSamples> surfaces;
};

bool timeFloor(Device& device, PassTimer& timer, const FloorPass& floor, double& ms, Error& error) {
    const bool ran = device.run(
        [&](VkCommandBuffer commands, Error&) {
            timer.listen(commands);
            // Once unseen: what is timed is the copy, not the waking of the device. Without timestamps both
            // would be.
            if (device.timestampNs() > 0) floor.record(commands);
            timer.mark(commands, "floor", true);
            floor.record(commands);
            timer.mark(commands, "floor", false);
            timer.stop();
            return true;
        },
        error);
    if (!ran) return false;
    const std::vector<PassTime> timed = timer.collect();
    ms = timed.empty() ? device.lastRunMs() : timed.front().ms;
    return true;
}

SurfaceTimes timesOf(const SurfaceSamples& samples, const std::vector<PassTime>& scenePasses) {
    SurfaceTimes times;
    times.reflection = summary("reflection", samples.reflectionMs);
    times.ofFloor = summary("of_floor", samples.ofFloor);
    times.cpuSimulateMs = quantile(samples.simulateMs, 0.5);
    times.hostBytes = samples.hostBytes;
    times.passes = scenePasses;
    for (PassTime& pass : samples.times.passes.medians()) times.passes.push_back(std::move(pass));
    return times;
}

/// One round: the opaque scene and the floor, then each surface over the same scene.
class RoundTimer {
  public:
    RoundTimer(Device& device, FrameRecorder& recorder, const LoadedScene& scene, const FrameDesc& frame,
               const FloorPass& floor, const FullScreenPass& fullScreen)
        : device_(device), recorder_(recorder), scene_(scene), frame_(frame), floor_(floor),
          fullScreen_(fullScreen) {
        frame_.follows = true;
    }

    bool round(uint32_t number, Samples& samples, Error& error) {
        double floorMs = 0;
        const auto copy = [&](VkCommandBuffer commands, Error&) {
            recorder_.targets().copyScene(commands);
            return true;
        };
        if (!recorder_.begin(scene_, frame_, error) ||
            !timeStages(device_, recorder_, sceneStages, samples.scene, error) || !device_.run(copy, error))
            return false;
        copyMs_ = device_.lastRunMs();
        if (!timeFloor(device_, recorder_.timer(), floor_, floorMs, error)) return false;
        samples.floorMs.push_back(floorMs);
        if (!timeFullScreen(samples, error)) return false;
        // Another one begins each time: none is always behind the same one.
        const auto count = static_cast<uint32_t>(samples.surfaces.size());
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t surface = (number + i) % count;
            if (!timeSurface(surface, floorMs, samples.surfaces[surface], error)) return false;
        }
        return true;
    }

  private:
    bool timeFullScreen(Samples& samples, Error& error) {
        const bool ran = device_.run(
            [&](VkCommandBuffer commands, Error&) {
                fullScreen_.record(device_, commands, recorder_.targets());
                return true;
            },
            error);
        samples.fullScreenMs.push_back(device_.lastRunMs());
        return ran;
    }

    bool timeSurface(uint32_t surface, double floorMs, SurfaceSamples& samples, Error& error) {
        frame_.surface = surface;
        const auto restore = [&](VkCommandBuffer commands, Error&) {
            recorder_.targets().restoreScene(commands);
            return true;
        };
        if (!recorder_.begin(scene_, frame_, error) || !device_.run(restore, error)) return false;
        // All are restored from it, but in a frame of their own some would do without.
        if (recorder_.needed(copyStage.stage)) samples.times.passes.add(copyStage.name, copyMs_);
        if (!timeStages(device_, recorder_, surfaceStages, samples.times, error)) return false;
        samples.hostBytes = recorder_.hostBytes();
        samples.reflectionMs.push_back(samples.times.reflectionMs);
        if (floorMs > 0) samples.ofFloor.push_back(samples.times.reflectionMs / floorMs);
        samples.simulateMs.push_back(recorder_.cpuSimulateMs());
        return true;
    }

    Device& device_;
    FrameRecorder& recorder_;
    const LoadedScene& scene_;
    FrameDesc frame_;
    const FloorPass& floor_;
    const FullScreenPass& fullScreen_;
    double copyMs_ = 0;
};

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
    FloorPass floor;
    if (!floor.create(*impl.device, {frame.width, frame.height}, error)) return std::nullopt;
    FullScreenPass fullScreen;
    if (!fullScreen.create(*impl.device, error)) return std::nullopt;
    RoundTimer timer(*impl.device, *impl.recorder, *impl.scene, frame, floor, fullScreen);
    Samples samples, ignored;
    samples.surfaces.resize(impl.scene->surfaces.size());
    ignored.surfaces.resize(impl.scene->surfaces.size());
    for (uint32_t i = 0; i < Impl::warmUps + rounds; ++i) {
        if (goOn && !goOn(i, Impl::warmUps + rounds)) return ComparedTimes{};
        if (!timer.round(i, i < Impl::warmUps ? ignored : samples, error)) return std::nullopt;
    }
    ComparedTimes found;
    found.floor = summary("floor", samples.floorMs);
    found.fullScreen = summary("full_screen", samples.fullScreenMs);
    const std::vector<PassTime> scenePasses = samples.scene.passes.medians();
    for (const SurfaceSamples& surface : samples.surfaces)
        found.surfaces.push_back(timesOf(surface, scenePasses));
    return found;
}

} // namespace demos
