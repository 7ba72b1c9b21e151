// The specialisation constants of a surface's lists of tiles, and of what completes its pixels, for GLSL and
// C++ alike: CONSTANT(number, type, name, usual value).
#ifdef __cplusplus
#include "body_constants.h"
#endif
CONSTANT(17, uint, listingStep, 0)      // 0: finds what shows where, 1: what each tile needs, 2: lists them
CONSTANT(18, bool, sortsMirrors, false) // only with a reflection: some tiles may do without it
CONSTANT(19, bool, sortsBed, false)     // likewise with refraction
