// The specialisation constants of the passes over a view of what lies in the water, for GLSL and C++ alike:
// CONSTANT(number, type, name, usual value).
CONSTANT(0, bool, straddles, false)    // the view's near plane may be above the water too
CONSTANT(1, bool, hasWaves, false)     // only where it straddles
CONSTANT(2, bool, hasShore, false)     // only with waves
CONSTANT(3, uint, exclusionVolumes, 0) // water/body/exclusion_volumes.h: volumesPacked()
CONSTANT(4, bool, sceneIsEncoded, false)
CONSTANT(5, bool, targetIsEncoded, false)
CONSTANT(6, bool, inViews, false)       // of a multiview pass
CONSTANT(7, bool, ofShafts, false)      // of underwater.frag: what they add, in place of the water
CONSTANT(8, bool, placesFigures, false) // of a surface, in place of light
