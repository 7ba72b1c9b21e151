// Memory that a workgroup shares as it should: parted_memory.py finds nothing here.
#version 450

layout(local_size_x = 64) in;
layout(constant_id = 0) const bool all = true;

layout(set = 0, binding = 0, std430) buffer Values {
    float values[];
};

shared float held[64];
shared float turned[2][64];

float besides() {
    return held[gl_LocalInvocationIndex ^ 1u];
}

float onceMore() {
    barrier();
    held[gl_LocalInvocationIndex] = 2.0;
    barrier();
    return besides();
}

// All go the same way.
float byEitherWay() {
    barrier();
    held[gl_LocalInvocationIndex] = 3.0;
    if (all) {
        barrier();
        return besides();
    }
    return 0.0;
}

float byTurns() {
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        turned[i & 1][gl_LocalInvocationIndex] = sum;
        barrier();
        sum += turned[i & 1][gl_LocalInvocationIndex ^ 1u];
    }
    return sum;
}

void main() {
    held[gl_LocalInvocationIndex] = 1.0;
    barrier();
    values[gl_GlobalInvocationID.x] = besides() + onceMore() + byEitherWay() + byTurns();
}
