#include "water/sea_desc.h"

#include <bit>
#include <cmath>
#include <cstdio>

namespace seaglass {
namespace {

struct Range {
    const char* field;
    double value;
    double low;
    double high;
    const char* unit;
};

} // namespace

bool validate(const SeaDesc& desc, SeaError& error) {
    const auto model = static_cast<uint32_t>(desc.spectrum);
    if (model > static_cast<uint32_t>(SpectrumModel::piersonMoskowitz)) {
        std::snprintf(error.text, sizeof error.text,
                      "SeaDesc.spectrum is %u; expected 0 (JONSWAP) or 1 (Pierson-Moskowitz)", model);
        return false;
    }
    if (!std::isfinite(desc.windDirection)) {
        std::snprintf(error.text, sizeof error.text,
                      "SeaDesc.windDirection is %g; expected a finite angle in radians",
                      static_cast<double>(desc.windDirection));
        return false;
    }
    const Range ranges[] = {
        {"windSpeed", desc.windSpeed, 0, 60, " m/s"},
        {"fetch", desc.fetch, 1, 1e7, " m"},
        {"peakEnhancement", desc.peakEnhancement, 1, 10, ""},
        {"swell", desc.swell, 0, 1, ""},
        {"amplitude", desc.amplitude, 0, 1, ""},
        {"choppiness", desc.choppiness, 0, 10, ""},
        {"samples", static_cast<double>(desc.samples), 16, 1024, ", a power of two"},
        {"cascades", static_cast<double>(desc.cascades), 1, maxCascades, ""},
        {"loopPeriod", desc.loopPeriod, 16, 1e6, " s"},
    };
    for (const Range& range : ranges) {
        if (range.value >= range.low && range.value <= range.high) continue;
        std::snprintf(error.text, sizeof error.text, "SeaDesc.%s is %.9g; expected %g to %g%s", range.field,
                      range.value, range.low, range.high, range.unit);
        return false;
    }
    if (!std::has_single_bit(desc.samples)) {
        std::snprintf(error.text, sizeof error.text,
                      "SeaDesc.samples is %u; expected a power of two from 16 to 1024", desc.samples);
        return false;
    }
    const bool chosen = desc.largestPatch == 0;
    if (!chosen && !(desc.largestPatch >= 1 && desc.largestPatch <= 1e5f)) {
        std::snprintf(error.text, sizeof error.text,
                      "SeaDesc.largestPatch is %.9g; expected 1 to 100000 m, or 0",
                      static_cast<double>(desc.largestPatch));
        return false;
    }
    return true;
}

} // namespace seaglass
