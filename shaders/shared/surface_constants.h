// The specialisation constants of a body's surface, for GLSL and C++ alike: CONSTANT(number, type, name,
// usual value).
CONSTANT(0, uint, surfaceOutput, 0)
CONSTANT(1, uint, sidesSeen, 0) // water/surface/surface.h: SidesSeen
CONSTANT(2, bool, hasWaves, false)
CONSTANT(3, bool, hasShore, false)      // only with waves
CONSTANT(4, bool, hasFoam, false)       // only with waves
CONSTANT(5, bool, hasReflection, false) // a screen-space reflection image
CONSTANT(6, bool, hasRefraction, false)
CONSTANT(7, bool, hasSunShadow, false) // a shadow map of the host's
CONSTANT(8, uint, shape, 0)            // water/mesh/placing.h: SurfaceShape
CONSTANT(9, bool, forMotion, false)    // beside it waves, shore, shape and exclusionVolumes alone
CONSTANT(10, bool, inViews, false)     // of a multiview pass
CONSTANT(11, int, cascades, 0)
CONSTANT(12, int, foamCascades, 0)                 // that break: the first so many
CONSTANT(13, bool, hasSubsurfaceScattering, false) // only with waves and refraction
CONSTANT(14, uint, exclusionVolumes, 0)            // water/body/exclusion_volumes.h: volumesPacked()
CONSTANT(15, int, waveShadowSteps, 0)
CONSTANT(16, int, reflectionSamples, 1) // 1, 2 or 4
CONSTANT(17, int, refractionSamples, 6) // 1: straight through
CONSTANT(18, int, slopeSamples, 1)      // 1, 2 or 4
CONSTANT(19, bool, tilted, false)       // its axes are not the world's
CONSTANT(20, bool, hasParallax, false)  // only with waves and without a shore
CONSTANT(21, int, bedDownscale,
         0) // only with refraction: of the bed's picture of its own, 0: none is looked at
CONSTANT(22, bool, bySchlick, false) // in place of the exact formula
CONSTANT(23, bool, onGlobe, false)   // only of the shape `plane`
CONSTANT(24, int, sharpDownscale,
         0) // of still water's reflection without mips: pixels to a texel; 0: of other
CONSTANT(25, bool, skyHasColors, false)   // in place of the cube
CONSTANT(26, bool, sceneIsEncoded, false) // only with refraction: what is read of the scene
CONSTANT(27, bool, targetIsEncoded, false)
CONSTANT(28, bool, manySamples,
         false) // only with refraction: of the scene, of which sample 0 may lie before the surface
CONSTANT(29, uint, fogKind, 0)          // water/light/lighting.h: fogKind()
CONSTANT(30, bool, isWarped, false)     // only with waves
CONSTANT(31, bool, quadsInStep, false)  // of kernels, where full subgroups hold whole quads
CONSTANT(32, uint, pixelsPerShading, 1) // 1, 2 or 4 to one that is shaded
CONSTANT(33, bool, hasGlitter, false)   // only with waves
CONSTANT(34, uint, shadingStep, 0)      // water/shading/shaded_surface.h: ShadingStep
CONSTANT(35, bool, hasGusts, false)     // only with waves
