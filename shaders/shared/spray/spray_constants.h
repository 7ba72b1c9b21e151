// The specialisation constants of spray, for GLSL and C++ alike: CONSTANT(number, type, name, usual value).
#ifdef __cplusplus
#include "../body_constants.h"
#endif
CONSTANT(17, bool, straddles, false) // the view's near plane may be in the water too
