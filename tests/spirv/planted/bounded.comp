// Loops that an integer bounds, as shaders write them: bounded_loops.py finds nothing in them.
#version 450

layout(local_size_x = 64) in;
layout(constant_id = 0) const int rows = 4;

layout(set = 0, binding = 0, std430) buffer Values {
    float values[];
};
layout(set = 0, binding = 1, std140) uniform Frame {
    vec4 limits;
    ivec4 region;
};
layout(push_constant) uniform Pushed {
    int count;
    uint bits;
};

struct Scene {
    float near;
};

struct Progress {
    float reached;
    bool hidden;
    int looks;
    Scene scene;
};

int looksLeft = 0;

float counted() {
    float sum = 0.0;
    for (int i = 0; i < count; ++i) sum += values[i];
    return sum;
}

float withFloats(float x) {
    int i = 0;
    do {
        x *= values[i];
    } while (++i < rows && x < 1.0);
    return x;
}

float floatsFirst(float x) {
    int i = 0;
    do {
        x *= values[i];
    } while (x < 1.0 && x > 0.1 && ++i < rows);
    return x;
}

float notFound(float x) {
    int i = 0;
    bool found;
    do {
        found = all(greaterThan(limits.xy, vec2(x))) && all(lessThan(limits.zw, vec2(x)));
    } while (!found && ++i < int(limits.x));
    return found ? x : 0.0;
}

float byBreaks(float x) {
    int i = 0;
    for (;;) {
        if (i++ >= count) break;
        if (values[i] > x) continue;
        x += 1.0;
        if (x > 10.0) return x;
    }
    return x;
}

float byOneOrThree(float x) {
    int i = count;
    while (i > 0) {
        i -= values[i] > x ? 3 : 1;
        x += 1.0;
    }
    return x;
}

float inBranches(float x) {
    int i = 0;
    do {
        if (values[i] > x) {
            i += 2;
            x += 0.5;
        } else {
            ++i;
        }
    } while (i <= region.y);
    return x;
}

float byUnsigned() {
    float sum = 0.0;
    for (uint i = bits; i > 0u; --i) sum += values[i];
    return sum;
}

float upToWhatIsLess(int last) {
    float sum = 0.0;
    int i = 0;
    do {
        last = int(values[i]);
        sum += values[i];
        ++i;
    } while (i < min(last, rows));
    return sum;
}

float ofAVector(ivec2 at) {
    ivec2 end = min(at + (1 << rows), region.zw);
    float sum = 0.0;
    do {
        int x = at.x;
        do {
            sum += values[x];
            x += 2;
        } while (x < end.x);
        at.y += 2;
    } while (at.y < end.y);
    return sum;
}

void look(inout Progress at) {
    --at.looks;
    at.reached += values[at.looks];
    if (at.reached > 0.5) {
        at.hidden = true;
        at.looks -= 2;
        return;
    }
    at.scene.near = 1.0;
}

float inACall(Scene scene) {
    Progress at = Progress(0.0, false, count, scene);
    do {
        look(at);
    } while (at.looks > 0 && at.reached < 1.0);
    return at.reached;
}

void takeLook() {
    --looksLeft;
}

float byAGlobal() {
    float sum = 0.0;
    looksLeft = count;
    while (looksLeft > 0) {
        takeLook();
        sum += values[looksLeft];
    }
    return sum;
}

// Each round of the outer loop has one of the inner.
float byTheInnerOne(float x) {
    int i = 0;
    do {
        do {
            x += values[i];
        } while (++i < count && x < 1.0);
        x -= 1.0;
    } while (i < count);
    return x;
}

float nested() {
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        int known = i;
        while (known < count && values[known] < 0.0) ++known;
        switch (known) {
        case 0: continue;
        case 1: sum += 1.0; break;
        default: sum += values[known];
        }
    }
    return sum;
}

int next(int i) {
    return i + 1;
}

float byAResult() {
    float sum = 0.0;
    for (int i = 0; i < count; i = next(i)) sum += values[i];
    return sum;
}

void main() {
    float x = values[gl_GlobalInvocationID.x];
    x += counted() + withFloats(x) + floatsFirst(x) + notFound(x) + byBreaks(x) + byOneOrThree(x) + inBranches(x) + byUnsigned();
    x += upToWhatIsLess(count) + ofAVector(region.xy) + inACall(Scene(x)) + byAGlobal() + byTheInnerOne(x) + nested() + byAResult();
    values[gl_GlobalInvocationID.x] = x;
}
