// Memory that a workgroup shares and that no barrier parts: parted_memory.py finds fault with each function.
#version 450

layout(local_size_x = 64) in;
layout(constant_id = 0) const bool waits = true;

layout(set = 0, binding = 0, std430) buffer Values {
    float values[];
};

shared float held[64];
shared float others[64];
shared float turned[2][64];

float besides() {
    return held[gl_LocalInvocationIndex ^ 1u];
}

void writtenTooEarly() {
    float sum = others[gl_LocalInvocationIndex ^ 1u];
    others[gl_LocalInvocationIndex] = sum;
}

// By one path alone.
float waitedForAtTimes() {
    held[gl_LocalInvocationIndex] = 1.0;
    if (waits) barrier();
    return held[gl_LocalInvocationIndex ^ 1u];
}

// In the next round.
float roundByRound() {
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        others[gl_LocalInvocationIndex] = sum;
        barrier();
        sum += others[gl_LocalInvocationIndex ^ 1u];
    }
    return sum;
}

float ofTwo() {
    turned[0][gl_LocalInvocationIndex] = 1.0;
    return turned[0][gl_LocalInvocationIndex ^ 1u];
}

void main() {
    held[gl_LocalInvocationIndex] = 1.0;
    float sum = besides();
    barrier();
    writtenTooEarly();
    sum += waitedForAtTimes();
    barrier();
    values[gl_GlobalInvocationID.x] = sum + roundByRound() + ofTwo();
}
