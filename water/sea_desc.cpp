#include "water/sea_desc.h"

#include <bit>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>

namespace seaglass {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Range {
    const char* field;
    double value;
    double low;
    double high;
    const char* unit;
};

[[gnu::format(printf, 2, 3)]] bool fail(SeaError& error, const char* format, ...) {
    va_list values;
    va_start(values, format);
    std::vsnprintf(error.text, sizeof error.text, format, values);
    va_end(values);
    return false;
}

bool inRange(const char* owner, const Range& range, SeaError& error) {
    if (range.value >= range.low && range.value <= range.high) return true;
    return fail(error, "%s.%s is %.9g; expected %g to %g%s", owner, range.field, range.value, range.low,
                range.high, range.unit);
}

bool isAngle(const char* owner, const char* field, float angle, SeaError& error) {
    if (std::isfinite(angle)) return true;
    return fail(error, "%s.%s is %g; expected a finite angle in radians", owner, field,
                static_cast<double>(angle));
}

bool validateModels(const SeaDesc& desc, SeaError& error) {
    const auto spectrum = static_cast<uint32_t>(desc.spectrum);
    if (spectrum > static_cast<uint32_t>(SpectrumModel::table))
        return fail(error, "SeaDesc.spectrum is %u; expected a SpectrumModel, 0 to 4", spectrum);
    const auto spreading = static_cast<uint32_t>(desc.spreading);
    if (spreading > static_cast<uint32_t>(SpreadingModel::cosine2s))
        return fail(error, "SeaDesc.spreading is %u; expected a SpreadingModel, 0 to 3", spreading);
    return true;
}

bool validateTable(const SeaDesc& desc, SeaError& error) {
    if (desc.spectrum != SpectrumModel::table) return true;
    if (!desc.spectrumTable) return fail(error, "SeaDesc.spectrumTable is null; expected samples");
    if (desc.spectrumTableCount < 2 || desc.spectrumTableCount > maxSpectrumSamples)
        return fail(error, "SeaDesc.spectrumTableCount is %u; expected 2 to %u", desc.spectrumTableCount,
                    maxSpectrumSamples);
    double last = 0, highest = 0;
    for (uint32_t i = 0; i < desc.spectrumTableCount; ++i) {
        const double frequency = desc.spectrumTable[i].frequency, density = desc.spectrumTable[i].density;
        char owner[48];
        std::snprintf(owner, sizeof owner, "SeaDesc.spectrumTable[%u]", i);
        if (!inRange(owner, {"frequency", frequency, 0.01f, 50, " Hz"}, error)) return false;
        if (!inRange(owner, {"density", density, 0, 1e6, " m^2/Hz"}, error)) return false;
        if (!(frequency > last))
            return fail(error, "%s.frequency is %.9g; expected more than %.9g, the one before", owner,
                        frequency, last);
        last = frequency;
        highest = std::fmax(highest, density);
    }
    if (!(highest > 0))
        return fail(error, "SeaDesc.spectrumTable has no density above 0; expected one at least");
    return true;
}

bool validateSwells(const SeaDesc& desc, SeaError& error) {
    for (uint32_t i = 0; i < maxSwells; ++i) {
        const SwellDesc& swell = desc.swells[i];
        char owner[32];
        std::snprintf(owner, sizeof owner, "SeaDesc.swells[%u]", i);
        const Range ranges[] = {
            {"height", swell.height, 0, 30, " m"},
            {"peakPeriod", swell.peakPeriod, 1, 30, " s"},
            {"bandwidth", swell.bandwidth, 0.02f, 0.25f, ""},
            {"spreading", swell.spreading, 0, 1000, ""},
        };
        for (const Range& range : ranges)
            if (!inRange(owner, range, error)) return false;
        if (!isAngle(owner, "direction", swell.direction, error)) return false;
    }
    return true;
}

bool validateShore(const SeaDesc& desc, SeaError& error) {
    if (!desc.shore) return true;
    const ShoreDesc& shore = *desc.shore;
    if (!shore.bed) return fail(error, "ShoreDesc.bed is null; expected heights");
    const Range ranges[] = {
        {"samples[0]", static_cast<double>(shore.samples[0]), 2, 1024, ""},
        {"samples[1]", static_cast<double>(shore.samples[1]), 2, 1024, ""},
        {"spacing", shore.spacing, 0.05f, 100, " m"},
        {"origin[0]", shore.origin[0], -1e6, 1e6, " m"},
        {"origin[1]", shore.origin[1], -1e6, 1e6, " m"},
    };
    for (const Range& range : ranges)
        if (!inRange("ShoreDesc", range, error)) return false;
    const size_t count = size_t{shore.samples[0]} * shore.samples[1];
    for (size_t i = 0; i < count; ++i) {
        char field[32];
        std::snprintf(field, sizeof field, "bed[%zu]", i);
        if (!(std::fabs(shore.bed[i]) <= 1e4f))
            return inRange("ShoreDesc", {field, shore.bed[i], -1e4, 1e4, " m"}, error);
    }
    return true;
}

} // namespace

bool validate(const SeaDesc& desc, SeaError& error) {
    if (!validateModels(desc, error)) return false;
    if (!isAngle("SeaDesc", "windDirection", desc.windDirection, error)) return false;
    const Range ranges[] = {
        {"windSpeed", desc.windSpeed, 0, 100, " m/s"},
        {"fetch", desc.fetch, 1, 1e6, " m"},
        {"peakEnhancement", desc.peakEnhancement, 1, 10, ""},
        {"depth", desc.depth, 0, infinity, " m"},
        {"spreadingShape", desc.spreadingShape, 0, 1000, ""},
        {"swell", desc.swell, 0, 1, ""},
        {"amplitude", desc.amplitude, 0, 1, ""},
        {"choppiness", desc.choppiness, 0, 10, ""},
        {"samples", static_cast<double>(desc.samples), 16, 1024, ", a power of two"},
        {"cascades", static_cast<double>(desc.cascades), 1, maxCascades, ""},
        {"loopPeriod", desc.loopPeriod, 16, 1e6, " s"},
    };
    for (const Range& range : ranges)
        if (!inRange("SeaDesc", range, error)) return false;
    if (!std::has_single_bit(desc.samples))
        return fail(error, "SeaDesc.samples is %u; expected a power of two from 16 to 1024", desc.samples);
    const bool chosen = desc.largestPatch == 0;
    if (!chosen && !(desc.largestPatch >= 1 && desc.largestPatch <= 1e5f))
        return fail(error, "SeaDesc.largestPatch is %.9g; expected 1 to 100000 m, or 0",
                    static_cast<double>(desc.largestPatch));
    return validateTable(desc, error) && validateSwells(desc, error) && validateShore(desc, error);
}

} // namespace seaglass
