// The specialisation constants of what completes a surface, for GLSL and C++ alike: CONSTANT(number, type,
// name, usual value).
CONSTANT(0, uint, pixelsPerShading, 2) // 2 or 4
