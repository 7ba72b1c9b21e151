#include "water/body/body_desc.h"

#include <glm/vec4.hpp>

#include "gpu/view/plane.h"
#include "water/body/part.h"
#include "water/interface/fields/water.h"

namespace seaglass {

FieldError badAsked(const FieldTable& table, const void* asked) {
    return asked ? badField(table, asked) : FieldError();
}

FieldError badField(const BodyDesc& desc) {
    glm::dvec4 plane;
    if (const char* bad = readPlane(desc.plane, plane)) return bad;
    // A normal that was turned there may end on either side of level.
    if (!(plane.y > 1e-6)) return "BodyDesc.plane does not face up, expected a normal whose y is positive";
    if (const FieldError bad = badField(bodyFields, &desc)) return bad;
    for (const Part& part : parts())
        if (part.validate)
            if (const FieldError bad = part.validate(desc)) return bad;
    return {};
}

} // namespace seaglass
