// The specialisation constants of shaders/reflection/sspr/miss.comp, for GLSL and C++ alike: CONSTANT(number,
// type, name, usual value).
CONSTANT(0, bool, colorIsCleared, false)
