// The specialisation constants of a surface's lists of tiles, and of what completes its pixels, for GLSL and
// C++ alike: CONSTANT(number, type, name, usual value).
CONSTANT(0, uint, listingStep, 0) // 0: finds what shows where, 1: what each tile needs, 2: lists them
CONSTANT(1, bool, hasReflection, false)
CONSTANT(2, bool, hasRefraction, false)
CONSTANT(3, bool, sortsMirrors, false) // only with a reflection: some tiles may do without it
CONSTANT(4, bool, sortsBed, false)     // likewise with refraction
CONSTANT(5, uint, pixelsPerShading, 1) // surface_constants.h
