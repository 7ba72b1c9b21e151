// The specialisation constants of a body's surface, for GLSL and C++ alike: CONSTANT(number, type, name,
// usual value).
#ifdef __cplusplus
#include "body_constants.h"
#endif
CONSTANT(17, uint, surfaceOutput, 0)
CONSTANT(18, uint, sidesSeen, 0)                   // water/surface/surface.h: SidesSeen
CONSTANT(19, bool, hasFoam, false)                 // only with waves
CONSTANT(20, uint, shape, 0)                       // water/mesh/placing.h: SurfaceShape
CONSTANT(21, bool, forMotion, false)               // beside it waves, shore, shape and exclusionVolumes alone
CONSTANT(22, bool, hasSubsurfaceScattering, false) // only with waves and refraction
CONSTANT(23, int, waveShadowSteps, 0)
CONSTANT(24, int, reflectionSamples, 1) // 1, 2 or 4
CONSTANT(25, int, refractionSamples, 6) // 1: straight through
CONSTANT(26, int, slopeSamples, 1)      // 1, 2 or 4
CONSTANT(27, bool, hasParallax, false)  // only with waves and without a shore
CONSTANT(28, int, bedDownscale,
         0) // only with refraction: of the bed's picture of its own, 0: none is looked at
CONSTANT(29, bool, bySchlick, false) // in place of the exact formula
CONSTANT(30, int, sharpDownscale,
         0) // of still water's reflection without mips: pixels to a texel; 0: of other
CONSTANT(31, bool, manySamples,
         false) // only with refraction: of the scene, of which sample 0 may lie before the surface
CONSTANT(32, bool, quadsInStep, false) // of kernels, where full subgroups hold whole quads
CONSTANT(33, bool, hasGlitter, false)  // only with waves
CONSTANT(34, uint, shadingStep, 0)     // water/shading/shaded_surface.h: ShadingStep
CONSTANT(35, bool, hasGusts, false)    // only with waves
