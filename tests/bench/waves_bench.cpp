// What the waves cost, as multiples of bare FFTW: the same complex transforms with nothing around them,
// single precision, the fastest plans that it finds (MEASURE, four times as fast as ESTIMATE's here), one
// thread. All take turns, so that they see the same machine; medians over the rounds.
//
//   seaglass_bench_waves [SAMPLES [CASCADES [ROUNDS]]]
#include <ctime>
#include <fftw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "host/timing/timed_floor.h"
#include "seaglass/water.h"
#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/rig.h"
#include "water/interface/waves_backend.h"

namespace {

using namespace seaglass;

constexpr uint32_t pairs = 4; ///< complex fields of a cascade

void require(bool done, const std::string& why) {
    if (done) return;
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

double millisecondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double processorMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
}

double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

/// Inverse transforms in place, `count` of samples^2, each with a plan of its own as threads want it.
class BareFftw {
  public:
    BareFftw(uint32_t samples, uint32_t count)
        : points_(size_t{samples} * samples), count_(count),
          memory_(fftwf_alloc_complex(points_ * count), fftwf_free) {
        for (size_t i = 0; i < points_ * count; ++i) memory_.get()[i][0] = memory_.get()[i][1] = 0;
        const int size[] = {static_cast<int>(samples), static_cast<int>(samples)};
        plan_ = fftwf_plan_dft(2, size, memory_.get(), memory_.get(), FFTW_BACKWARD, FFTW_MEASURE);
        require(plan_, "no plan");
    }
    ~BareFftw() { fftwf_destroy_plan(plan_); }
    BareFftw(const BareFftw&) = delete;
    BareFftw& operator=(const BareFftw&) = delete;

    void run(uint32_t threads) const {
        std::vector<std::jthread> others;
        for (uint32_t t = 1; t < threads; ++t) others.emplace_back([this, t, threads] { share(t, threads); });
        share(0, threads);
    }

  private:
    void share(uint32_t thread, uint32_t threads) const {
        for (uint32_t i = thread; i < count_; i += threads)
            fftwf_execute_dft(plan_, memory_.get() + points_ * i, memory_.get() + points_ * i);
    }

    size_t points_;
    uint32_t count_;
    std::unique_ptr<fftwf_complex, void (*)(void*)> memory_;
    fftwf_plan plan_ = nullptr;
};

/// All cascades of a sea by the FFTW backend, into memory.
class CpuWaves {
  public:
    CpuWaves(const Sea& sea, uint32_t threads)
        : sea_(sea), backend_(*fftwWaves(threads)), state_(backend_.create(sea)),
          floats_(4 * size_t{description(sea).samples} * description(sea).samples),
          maps_(3 * floats_ * cascadeCount(sea)) {}
    ~CpuWaves() { backend_.destroy(state_); }
    CpuWaves(const CpuWaves&) = delete;
    CpuWaves& operator=(const CpuWaves&) = delete;

    void run(double time) {
        for (uint32_t c = 0; c < cascadeCount(sea_); ++c) {
            float* maps = maps_.data() + 3 * floats_ * c;
            backend_.evaluate(state_, c, time, {maps, maps + floats_, maps + 2 * floats_});
        }
    }

  private:
    const Sea& sea_;
    const WavesBackend& backend_;
    void* state_;
    size_t floats_;
    std::vector<float> maps_;
};

/// A body's waves by compute shaders, timed by the device.
class DeviceWaves {
  public:
    explicit DeviceWaves(const SeaDesc& sea) {
        demos::Error error;
        require(floor_.create(tests::device(), {1280, 720}, error), error.text);
        const DeviceDesc device = tests::deviceDesc(&message_);
        require(createContext(&device, &context_) == Status::ok, message_);
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesOn = WavesOn::gpu;
        require(createBody(context_, &desc, &body_) == Status::ok, message_);
    }
    ~DeviceWaves() {
        destroyBody(body_);
        destroyContext(context_);
    }
    DeviceWaves(const DeviceWaves&) = delete;
    DeviceWaves& operator=(const DeviceWaves&) = delete;

    /// Its passes, and all of them as one, "whole".
    std::vector<demos::TimedPass> run(double time) {
        require(beginFrame(context_, slot_ ^= 1) == Status::ok, message_);
        demos::Error error;
        demos::Device& device = tests::device();
        const bool done = device.run(
            [&](VkCommandBuffer commands, demos::Error&) {
                if (device.clock() == demos::PassClock::timestamps) floor_.wake(commands);
                device.passes().separate(true);
                device.passes().mark(commands, "whole", true);
                require(simulate(commands, &body_, 1, time) == Status::ok, message_);
                device.passes().mark(commands, "whole", false);
                if (device.clock() == demos::PassClock::timestamps) floor_.record(commands);
                return true;
            },
            error);
        std::vector<demos::TimedPass> passes;
        require(done && device.passes().collect(passes, error), error.text);
        floor_.recordedMs(passes);
        return passes;
    }

  private:
    std::string message_;
    demos::TimedFloor floor_; ///< which tells how many copies wake the device
    Context* context_ = nullptr;
    Body* body_ = nullptr;
    uint32_t slot_ = 0;
};

/// Height queries of a grid, or of the modes themselves: nanoseconds a point.
class Queries {
  public:
    /// Points all over a square of `extent` metres, in no order that memory would like.
    Queries(double extent, size_t count) : points_(2 * count), samples_(count) {
        for (size_t i = 0; i < points_.size(); ++i)
            points_[i] = extent * std::fmod(0.6180339887498949 * static_cast<double>(i * i % 1000003), 1);
    }
    double onGrid(const HeightGrid& grid) {
        return nanoseconds([&] { sampleHeights(grid, points_.data(), samples_.size(), samples_.data()); });
    }
    double ofModes(const Sea& sea, double time) {
        return nanoseconds(
            [&] { sampleHeights(sea, time, points_.data(), samples_.size(), samples_.data()); });
    }

  private:
    double nanoseconds(const std::function<void()>& work) const {
        work(); // what was timed before has the caches
        return 1e6 * millisecondsOf(work) / static_cast<double>(samples_.size());
    }
    std::vector<double> points_;
    std::vector<HeightSample> samples_;
};

/// Times of one thing, round by round.
struct Row {
    std::string name;
    std::vector<double> ms;
};

std::vector<double>& timesOf(std::vector<Row>& rows, const std::string& name) {
    for (Row& row : rows)
        if (row.name == name) return row.ms;
    return rows.emplace_back(Row{name, {}}).ms;
}

uint32_t argument(int count, char** arguments, int index, uint32_t otherwise) {
    return count > index ? static_cast<uint32_t>(std::max(std::atoi(arguments[index]), 1)) : otherwise;
}

} // namespace

int main(int count, char** arguments) {
    SeaDesc desc;
    desc.samples = argument(count, arguments, 1, 256);
    desc.cascades = argument(count, arguments, 2, 3);
    const uint32_t rounds = argument(count, arguments, 3, 200);
    SeaError error;
    const std::unique_ptr<Sea, void (*)(Sea*)> sea(createSea(&desc, &error), destroySea);
    require(sea != nullptr, error.text);

    const BareFftw bare(desc.samples, pairs * desc.cascades);
    CpuWaves cpu(*sea, 1), cpuTwo(*sea, 2);
    DeviceWaves gpu(desc);
    const demos::PassClock clock = tests::device().clock();
    const std::unique_ptr<HeightGrid, void (*)(HeightGrid*)> grid(createHeightGrid(*sea, 0),
                                                                  destroyHeightGrid);
    require(grid != nullptr, "out of memory");
    Queries hulls(100, 4096), anywhere(1e5, 4096), few(100, 4);
    std::vector<Row> rows, queries;
    constexpr uint32_t warmUps = 3;
    for (uint32_t round = 0; round < warmUps + rounds; ++round) {
        const double time = round / 60.0;
        const auto add = [&](const std::string& name, double ms) {
            std::vector<double>& times = timesOf(rows, name);
            if (round >= warmUps) times.push_back(ms);
        };
        add("bare FFTW, one thread", millisecondsOf([&] { bare.run(1); }));
        add("bare FFTW, two threads", millisecondsOf([&] { bare.run(2); }));
        add("fftwWaves(1), whole update", millisecondsOf([&] { cpu.run(time); }));
        add("fftwWaves(2), whole update", millisecondsOf([&] { cpuTwo.run(time); }));
        const double before = processorMilliseconds();
        const std::vector<demos::TimedPass> passes = gpu.run(time);
        const double used = processorMilliseconds() - before;
        for (const demos::TimedPass& pass : passes) add("compute shaders: " + pass.name, pass.ms);
        if (clock != demos::PassClock::timestamps) add("compute shaders: all processors", used);
        add("setTime() of a height grid", millisecondsOf([&] { setTime(*grid, time); }));
        if (round < warmUps) continue;
        timesOf(queries, "grid, 4096 points within 100 m").push_back(hulls.onGrid(*grid));
        timesOf(queries, "grid, 4096 points within 100 km").push_back(anywhere.onGrid(*grid));
        timesOf(queries, "modes, 4 points").push_back(few.ofModes(*sea, time));
    }
    std::printf("%s, %u cascades of %u^2, %u rounds, shaders by %s\n", tests::device().info().name.c_str(),
                desc.cascades, desc.samples, rounds, describe(clock));
    const std::vector<double> one = timesOf(rows, "bare FFTW, one thread");
    std::printf("%-34s %21s   %s\n", "", "median, x bare", "least, x bare");
    for (const Row& row : rows)
        std::printf("%-34s %8.3f ms %8.2f   %8.3f ms %8.2f\n", row.name.c_str(), median(row.ms),
                    median(row.ms) / median(one), least(row.ms), least(row.ms) / least(one));
    std::printf("a height query, ns, one thread\n");
    for (const Row& row : queries)
        std::printf("%-34s %11.0f median %11.0f least\n", row.name.c_str(), median(row.ms), least(row.ms));
}
