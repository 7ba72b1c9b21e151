// A box by two of its corners, without vertex buffers; counter-clockwise as seen from outside.
#version 450

layout(push_constant) uniform Box {
    mat4 clipFromWorld;
    vec4 low;
    vec4 high;
};
layout(location = 0) centroid out vec3 color;

const vec2 corners[] = {vec2(0.0), vec2(1.0, 0.0), vec2(1.0), vec2(0.0), vec2(1.0), vec2(0.0, 1.0)};

void main() {
    int face = gl_VertexIndex / 6, axis = face >> 1;
    bool upper = (face & 1) == 1;
    vec2 corner = corners[gl_VertexIndex % 6];
    vec2 across = upper ? corner : corner.yx;
    vec3 at = vec3(0.0);
    at[axis] = upper ? 1.0 : 0.0;
    at[(axis + 1) % 3] = across.x;
    at[(axis + 2) % 3] = across.y;
    color = mix(vec3(0.2), vec3(0.8), at);
    gl_Position = clipFromWorld * vec4(mix(low.xyz, high.xyz, at), 1.0);
}
