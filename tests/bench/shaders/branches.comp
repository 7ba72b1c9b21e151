// The same work under a condition, in each form that a shader may have it in.
#version 450

layout(local_size_x = 64) in;
layout(constant_id = 0) const int form = 0;   // branches_bench.cpp: forms
layout(constant_id = 1) const int under = 0;  // of a hundred invocations, spread evenly, so many enter

layout(set = 0, binding = 0, std430) buffer Values {
    float values[];
};

const int parts = 4;

float part(float x, float sum) {
    for (int i = 0; i < 16; ++i) sum = sin(1.7 * sum + 0.3) + 0.1 * x;
    return sum;
}

float work(float x, float sum) {
    for (int i = 0; i < parts; ++i) sum = part(x, sum);
    return sum;
}

float headTested(float x, float sum, int rounds) {
    for (int i = 0; i < rounds; ++i) sum = part(x, sum);
    return sum;
}

float tailTested(float x, float sum, int rounds) {
    int i = 0;
    do {
        sum = part(x, sum);
    } while (++i < rounds);
    return sum;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    float x = values[index];   // whole, 0..99
    bool enters = x < float(under);
    int asked = x < 1e9 ? parts : 0;   // which no compiler can tell
    float sum = x;
    switch (form) {
    case 1: sum = work(x, sum); break;
    case 2:
        if (enters) sum = work(x, sum);
        break;
    case 3:
        for (bool once = enters; once; once = false) sum = work(x, sum);
        break;
    case 4:
        for (bool once = enters; once; once = false)
            for (bool again = x < 1e9; again; again = false) sum = work(x, sum);
        break;
    case 5: sum = headTested(x, sum, enters ? asked : 0); break;
    case 6:
        if (enters) sum = tailTested(x, sum, asked);
        break;
    case 7: sum = tailTested(x, sum, enters ? asked : 1); break;
    }
    values[index] = x + 1e-30 * sum;
}
