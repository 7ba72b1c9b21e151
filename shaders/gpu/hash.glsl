// Bits without order, of any.
#ifndef HASH_GLSL
#define HASH_GLSL

uint scrambled(uint bits) {
    bits = (bits ^ (bits >> 16)) * 0x7feb352du;
    bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
    return bits ^ (bits >> 16);
}

// 0 <= x < 1, evenly.
float shareOf(uint scrambled) {
    return float(scrambled >> 8) * 5.9604645e-8;
}

// The next of a row of such shares.
float nextShare(inout uint bits) {
    bits = scrambled(bits + 0x9e3779b9u);
    return shareOf(bits);
}

#endif
