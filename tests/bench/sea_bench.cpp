// Times of the sea on one core: evaluating its maps, querying its heights, drawing it.
#include "seaglass/waves_fftw.h"
#include "water/interface/waves_backend.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

namespace {

using namespace seaglass;

using SeaPtr = std::unique_ptr<Sea, decltype(&destroySea)>;

SeaPtr makeSea(uint32_t samples) {
    SeaDesc desc;
    desc.samples = samples;
    return {createSea(&desc, nullptr), &destroySea};
}

void create(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(makeSea(static_cast<uint32_t>(state.range(0))));
}
BENCHMARK(create)->Arg(256)->Unit(benchmark::kMillisecond);

// All three cascades.
void evaluate(benchmark::State& state) {
    const SeaPtr sea = makeSea(static_cast<uint32_t>(state.range(0)));
    const auto* backend = fftwWaves();
    void* waves = backend->create(*sea);
    const size_t floats = 4 * description(*sea).samples * description(*sea).samples;
    std::vector<float> maps(3 * floats);
    const CascadeMaps out{maps.data(), maps.data() + floats, maps.data() + 2 * floats};
    double time = 0;
    for (auto _ : state) {
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c) backend->evaluate(waves, c, time, out);
        time += 1.0 / 60;
        benchmark::ClobberMemory();
    }
    backend->destroy(waves);
}
BENCHMARK(evaluate)->Arg(64)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);

void heights(benchmark::State& state) {
    const SeaPtr sea = makeSea(256);
    std::vector<double> points(2 * static_cast<size_t>(state.range(0)));
    for (size_t i = 0; i < points.size(); ++i) points[i] = 37.1 * static_cast<double>(i);
    std::vector<HeightSample> samples(points.size() / 2);
    double time = 0;
    for (auto _ : state) {
        sampleHeights(*sea, time, points.data(), samples.size(), samples.data());
        time += 1.0 / 60;
        benchmark::ClobberMemory();
    }
}
BENCHMARK(heights)->Arg(1)->Arg(16)->Unit(benchmark::kMillisecond);

} // namespace
