// The specialisation constants of the kernels of caustics, for GLSL and C++ alike: CONSTANT(number, type,
// name, usual value).
CONSTANT(0, bool, copies, false) // to images from buffers, as CPU devices do faster than they store
CONSTANT(1, bool, hasShore, false)
CONSTANT(2, bool, hasSunShadow, false)
