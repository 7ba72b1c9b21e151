#include "gpu/interface/fields/fields_of.h"
#include "reflection/interface/fields/reflection.h"

namespace seaglass {

template<>
inline constexpr FieldTable tableOf<SceneSamples> = sceneSampleFields;
template FieldTable fieldsOf(const SceneSamples&);

template<>
inline constexpr FieldTable tableOf<ReflectionDesc> = reflectionFields;
template FieldTable fieldsOf(const ReflectionDesc&);

template<>
inline constexpr FieldTable tableOf<OverlayDesc> = overlayFields;
template FieldTable fieldsOf(const OverlayDesc&);

} // namespace seaglass
