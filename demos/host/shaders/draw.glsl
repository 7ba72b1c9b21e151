// One draw of a mesh: where it stands and what it is made of.
layout(push_constant) uniform Draw {
    vec4 eyeFromMesh[3];   // rows of the affine transform to eye-relative metres
    vec4 baseColor;
    vec4 emissive;         // w: alpha below which a masked surface is cut out, or what part of the mesh is dithered
    vec4 surface;          // metallic, roughness, shadow cascade, what of it casts a shadow
    vec4 specular;         // colour mirrored straight on, in place of metalness
    vec4 maps;             // scale of the normal map, strength of the occlusion map
} draw;

// What of a mesh casts a shadow: all, or what lies where the sun's rays are straight, or where they are bent.
const int castsAll = 0;
const int castsStraight = 1;
const int castsBent = 2;

// Alpha below which a pixel of what is half clear is left out: even over its neighbours, and of another pattern every 6 cm of
// depth and for each part of a mesh, for what lies behind one another (interleaved gradient noise, Jimenez 2014).
float ditherThreshold(vec2 pixel, float part, float depthM) {
    const float layer = mod(floor(16.0 * depthM) + part, 64.0);
    return fract(52.9829189 * fract(dot(pixel + 5.588238 * layer, vec2(0.06711056, 0.00583715))));
}

vec3 toEye(vec3 position) {
    const vec4 p = vec4(position, 1.0);
    return vec3(dot(draw.eyeFromMesh[0], p), dot(draw.eyeFromMesh[1], p), dot(draw.eyeFromMesh[2], p));
}
