#include "gpu/interface/fields/fog.h"
#include "gpu/interface/fields/host.h"

namespace seaglass {

FieldTable fieldsOf(const DeviceDesc&) {
    return deviceFields;
}

FieldTable fieldsOf(const Image&) {
    return imageFields;
}

FieldTable fieldsOf(const ViewDesc&) {
    return viewFields;
}

FieldTable fieldsOf(const SunShadow&) {
    return sunShadowFields;
}

FieldTable fieldsOf(const LightingDesc&) {
    return lightingFields;
}

FieldTable fieldsOf(const FogDesc&) {
    return fogFields;
}

} // namespace seaglass
