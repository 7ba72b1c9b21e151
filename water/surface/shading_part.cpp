// How the surface is shaded, where that is of no other part.
#include "seaglass/fields/water.h"
#include "water/body/body.h"
#include "water/body/part.h"

namespace seaglass {

namespace {

struct ShadingPart {
    static FieldError validate(const BodyDesc& desc) { return badField(shadingFields, &desc.shading); }

    static bool wanted(const BodyDesc&, const Sea*) { return true; }

    void vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const {
        variant.bySchlick = body.shading.fresnel == Fresnel::schlick;
        if (body.shading.deferred && draw.output == SurfaceOutput::shaded && draw.sides == SidesSeen::above)
            variant.pixelsPerShading = body.shading.pixelsPerShading;
    }
};

} // namespace

Part shadingPart() {
    return partFrom<ShadingPart>();
}

} // namespace seaglass
