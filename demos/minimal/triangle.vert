#version 450

layout(push_constant) uniform Camera {
    mat4 clipFromWorld;
};

layout(location = 0) out vec3 color;

void main() {
    // A sail, whose foot is under water.
    const vec3 corners[] = {vec3(-1.5, -0.5, -3), vec3(1.5, -0.5, -3), vec3(0.5, 3.5, -3)};
    const vec3 colors[] = {vec3(0.9, 0.2, 0.05), vec3(0.9, 0.6, 0.1), vec3(0.9, 0.9, 0.7)};
    gl_Position = clipFromWorld * vec4(corners[gl_VertexIndex], 1);
    color = colors[gl_VertexIndex];
}
