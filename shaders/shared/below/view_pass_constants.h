// The specialisation constants of the passes over a view of what lies in the water, for GLSL and C++ alike:
// CONSTANT(number, type, name, usual value).
#ifdef __cplusplus
#include "../body_constants.h"
#endif
CONSTANT(17, bool, straddles, false)     // the view's near plane may be above the water too
CONSTANT(18, bool, ofShafts, false)      // of underwater.frag: what they add, in place of the water
CONSTANT(19, bool, placesFigures, false) // of a surface, in place of light
