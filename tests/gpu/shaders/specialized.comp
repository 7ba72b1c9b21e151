// What constants may leave out: specialized_test.cpp.
#version 450

layout(local_size_x = 1) in;
layout(constant_id = 0) const bool first = false;
layout(constant_id = 1) const bool second = false;
layout(constant_id = 2) const int kind = 0;
const bool either = first || second;
const bool isKindTwo = kind * 2 == 4;

layout(set = 0, binding = 0, std430) buffer Results {
    uint results[];
};
layout(set = 0, binding = 1, std430) readonly buffer First {
    uint ofFirst[];
};
layout(set = 0, binding = 2, std430) readonly buffer Second {
    uint ofSecond[];
};
layout(set = 0, binding = 3, std430) readonly buffer Either {
    uint ofEither[];
};
layout(set = 0, binding = 4) uniform sampler2D ofKindTwo;
layout(set = 0, binding = 5, std430) readonly buffer Looped {
    uint looped[];
};

bool firstIs(uint value) {
    return ofFirst[0] == value;
}

// Returns from within a loop that only some constants reach.
uint sumLooped() {
    if (!second) return 0u;
    uint sum = 0u;
    for (int i = 0; i < 8; ++i) {
        if (looped[i] == 7u) return sum;
        sum += looped[i];
    }
    return sum;
}

uint chosen(int way) {
    if (first) {
        switch (way) {
        case 0: return ofFirst[1];
        case 1: return ofFirst[2];
        default: break;
        }
    }
    return second ? ofSecond[0] : 3u;
}

void main() {
    uint sum = chosen(int(results[1]));
    bool met = first && firstIs(2u);
    if (met) sum += 1u;
    if (either && results[2] > 0u) sum += ofEither[0];
    if (isKindTwo) sum += uint(texelFetch(ofKindTwo, ivec2(0), 0).r);
    results[0] = sum + sumLooped();
}
