// One draw of a mesh: where it stands and what it is made of.
layout(push_constant) uniform Draw {
    vec4 eyeFromMesh[3];   // rows of the affine transform to eye-relative metres
    vec4 baseColor;
    vec4 emissive;         // w: alpha below which a masked surface is cut out
    vec4 surface;          // metallic, roughness, shadow cascade, what of it casts a shadow
} draw;

// What of a mesh casts a shadow: all, or what lies where the sun's rays are straight, or where they are bent.
const int castsAll = 0;
const int castsStraight = 1;
const int castsBent = 2;

vec3 toEye(vec3 position) {
    const vec4 p = vec4(position, 1.0);
    return vec3(dot(draw.eyeFromMesh[0], p), dot(draw.eyeFromMesh[1], p), dot(draw.eyeFromMesh[2], p));
}
