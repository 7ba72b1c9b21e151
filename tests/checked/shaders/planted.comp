// Each function does one thing that Vulkan leaves open, or, where `violate` is 0, what is just short of it.
#version 450
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std430) buffer Words {
    uint violate;
    float sum;
    float four[4];
    float rest[];   // four more
};
layout(set = 0, binding = 1) uniform sampler2D sampled;   // 4 x 4, two levels
layout(set = 0, binding = 2, r32f) uniform image2D stored;   // 4 x 4
layout(set = 0, binding = 3, r32ui) uniform uimage2D counted;   // 4 x 4

#define nan uintBitsToFloat(0x7fc00000u)
#define infinity uintBitsToFloat(0x7f800000u)
const float pi = 3.14159265;

float either(float good, float bad) {
    return uintBitsToFloat(violate != 0u ? floatBitsToUint(bad) : floatBitsToUint(good));
}

int either(int good, int bad) {
    return violate != 0u ? bad : good;
}

// What is used up has to be read, or a driver leaves out what made it.
void use(float value) {
    sum = value;
}

void intOfMuch() { use(float(int(either(2147483520.0, 2147483648.0)))); }
void intOfLittle() { use(float(int(either(-2147483648.0, -2147483904.0)))); }
void intOfNan() { use(float(ivec2(vec2(1.0, either(0.0, nan))).y)); }
void uintOfMuch() { use(float(uint(either(4294967040.0, 4294967296.0)))); }
void uintOfLittle() { use(float(uint(either(-0.5, -1.0)))); }
void uintOfNan() { use(float(uint(either(0.0, -nan)))); }

void minOfNan() { use(min(vec2(1.0), vec2(0.0, either(infinity, nan))).y); }
void maxOfNan() { use(max(either(-infinity, nan), 1.0)); }
void stepOfNan() { use(step(0.5, either(infinity, nan))); }
void clampOfNan() { use(clamp(either(infinity, nan), 0.0, 1.0)); }
void clampTurned() { use(clamp(0.5, 0.0, either(0.0, -1e-6))); }
void clampTurnedInts() { use(float(clamp(5, 0, either(0, -1)))); }
void smoothstepOfNan() { use(smoothstep(0.0, 1.0, either(infinity, nan))); }
void smoothstepOfNothing() { use(smoothstep(0.0, either(1e-6, 0.0), 0.5)); }
void comparesNan() { use(either(infinity, nan) > 1.0 ? 1.0 : 0.0); }

void sinOfMuch() { use(sin(either(pi, 3.142))); }
void cosOfMuch() { use(cos(either(-pi, -3.142))); }
void tanOfMuch() { use(tan(either(1.0, infinity))); }
void asinOfMuch() { use(asin(either(1.0, 1.0000001))); }
void acosOfMuch() { use(acos(either(-1.0, -1.0000001))); }
void atanOfZeros() { use(atan(either(1e-6, -0.0), 0.0)); }
void powOfNegative() { use(pow(either(0.0, -1e-6), 2.0)); }
void powOfZeros() { use(pow(0.0, either(1e-6, 0.0))); }
void expOfMuch() { use(exp(either(88.7, 88.8))); }
void exp2OfMuch() { use(exp2(either(127.9, 128.0))); }
void logOfZero() { use(log(either(1e-6, 0.0))); }
void log2OfNegative() { use(log2(either(1e-6, -1e-6))); }
void sqrtOfNegative() { use(sqrt(either(-0.0, -1e-6))); }
void inversesqrtOfZero() { use(inversesqrt(either(1e-6, 0.0))); }
void normalizeOfZero() { use(normalize(vec3(0.0, either(1e-6, 0.0), -0.0)).y); }
void modOfZero() { use(mod(2.0, either(1e-6, 0.0))); }

void dividesByZero() { use(float(7 / either(1, 0))); }
void remainderOfNegative() { use(float(either(7, -7) % 4)); }
void shiftsByAll() { use(float(1 << either(31, 32))); }
void fieldBeyond() { use(float(bitfieldExtract(7u, 16, either(16, 17)))); }

void indexOfArray() { use(four[either(3, 4)]); }
void indexBeforeArray() { use(four[either(0, -1)]); }
void indexOfRest() { use(rest[either(3, 4)]); }
void indexOfVector() { use(vec3(sum)[either(2, 3)]); }
void indexOfMatrix() { use(mat2(sum)[either(1, 2)].x); }

void fetchesBeyond() { use(texelFetch(sampled, ivec2(0, either(3, 4)), 0).x); }
void fetchesBefore() { use(texelFetch(sampled, ivec2(either(0, -1), 0), 0).x); }
void fetchesBeyondMip() { use(texelFetch(sampled, ivec2(either(1, 2)), 1).x); }
void fetchesNoMip() { use(texelFetch(sampled, ivec2(0), either(1, 2)).x); }
void fetchesOffset() { use(texelFetchOffset(sampled, ivec2(either(2, 3), 0), 0, ivec2(1, 0)).x); }
void loadsBeyond() { use(imageLoad(stored, ivec2(either(3, 4), 0)).x); }
void storesBeyond() { imageStore(stored, ivec2(either(3, 4), 0), vec4(1.0)); }
void countsBeyond() { imageAtomicAdd(counted, ivec2(either(3, 4), 0), 1u); }
void samplesAtNan() { use(textureLod(sampled, vec2(either(2.0, nan)), 0.0).x); }
void gathersAtInfinity() { use(textureGather(sampled, vec2(0.5, either(2.0, infinity))).x); }

void goesRound() {
    const int rounds = either(19000, 21000);
    for (int i = 0; i < rounds; ++i) use(sum + 1.0);
}

void main() {
    intOfMuch();
    intOfLittle();
    intOfNan();
    uintOfMuch();
    uintOfLittle();
    uintOfNan();
    minOfNan();
    maxOfNan();
    stepOfNan();
    clampOfNan();
    clampTurned();
    clampTurnedInts();
    smoothstepOfNan();
    smoothstepOfNothing();
    comparesNan();
    sinOfMuch();
    cosOfMuch();
    tanOfMuch();
    asinOfMuch();
    acosOfMuch();
    atanOfZeros();
    powOfNegative();
    powOfZeros();
    expOfMuch();
    exp2OfMuch();
    logOfZero();
    log2OfNegative();
    sqrtOfNegative();
    inversesqrtOfZero();
    normalizeOfZero();
    modOfZero();
    dividesByZero();
    remainderOfNegative();
    shiftsByAll();
    fieldBeyond();
    indexOfArray();
    indexBeforeArray();
    indexOfRest();
    indexOfVector();
    indexOfMatrix();
    fetchesBeyond();
    fetchesBefore();
    fetchesBeyondMip();
    fetchesNoMip();
    fetchesOffset();
    loadsBeyond();
    storesBeyond();
    countsBeyond();
    samplesAtNan();
    gathersAtInfinity();
    goesRound();
}
