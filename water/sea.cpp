#include "water/sea.h"

#include "water/cascades.h"
#include "water/sea_desc.h"
#include "water/spectrum.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <new>

namespace seaglass {
namespace {

std::unique_ptr<Sea> makeSea(const SeaDesc& desc) {
    auto sea = std::make_unique<Sea>();
    sea->desc = desc;
    const bool calm = desc.windSpeed == 0 || desc.amplitude == 0;
    if (calm) return sea;

    const Spectrum spectrum = makeSpectrum(desc);
    sea->peak = spectrum.peak;
    sea->count = desc.cascades;
    layCascades(desc, spectrum, sea->cascades.data());
    for (uint32_t c = 0; c < sea->count; ++c) {
        sea->modes[c] = drawModes(desc, spectrum, c, sea->cascades[c]);
        sea->variance += sea->cascades[c].variance;
    }
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
double significantWaveHeight(const Sea& sea) {
    return 4 * std::sqrt(sea.variance);
}

} // namespace seaglass
