// The constants that all shaders of a body know.
#ifndef BODY_CONSTANTS_GLSL
#define BODY_CONSTANTS_GLSL

#include "constant.glsl"
#include "body_constants.h"

#endif
