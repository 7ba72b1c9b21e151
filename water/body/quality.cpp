#include <algorithm>

#include "reflection/interface/fields/reflection.h"
#include "water/interface/fields/water.h"

namespace seaglass {

namespace {

void grade(const FieldTable& table, void* desc, Quality quality) {
    for (const Field& field : table)
        if (field.graded) field.set(desc, 0, field.grades[static_cast<size_t>(quality)]);
}

bool readsThePicture(ReflectionTechnique technique) {
    return technique != ReflectionTechnique::sky && technique != ReflectionTechnique::planar;
}

} // namespace

void setQuality(Quality quality, BodyDesc* body, ReflectionDesc* reflection) {
    quality = std::min(quality, Quality::highest);
    if (body) {
        grade(meshFields, &body->mesh, quality);
        grade(shadingFields, &body->shading, quality);
        if (quality == Quality::low) body->bed = nullptr;
    }
    if (reflection) {
        const ReflectionTechnique before = reflection->technique;
        grade(reflectionFields, reflection, quality);
        if (!readsThePicture(before)) reflection->technique = before;
    }
}

} // namespace seaglass
