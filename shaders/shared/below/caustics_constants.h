// The specialisation constants of the kernels of caustics, for GLSL and C++ alike: CONSTANT(number, type,
// name, usual value).
#ifdef __cplusplus
#include "../body_constants.h"
#endif
CONSTANT(17, bool, copies, false) // to images from buffers, as CPU devices do faster than they store
