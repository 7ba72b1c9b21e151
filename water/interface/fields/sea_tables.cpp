#include "water/interface/fields/sea.h"

namespace seaglass {

FieldTable fieldsOf(const SeaDesc&) {
    return seaFields;
}

FieldTable fieldsOf(const SpectrumSample&) {
    return spectrumSampleFields;
}

FieldTable fieldsOf(const SwellDesc&) {
    return swellFields;
}

FieldTable fieldsOf(const ShoreDesc&) {
    return shoreFields;
}

FieldTable fieldsOf(const FoamDesc&) {
    return foamFields;
}

} // namespace seaglass
