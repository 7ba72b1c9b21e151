// Of directions in a body's axes what the host knows: the sky cube's and normals. Needs body.glsl and `tilted`.

vec3 inWorld(vec3 direction) {
    return tilted ? mat3(water.worldFromBody) * direction : direction;
}
