#include "gpu/interface/fields/fields_of.h"
#include "water/interface/fields/sea.h"

namespace seaglass {

template<>
inline constexpr FieldTable tableOf<SeaDesc> = seaFields;
template FieldTable fieldsOf(const SeaDesc&);

template<>
inline constexpr FieldTable tableOf<SpectrumSample> = spectrumSampleFields;
template FieldTable fieldsOf(const SpectrumSample&);

template<>
inline constexpr FieldTable tableOf<SwellDesc> = swellFields;
template FieldTable fieldsOf(const SwellDesc&);

template<>
inline constexpr FieldTable tableOf<ShoreDesc> = shoreFields;
template FieldTable fieldsOf(const ShoreDesc&);

template<>
inline constexpr FieldTable tableOf<FoamDesc> = foamFields;
template FieldTable fieldsOf(const FoamDesc&);

} // namespace seaglass
