#include "water/spectrum/wave_systems.h"

#include <algorithm>

namespace seaglass {

WaveSystems makeSystems(const SeaDesc& desc) {
    WaveSystems systems;
    systems.depth = desc.depth;
    if (desc.depth == 0 || desc.amplitude == 0) return systems;
    if (desc.windSpeed > 0) {
        systems.system[systems.count++] = {
            .spectrum = makeSpectrum(desc),
            .spreading = {.model = desc.spreading, .shape = desc.spreadingShape, .swell = desc.swell},
            .direction = desc.windDirection};
    }
    for (const SwellDesc& swell : desc.swells) {
        if (swell.height == 0) continue;
        systems.system[systems.count++] = {
            .spectrum = makeSpectrum(swell),
            .spreading = {.model = SpreadingModel::cosine2s, .shape = swell.spreading, .swell = 0},
            .direction = swell.direction};
    }
    return systems;
}

double energy(const WaveSystems& systems, double omega) {
    double sum = 0;
    for (uint32_t s = 0; s < systems.count; ++s) sum += energy(systems.system[s].spectrum, omega);
    return sum;
}

double variance(const WaveSystems& systems) {
    double sum = 0;
    for (uint32_t s = 0; s < systems.count; ++s) sum += variance(systems.system[s].spectrum);
    return sum;
}

double waveNumberSpectrum(const WaveSystems& systems, double k) {
    return energy(systems, angularFrequency(k, systems.depth)) * groupSpeed(k, systems.depth);
}

const WaveSystem& dominantSystem(const WaveSystems& systems) {
    const auto atPeak = [](const WaveSystem& system) {
        return energy(system.spectrum, system.spectrum.peak);
    };
    return *std::max_element(systems.system.begin(), systems.system.begin() + systems.count,
                             [&](const WaveSystem& a, const WaveSystem& b) { return atPeak(a) < atPeak(b); });
}

} // namespace seaglass
