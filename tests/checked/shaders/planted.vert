// A triangle over the whole picture.
#version 450
layout(push_constant) uniform Constants {
    float number;   // 1, or beyond the range of int
};

int inVertex() { return int(number); }

void main() {
    inVertex();
    gl_Position = vec4(vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 4.0 - 1.0, 0.5, 1.0);
}
