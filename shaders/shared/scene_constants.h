// The specialisation constants of what reads the scene's colour for a reflection, for GLSL and C++ alike:
// CONSTANT(number, type, name, usual value).
CONSTANT(0, bool, sceneIsEncoded, false)
