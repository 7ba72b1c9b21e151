// What a reflection costs on this device, as multiples of the floor: a compute copy of the frame's colour and
// depth; and how much of the traced truth it finds. Floor and reflection alternate, so that both see the same
// machine, and stand in one submission where the device is no CPU; medians over the rounds. The first
// multiple is of time. On CPU devices there is a second, of what this process had of the processors, which is
// the steadier one while other programs run.
//
//   seaglass_bench_reflection [WIDTHxHEIGHT [ROUNDS [POSE [SETTING]]]]   settings whose names begin so
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string_view>

#include "host/timing/timed_floor.h"
#include "seaglass/reflection.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_score.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;

struct Setting {
    const char* name;
    ReflectionDesc desc;
};

/// A fifth of the screen is mirror, nearly half, and the poses of the tests.
std::vector<tests::Pose> posesOf(uint32_t width, uint32_t height) {
    tests::Camera fifth = tests::testCamera();
    fifth.target = {-0.5, 4.4, 0};
    tests::Camera half = tests::testCamera();
    half.target = {-0.5, 2.3, 0};
    std::vector<tests::Pose> poses = tests::poses();
    poses.insert(poses.begin(), {{"fifth", fifth}, {"half", half}});
    for (tests::Pose& pose : poses) {
        pose.camera.width = width;
        pose.camera.height = height;
    }
    return poses;
}

std::vector<Setting> settings() {
    ReflectionDesc flat;
    flat.distortion = 0;
    flat.blurLevels = 0;
    ReflectionDesc coarse = flat;
    coarse.coarseKeys = true;
    ReflectionDesc overhangs = flat;
    overhangs.overhangSamples = 6;
    ReflectionDesc half = flat;
    half.downscale = 2;
    const ReflectionDesc bent;
    ReflectionDesc reaching = flat;
    reaching.edgeReach = 0.2f;
    ReflectionDesc temporal = flat;
    temporal.temporal = 0.9f;
    ReflectionDesc ssr = flat;
    ssr.technique = ReflectionTechnique::ssr;
    ReflectionDesc strides = ssr;
    strides.marchCells = false;
    ReflectionDesc hybrid = flat;
    hybrid.technique = ReflectionTechnique::hybrid;
    return {{"sspr", flat},
            {"sspr, coarse keys", coarse},
            {"sspr, overhangs", overhangs},
            {"sspr, half", half},
            {"sspr, bent, blurred", bent},
            {"sspr, edge reach", reaching},
            {"sspr, temporal", temporal},
            {"ssr", ssr},
            {"ssr, strides", strides},
            {"hybrid", hybrid}};
}

struct Samples {
    std::vector<double> ms;
    std::vector<double> processorMs;
};

double processorMs() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
}

template<typename Record>
void run(Record&& record) {
    demos::Error error;
    const bool done = tests::device().run(
        [&](VkCommandBuffer commands, demos::Error&) {
            record(commands);
            return true;
        },
        error);
    if (done) return;
    std::fprintf(stderr, "%s\n", error.text.c_str());
    std::exit(1);
}

class Bench {
  public:
    Bench(uint32_t width, uint32_t height, uint32_t rounds, std::vector<Setting> settings)
        : rounds_(rounds), settings_(std::move(settings)) {
        demos::Error error;
        const DeviceDesc desc = tests::deviceDesc(&message_);
        require(floor_.create(tests::device(), {width, height}, error), error.text);
        require(createContext(&desc, &context_) == Status::ok, message_);
    }
    ~Bench() { destroyContext(context_); }

    void measure(const tests::Pose& pose) {
        const tests::TracedView traced = tests::Tracer(pose.camera, tests::harbourOfBoxes()).run();
        const demos::Image depth = tests::uploadFloats(traced.width, traced.height, 1, traced.depth);
        const demos::Image color = tests::uploadFloats(traced.width, traced.height, 4, traced.color);
        ViewDesc view = tests::viewDesc(pose.camera);
        view.sceneDepth = tests::asSeaglass(depth);
        view.sceneColor = tests::asSeaglass(color);
        const auto mirrored = std::count_if(traced.truth.begin(), traced.truth.end(),
                                            [](tests::Truth t) { return t != tests::Truth::none; });
        std::printf("%s: %.1f %% of the screen is mirror\n", pose.name,
                    100.0 * static_cast<double>(mirrored) / static_cast<double>(traced.truth.size()));

        const std::vector<Setting>& all = settings_;
        std::vector<Reflector*> reflectors;
        for (const Setting& setting : all) {
            const ReflectorDesc desc{{0, 1, 0, 0}, setting.desc};
            require(createReflector(context_, &desc, &reflectors.emplace_back()) == Status::ok, message_);
        }
        std::vector<std::map<std::string, std::vector<double>>> passes(all.size());
        std::vector<Samples> sums(all.size());
        Samples floors;
        constexpr uint32_t warmUps = 2;
        for (uint32_t round = 0; round < warmUps + rounds_; ++round) {
            const bool counts = round >= warmUps;
            if (!whole_) floorOnce(counts ? &floors : nullptr);
            // As antialiasing moves a projection; only temporal reuse looks at it.
            view.jitter[0] = round % 2 ? 0.25 : -0.25;
            view.jitter[1] = -view.jitter[0];
            for (size_t i = 0; i < all.size(); ++i) {
                const double before = processorMs();
                const std::vector<demos::TimedPass> timed = reflectOnce(reflectors[i], view);
                const double beside = floor_.recordedMs(timed);
                if (!counts) continue;
                if (whole_) floors.ms.push_back(beside);
                sums[i].ms.push_back(whole_ ? demos::msOf(timed, reflectName)
                                            : demos::sumWithin(timed, reflectName));
                sums[i].processorMs.push_back(processorMs() - before);
                for (const demos::TimedPass& pass : timed)
                    if (pass.within == reflectName) passes[i][pass.name].push_back(pass.ms);
            }
        }
        const double floor = median(floors.ms);
        std::printf("  floor %.3f ms\n", floor);
        for (size_t i = 0; i < all.size(); ++i) {
            std::printf("  %-20s %8.3f ms %6.2f", all[i].name, median(sums[i].ms),
                        median(sums[i].ms) / floor);
            if (!whole_) std::printf(" %6.2f", median(sums[i].processorMs) / median(floors.processorMs));
            std::printf(" x floor:");
            for (const auto& [name, ms] : passes[i])
                std::printf("  %s %.2f", name.c_str(), median(ms) / floor);
            std::printf("\n");
            if (all[i].desc.downscale == 1)
                tests::print("   ", tests::score(traced, downloaded(reflectors[i])));
        }
        for (Reflector* reflector : reflectors) destroyReflector(reflector);
        for (int i = 0; i < 2; ++i) require(beginFrame(context_, slot_ ^= 1) == Status::ok, message_);
    }

  private:
    static void require(bool done, const std::string& why) {
        if (done) return;
        std::fprintf(stderr, "%s\n", why.c_str());
        std::exit(1);
    }
    static tests::Reflected downloaded(const Reflector* reflector) {
        const ReflectionImages images = reflectionImages(reflector, 0);
        return {tests::download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                tests::download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
    }
    void floorOnce(Samples* samples) {
        const double before = processorMs();
        double ms = 0;
        demos::Error error;
        require(floor_.time(ms, error), error.text);
        if (!samples) return;
        samples->ms.push_back(ms);
        samples->processorMs.push_back((processorMs() - before) / 2); // of two copies, one of them unseen
    }
    std::vector<demos::TimedPass> reflectOnce(Reflector* reflector, const ViewDesc& view) {
        require(beginFrame(context_, slot_ ^= 1) == Status::ok, message_);
        demos::PassTimer& timer = tests::device().passes();
        run([&](VkCommandBuffer commands) {
            if (whole_) floor_.wake(commands);
            timer.separate(true);
            timer.mark(commands, reflectName, true);
            require(reflect(commands, &reflector, 1, &view) == Status::ok, message_);
            timer.mark(commands, reflectName, false);
            if (whole_) floor_.record(commands);
        });
        std::vector<demos::TimedPass> passes;
        demos::Error error;
        require(timer.collect(passes, error), error.text);
        return passes;
    }

    static constexpr const char* reflectName = "reflect";
    /// Reflection and floor in one submission.
    const bool whole_ = tests::device().clock() == demos::PassClock::timestamps;
    uint32_t rounds_;
    std::vector<Setting> settings_;
    uint32_t slot_ = 0;
    std::string message_;
    demos::TimedFloor floor_;
    Context* context_ = nullptr;
};

} // namespace

int main(int count, char** arguments) {
    uint32_t width = 1920, height = 1080, rounds = 20;
    if (count > 1 && std::sscanf(arguments[1], "%ux%u", &width, &height) != 2) {
        std::fprintf(stderr, "'%s' is no size, expected WIDTHxHEIGHT\n", arguments[1]);
        return 2;
    }
    if (count > 2) rounds = static_cast<uint32_t>(std::max(std::atoi(arguments[2]), 1));
    std::printf("%s, %u x %u, medians of %u by %s\n", tests::device().info().name.c_str(), width, height,
                rounds, describe(tests::device().clock()));
    std::vector<Setting> chosen = settings();
    if (count > 4)
        std::erase_if(chosen,
                      [&](const Setting& s) { return !std::string_view(s.name).starts_with(arguments[4]); });
    Bench bench(width, height, rounds, std::move(chosen));
    for (const tests::Pose& pose : posesOf(width, height))
        if (count <= 3 || pose.name == std::string_view(arguments[3])) bench.measure(pose);
}
