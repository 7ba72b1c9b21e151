// Blocks that std140 lays out as C++ does.
#version 450

layout(local_size_x = 1) in;

struct Inner {
    mat3x4 columns;
    vec2 first;
    vec2 after;
};

layout(set = 0, binding = 0, std140) uniform Packed {
    mat4 whole;
    vec3 three;
    float beside;
    Inner inner[2];
    vec4 rows[3];
    ivec2 two;
    uint pad0, pad1;
} packed_;

layout(set = 0, binding = 1, std430) buffer Values {
    vec4 value;   // no uniform: it may end anywhere
    float last;
};

void main() {
    value = packed_.whole * packed_.rows[2] * packed_.inner[1].first.x * packed_.beside * float(packed_.two.x);
    last = packed_.three.x;
}
