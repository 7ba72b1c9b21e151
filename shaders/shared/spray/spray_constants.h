// The specialisation constants of a body's spray, for GLSL and C++ alike: CONSTANT(number, type, name, usual
// value).
CONSTANT(0, int, cascades, 0)
CONSTANT(1, int, foamCascades, 1) // that break: the first so many
CONSTANT(2, bool, isWarped, false)
CONSTANT(3, bool, hasShore, false)
CONSTANT(4, bool, onGlobe, false)
CONSTANT(5, bool, hasSunShadow, false) // a shadow map of the host's
CONSTANT(6, uint, fogKind, 0)          // water/light/lighting.h: fogKind()
CONSTANT(7, bool, skyHasColors, false) // in place of the cube
CONSTANT(8, bool, tilted, false)       // its axes are not the world's
CONSTANT(9, bool, targetIsEncoded, false)
CONSTANT(10, bool, inViews, false) // of a multiview pass
