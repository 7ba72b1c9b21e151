#include "water/sea/sea_desc.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "gpu/field_error.h"
#include "water/interface/fields/sea.h"

namespace seaglass {
namespace {

[[gnu::format(printf, 2, 3)]] bool fail(SeaError& error, const char* format, ...) {
    va_list values;
    va_start(values, format);
    std::vsnprintf(error.text, sizeof error.text, format, values);
    va_end(values);
    return false;
}

bool inRange(const char* owner, const Field& field, const char* index, double value, SeaError& error) {
    if (isInRange(field, value)) return true;
    FieldError expected;
    addExpected(expected, field);
    return fail(error, "%s.%s%s is %.9g; expected %s", owner, field.name, index, value, expected.text());
}

bool inRange(const char* owner, const FieldTable& table, const void* desc, SeaError& error) {
    for (const Field& field : table) {
        for (uint32_t i = 0; i < field.count; ++i) {
            char index[16] = "";
            if (field.count > 1) std::snprintf(index, sizeof index, "[%u]", i);
            if (!inRange(owner, field, index, field.get(desc, i), error)) return false;
        }
    }
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
        if (!inRange(owner, spectrumSampleFields, &desc.spectrumTable[i], error)) return false;
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
        char owner[32];
        std::snprintf(owner, sizeof owner, "SeaDesc.swells[%u]", i);
        if (!inRange(owner, swellFields, &desc.swells[i], error)) return false;
    }
    return true;
}

bool validateShore(const SeaDesc& desc, SeaError& error) {
    if (!desc.shore) return true;
    const ShoreDesc& shore = *desc.shore;
    if (!shore.bed) return fail(error, "ShoreDesc.bed is null; expected heights");
    if (!inRange("ShoreDesc", shoreFields, &shore, error)) return false;
    const size_t count = size_t{shore.samples[0]} * shore.samples[1];
    for (size_t i = 0; i < count; ++i) {
        if (!(std::fabs(shore.bed[i]) <= 1e4f))
            return fail(error, "ShoreDesc.bed[%zu] is %.9g; expected -10000 to 10000 m", i,
                        double{shore.bed[i]});
    }
    return true;
}

} // namespace

bool validate(const SeaDesc& desc, SeaError& error) {
    if (!inRange("SeaDesc", seaFields, &desc, error)) return false;
    return validateTable(desc, error) && validateSwells(desc, error) && validateShore(desc, error);
}

} // namespace seaglass
