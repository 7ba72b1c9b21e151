#include "gpu/interface/fields/fields_of.h"
#include "gpu/interface/fields/fog.h"
#include "gpu/interface/fields/host.h"

namespace seaglass {

template<>
inline constexpr FieldTable tableOf<DeviceDesc> = deviceFields;
template FieldTable fieldsOf(const DeviceDesc&);

template<>
inline constexpr FieldTable tableOf<Image> = imageFields;
template FieldTable fieldsOf(const Image&);

template<>
inline constexpr FieldTable tableOf<ViewDesc> = viewFields;
template FieldTable fieldsOf(const ViewDesc&);

template<>
inline constexpr FieldTable tableOf<SunShadow> = sunShadowFields;
template FieldTable fieldsOf(const SunShadow&);

template<>
inline constexpr FieldTable tableOf<LightingDesc> = lightingFields;
template FieldTable fieldsOf(const LightingDesc&);

template<>
inline constexpr FieldTable tableOf<FogDesc> = fogFields;
template FieldTable fieldsOf(const FogDesc&);

} // namespace seaglass
