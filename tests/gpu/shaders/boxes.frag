#version 450

layout(location = 0) centroid in vec3 color;
layout(location = 0) out vec4 drawn;

void main() {
    drawn = vec4(color, 0.25); // an alpha that means nothing
}
