// Each member but the first lies where C++ does not put it.
#version 450

layout(local_size_x = 1) in;

struct Inner {
    vec2 first;
    float after;
};

layout(set = 0, binding = 0, std140) uniform Holes {
    vec3 first;
    vec4 begins;
    mat3 columns;
    Inner ends[2];
    float elements[2];
} holes;

layout(set = 0, binding = 1, std430) buffer Values {
    vec4 value;
};

void main() {
    value = holes.begins + holes.ends[1].after * holes.elements[1] * vec4(holes.columns * holes.first, 1.0);
}
