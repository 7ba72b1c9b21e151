// The floor, as in mirror_pass.h. Positions are in metres from the eye.
layout(set = 1, binding = 0, std140) uniform Mirror {
    vec4 middle;   // w: reflectance seen straight on
    vec4 across;   // half the width; w: repeats of the texture in that
    vec4 along;    // half the length; w: repeats of the texture in that
    vec4 normal;   // w: roughness
    vec4 color;    // w: pixels a radian at the middle of the picture
    vec4 picture;  // its width and height [pixels], pixels to one of its reflection
    vec4 blur;     // clear distance, scatter, distance of the sky: reflection_blur.glsl
} mirror;
