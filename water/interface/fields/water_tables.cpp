#include "water/interface/fields/water.h"

namespace seaglass {

FieldTable fieldsOf(const BodyDesc&) {
    return bodyFields;
}

FieldTable fieldsOf(const ExtentDesc&) {
    return extentFields;
}

FieldTable fieldsOf(const MeshDesc&) {
    return meshFields;
}

FieldTable fieldsOf(const ShadingDesc&) {
    return shadingFields;
}

FieldTable fieldsOf(const RefractionDesc&) {
    return refractionFields;
}

FieldTable fieldsOf(const UnderwaterDesc&) {
    return underwaterFields;
}

FieldTable fieldsOf(const CausticsDesc&) {
    return causticsFields;
}

FieldTable fieldsOf(const SprayDesc&) {
    return sprayFields;
}

FieldTable fieldsOf(const BedDesc&) {
    return bedFields;
}

FieldTable fieldsOf(const TargetDesc&) {
    return targetFields;
}

} // namespace seaglass
