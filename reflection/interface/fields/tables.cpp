#include "reflection/interface/fields/reflection.h"

namespace seaglass {

FieldTable fieldsOf(const SceneSamples&) {
    return sceneSampleFields;
}

FieldTable fieldsOf(const ReflectionDesc&) {
    return reflectionFields;
}

FieldTable fieldsOf(const OverlayDesc&) {
    return overlayFields;
}

} // namespace seaglass
