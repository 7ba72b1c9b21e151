// Loops that no integer bounds, one a function: bounded_loops.py names each of them.
#version 450

layout(local_size_x = 64) in;
layout(constant_id = 0) const int specialised = 0;
layout(constant_id = 1) const uint last = 0u;

layout(set = 0, binding = 0, std430) buffer Values {
    float values[];
};
layout(set = 0, binding = 1, std430) buffer Links {
    int links[];
};
layout(push_constant) uniform Pushed {
    int count;
    uint bits;
};

struct Progress {
    float reached;
    int looks;
};

int everybodys = 0;

// Rounding may leave the sum as it was.
float byAFloat(float x) {
    while (x < 1.0) x += values[0];
    return x;
}

float byTwoFloats(float x) {
    float y = 0.0;
    do {
        x += values[0];
        y = max(x, y);
    } while (x < 1.0 && y < 2.0);
    return x;
}

int byData(int at) {
    while (true) {
        at = links[at];
        if (at < 0) break;
    }
    return at;
}

int byDataThatIsCompared(int at) {
    do {
        at = links[at];
    } while (at < count);
    return at;
}

int inOneBranch(float x) {
    int i = 0;
    do {
        if (values[i] > x) ++i;
    } while (i < count);
    return i;
}

int passedOver(float x) {
    int i = 0;
    while (i < count) {
        if (values[i] > x) continue;
        ++i;
    }
    return i;
}

int toAndFro(float x) {
    int i = 0;
    while (i < count) i += values[i] > x ? 1 : -1;
    return i;
}

int theWrongWay() {
    int i = 0;
    while (i >= 0) ++i;
    return i;
}

int downTheWrongWay() {
    int i = count;
    while (i < 100) --i;
    return i;
}

int byNothing() {
    int i = 0;
    while (i < count) i += specialised;
    return i;
}

int byWhatIsAsked(int each) {
    int i = 0;
    while (i < count) i += each;
    return i;
}

int withABoundThatMoves() {
    int i = 0;
    int end = 1;
    while (i < end) {
        ++i;
        ++end;
    }
    return i;
}

int withABoundThatIsRead() {
    int i = 0;
    while (i < links[0]) ++i;
    return i;
}

uint belowNothing() {
    uint sum = 0u;
    for (uint i = bits; i >= 0u; --i) sum += i;
    return sum;
}

uint overNothing() {
    uint i = bits;
    while (i > 1u) i -= 3u;
    return i;
}

int toTheLargest() {
    int i = 0;
    while (i <= 0x7fffffff) ++i;
    return i;
}

uint unequal() {
    uint i = 0u;
    while (i != last) i += 2u;
    return i;
}

uint downByAddition() {
    uint i = 1u;
    while (i < 100u) i += 0xffffffffu;
    return i;
}

int eitherWillDo(float x) {
    int i = 0;
    do {
        x *= values[i];
        ++i;
    } while (x < 1.0 || i < count);
    return i;
}

int orElseAFloat(float x) {
    int i = 0;
    for (;;) {
        if (i >= count && x > 1.0) break;
        x += values[0];
        ++i;
    }
    return i;
}

int broughtBack(float x) {
    int i = 0;
    while (i < count) {
        ++i;
        if (values[i] > x) i = 0;
    }
    return i;
}

void look(inout Progress at) {
    at.reached += values[at.looks];
    if (at.reached < 0.5) --at.looks;
}

float inACall() {
    Progress at = Progress(0.0, count);
    do {
        look(at);
    } while (at.looks > 0 && at.reached < 1.0);
    return at.reached;
}

void moveIt() {
    if (values[0] > 0.0) ++everybodys;
}

int byAGlobal() {
    while (everybodys < count) moveIt();
    return everybodys;
}

// The inner loop, which is bounded, may have no round.
int byTheInnerOne(float x) {
    int i = 0;
    do {
        while (i < count && values[i] > x) ++i;
    } while (i < count);
    return i;
}

int halved(int most) {
    int low = 0;
    int high = most;
    while (low < high) {
        int middle = (low + high) / 2;
        if (links[middle] > 0) low = middle;
        else high = middle;
    }
    return low;
}

void main() {
    float x = values[gl_GlobalInvocationID.x];
    x += byAFloat(x) + byTwoFloats(x) + inACall();
    int i = byData(0) + byDataThatIsCompared(0) + inOneBranch(x) + passedOver(x) + toAndFro(x) + theWrongWay() + downTheWrongWay();
    i += byNothing() + byWhatIsAsked(i) + withABoundThatMoves() + withABoundThatIsRead() + toTheLargest() + eitherWillDo(x);
    i += orElseAFloat(x) + broughtBack(x) + byAGlobal() + byTheInnerOne(x) + halved(i);
    uint u = belowNothing() + overNothing() + unequal() + downByAddition();
    values[gl_GlobalInvocationID.x] = x + float(i) + float(u);
}
