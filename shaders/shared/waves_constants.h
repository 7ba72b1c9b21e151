// The specialisation constants of the kernels of waves, for GLSL and C++ alike: CONSTANT(number, type, name,
// usual value).
CONSTANT(0, uint, samples, 256) // 16..2048, a power of two
CONSTANT(1, bool, onCpu, false)
CONSTANT(2, uint, invocations, 64) // of a workgroup
