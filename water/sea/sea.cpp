#include "water/sea/sea.h"

#include "water/sea/cascades.h"
#include "water/sea/sea_desc.h"
#include "water/spectrum/slope_variance.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <new>
#include <span>

namespace seaglass {
namespace {

std::unique_ptr<Sea> makeSea(const SeaDesc& desc) {
    auto sea = std::make_unique<Sea>();
    sea->desc = desc;
    if (desc.spectrum == SpectrumModel::table) {
        sea->table.assign(desc.spectrumTable, desc.spectrumTable + desc.spectrumTableCount);
        sea->desc.spectrumTable = sea->table.data();
    } else {
        sea->desc.spectrumTable = nullptr;
        sea->desc.spectrumTableCount = 0;
    }
    sea->desc.shore = nullptr;
    sea->systems = makeSystems(sea->desc);
    if (sea->systems.count == 0) return sea;

    sea->peak = dominantSystem(sea->systems).spectrum.peak;
    sea->count = desc.cascades;
    layCascades(desc, sea->systems, sea->cascades.data());
    sea->warp = warpOf(sea->cascades[0].patch, static_cast<double>(desc.warp));
    for (uint32_t c = 0; c < sea->count; ++c)
        sea->modes[c] = drawModes(desc, sea->systems, c, sea->cascades[c]);
    limitSlopes(*sea);
    for (uint32_t c = 0; c < sea->count; ++c) sea->variance += sea->cascades[c].variance;
    sea->slopes = slopesOf(*sea);
    sea->roughness = roughnessOf(*sea, sea->slopes);
    if (desc.shore)
        sea->shore.emplace(*desc.shore, sea->desc, dominantSystem(sea->systems),
                           std::span(sea->cascades).first(sea->count));
    return sea;
}

} // namespace

Sea* createSea(const SeaDesc* desc, SeaError* error) {
    SeaError unread;
    SeaError& told = error ? *error : unread;
    told = {};
    if (!desc) {
        std::snprintf(told.text, sizeof told.text, "createSea: desc is null; expected a SeaDesc");
        return nullptr;
    }
    if (!validate(*desc, told)) return nullptr;
    try {
        return makeSea(*desc).release();
    } catch (const std::bad_alloc&) {
        std::snprintf(told.text, sizeof told.text, "createSea: out of memory for %u cascades of %u samples",
                      desc->cascades, desc->samples);
        return nullptr;
    }
}

void destroySea(Sea* sea) {
    delete sea;
}

const SeaDesc& description(const Sea& sea) {
    return sea.desc;
}
uint32_t cascadeCount(const Sea& sea) {
    return sea.count;
}
const Cascade& cascade(const Sea& sea, uint32_t index) {
    return sea.cascades[index];
}
double peakFrequency(const Sea& sea) {
    return sea.peak;
}
double frequencySpectrum(const Sea& sea, double omega) {
    const auto amplitude = static_cast<double>(sea.desc.amplitude);
    return amplitude * amplitude * energy(sea.systems, omega);
}
double significantWaveHeight(const Sea& sea) {
    return 4 * std::sqrt(sea.variance);
}
double resolvedShare(const Sea& sea) {
    const auto amplitude = static_cast<double>(sea.desc.amplitude);
    const double asked = amplitude * amplitude * variance(sea.systems);
    if (!(asked > 0)) return 1;
    double held = 0;
    for (uint32_t c = 0; c < sea.count; ++c) held += sea.modes[c].expected;
    return held / asked;
}

} // namespace seaglass
