// The specialisation constants that several kinds of a body's shaders have, for GLSL and C++ alike, and with
// the same numbers in all: CONSTANT(number, type, name, usual value). Each kind's own list goes on from here.
CONSTANT(0, bool, hasWaves, false)
CONSTANT(1, int, cascades, 0)           // 0: BodyBlock says it, to shaders that are not compiled for each sea
CONSTANT(2, int, foamCascades, 0)       // that break: the first so many
CONSTANT(3, bool, isWarped, true)       // only with waves
CONSTANT(4, bool, hasShore, false)      // only with waves
CONSTANT(5, bool, hasReflection, false) // a screen-space reflection image
CONSTANT(6, bool, hasRefraction, false)
CONSTANT(7, uint, exclusionVolumes, 0)    // water/body/exclusion_volumes.h: volumesPacked()
CONSTANT(8, bool, onGlobe, false)         // only of the shape `plane`
CONSTANT(9, bool, hasSunShadow, false)    // a shadow map of the host's
CONSTANT(10, uint, fogKind, 0)            // water/light/lighting.h: fogKind()
CONSTANT(11, bool, skyHasColors, false)   // in place of the cube
CONSTANT(12, bool, tilted, false)         // its axes are not the world's
CONSTANT(13, bool, sceneIsEncoded, false) // what is read of the scene
CONSTANT(14, bool, targetIsEncoded, false)
CONSTANT(15, bool, inViews, false)      // of a multiview pass
CONSTANT(16, uint, pixelsPerShading, 1) // 1, 2 or 4 to one that is shaded
