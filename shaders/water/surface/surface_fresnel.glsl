// The share of light that the surface mirrors, by the formula that ShadingDesc::fresnel names; the rest goes through it. What
// enters the water for all that lies in it is the exact formula's: water_light.glsl and subsurface_scattering.glsl.
#ifndef SURFACE_FRESNEL_GLSL
#define SURFACE_FRESNEL_GLSL

#include "surface.glsl"
#include "optics.glsl"

float mirroredShare(float cosIncidence) {
    return bySchlick ? fresnelSchlick(cosIncidence) : fresnelWater(cosIncidence);
}

// From water into air, where beyond the critical angle no ray leaves and all of it stays.
float mirroredShareBelow(float cosIncidence) {
    float c = clamp(cosIncidence, 0.0, 1.0);
    float sine2 = waterIndex * waterIndex * (1.0 - c * c);   // of the ray in air
    return sine2 >= 1.0 ? 1.0 : mirroredShare(sqrt(1.0 - sine2));
}

#endif
