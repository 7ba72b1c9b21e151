// Times of one view with each of its waters in turn, round after round, so that all see the same machine.
#include "host/floor_pass.h"
#include "host/host_impl.h"
#include "host/stage_times.h"

namespace demos {

namespace {

constexpr StageName sceneStages[] = {stages[1], stages[2], stages[3]};
constexpr StageName waterStages[] = {stages[0], stages[4], stages[5], stages[6]};
static_assert(sceneStages[0].stage == Stage::shadow && sceneStages[2].stage == Stage::copy);
static_assert(waterStages[1].stage == Stage::mirrored && waterStages[3].stage == Stage::water);

/// What one water took, round by round.
struct WaterSamples {
    StageTimes times;
    std::vector<double> reflectionMs, ofFloor, simulateMs;
};

struct Samples {
    StageTimes scene;
    std::vector<double> floorMs;
    std::vector<WaterSamples> waters;
};

bool timeFloor(Device& device, PassTimer& timer, const FloorPass& floor, double& ms, Error& error) {
    const bool ran = device.run(
        [&](VkCommandBuffer commands, Error&) {
            timer.listen(commands);
            // Once unseen: what is timed is the copy, not the waking of the device.
            floor.record(commands);
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

WaterTimes timesOf(const WaterSamples& samples, const std::vector<PassTime>& scenePasses) {
    WaterTimes times;
    times.reflection = summary("reflection", samples.reflectionMs);
    times.ofFloor = summary("of_floor", samples.ofFloor);
    times.cpuSimulateMs = quantile(samples.simulateMs, 0.5);
    times.passes = scenePasses;
    for (PassTime& pass : samples.times.passes.medians()) times.passes.push_back(std::move(pass));
    return times;
}

/// One round: the opaque scene and the floor, then each water over the same scene.
class RoundTimer {
  public:
    RoundTimer(Device& device, FrameRecorder& recorder, const LoadedScene& scene, const FrameDesc& frame,
               const FloorPass& floor)
        : device_(device), recorder_(recorder), scene_(scene), frame_(frame), floor_(floor) {}

    bool round(uint32_t number, Samples& samples, Error& error) {
        double floorMs = 0;
        if (!recorder_.begin(scene_, frame_, error) ||
            !timeStages(device_, recorder_, sceneStages, samples.scene, error) ||
            !timeFloor(device_, recorder_.timer(), floor_, floorMs, error))
            return false;
        samples.floorMs.push_back(floorMs);
        // Another one begins each time: none is always behind the same one.
        const auto count = static_cast<uint32_t>(samples.waters.size());
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t water = (number + i) % count;
            if (!timeWater(water, floorMs, samples.waters[water], error)) return false;
        }
        return true;
    }

  private:
    bool timeWater(uint32_t water, double floorMs, WaterSamples& samples, Error& error) {
        frame_.water = water;
        const auto restore = [&](VkCommandBuffer commands, Error&) {
            recorder_.targets().restoreScene(commands);
            return true;
        };
        if (!recorder_.begin(scene_, frame_, error) || !device_.run(restore, error) ||
            !timeStages(device_, recorder_, waterStages, samples.times, error))
            return false;
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
};

} // namespace

std::optional<ComparedTimes> Host::measureWaters(const FrameDesc& frame, uint32_t rounds,
                                                 const RoundFunction& goOn, Error& error) {
    Impl& impl = *impl_;
    if (!impl.ready(error)) return std::nullopt;
    if (rounds == 0 || impl.scene->waters.empty()) {
        error.text = "measuring needs at least one round and one water";
        return std::nullopt;
    }
    FloorPass floor;
    if (!floor.create(*impl.device, {frame.width, frame.height}, error)) return std::nullopt;
    RoundTimer timer(*impl.device, impl.recorder, *impl.scene, frame, floor);
    Samples samples, ignored;
    samples.waters.resize(impl.scene->waters.size());
    ignored.waters.resize(impl.scene->waters.size());
    for (uint32_t i = 0; i < Impl::warmUps + rounds; ++i) {
        if (goOn && !goOn(i, Impl::warmUps + rounds)) return ComparedTimes{};
        if (!timer.round(i, i < Impl::warmUps ? ignored : samples, error)) return std::nullopt;
    }
    ComparedTimes found;
    found.floor = summary("floor", samples.floorMs);
    const std::vector<PassTime> scenePasses = samples.scene.passes.medians();
    for (const WaterSamples& water : samples.waters) found.waters.push_back(timesOf(water, scenePasses));
    return found;
}

} // namespace demos
