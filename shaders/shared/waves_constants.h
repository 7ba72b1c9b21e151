// The specialisation constants of the kernels of waves, for GLSL and C++ alike: CONSTANT(number, type, name,
// usual value).
CONSTANT(0, uint, samples, 256) // 16..1024, a power of two
CONSTANT(1, bool, onCpu, false)
