// What wave_warp.glsl needs, of shaders that are not compiled for each sea. Needs body.glsl.

int cascades = water.seaCascades;
const bool isWarped = true;
