#include "gpu/interface/fields/fields_of.h"
#include "water/interface/fields/water.h"

namespace seaglass {

template<>
inline constexpr FieldTable tableOf<BodyDesc> = bodyFields;
template FieldTable fieldsOf(const BodyDesc&);

template<>
inline constexpr FieldTable tableOf<ExtentDesc> = extentFields;
template FieldTable fieldsOf(const ExtentDesc&);

template<>
inline constexpr FieldTable tableOf<MeshDesc> = meshFields;
template FieldTable fieldsOf(const MeshDesc&);

template<>
inline constexpr FieldTable tableOf<ShadingDesc> = shadingFields;
template FieldTable fieldsOf(const ShadingDesc&);

template<>
inline constexpr FieldTable tableOf<RefractionDesc> = refractionFields;
template FieldTable fieldsOf(const RefractionDesc&);

template<>
inline constexpr FieldTable tableOf<UnderwaterDesc> = underwaterFields;
template FieldTable fieldsOf(const UnderwaterDesc&);

template<>
inline constexpr FieldTable tableOf<CausticsDesc> = causticsFields;
template FieldTable fieldsOf(const CausticsDesc&);

template<>
inline constexpr FieldTable tableOf<SprayDesc> = sprayFields;
template FieldTable fieldsOf(const SprayDesc&);

template<>
inline constexpr FieldTable tableOf<BedDesc> = bedFields;
template FieldTable fieldsOf(const BedDesc&);

template<>
inline constexpr FieldTable tableOf<TargetDesc> = targetFields;
template FieldTable fieldsOf(const TargetDesc&);

} // namespace seaglass
