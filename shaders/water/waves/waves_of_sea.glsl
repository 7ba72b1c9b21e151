// Constants of waves for shaders that are not compiled for each sea.
#include "body.glsl"

int cascades = water.seaCascades;
const bool isWarped = true;
