// Arithmetic that Vulkan leaves open, one kind a function: what hostile_arithmetic.py makes of it hostile_test.py counts.
#version 450

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std430) buffer Values {
    vec4 values[];
};

vec4 fused(vec4 a, float b, vec4 c) {
    vec4 product = a * b;
    return product + c;
}

vec4 fusedTwice(vec4 a, vec4 b, vec4 c) {
    return (c - a * b) - (a * c - b);
}

vec4 kept(vec4 a, vec4 b, vec4 c) {
    precise vec4 sum = a * b + c;
    return sum;
}

float dotted(vec4 a, vec4 b) {
    return dot(a, b);
}

vec3 least(vec3 a, vec3 b) {
    return min(a, b);
}

float most(float a, float b) {
    return max(a, b);
}

vec4 held(vec4 a) {
    return clamp(a, 0.0, 1.0);
}

ivec2 whole(vec2 a) {
    return ivec2(a);
}

uint wholeOrMore(float a) {
    return uint(a);
}

void main() {
    vec4 a = values[0], b = values[1], c = values[2];
    values[3] = fused(a, b.x, c);
    values[4] = fusedTwice(a, b, c);
    values[5] = kept(a, b, c);
    values[6] = vec4(dotted(a, b), most(a.x, b.x), float(wholeOrMore(a.y)), 0.0);
    values[7] = vec4(least(a.xyz, b.xyz), 0.0);
    values[8] = held(a);
    values[9] = vec4(whole(a.xy), 0.0, 0.0);
}
