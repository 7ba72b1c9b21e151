// Derivatives that Vulkan leaves undefined, one a function: defined_derivatives.py names each of them.
#version 450

layout(location = 0) in vec2 at;
layout(location = 1) flat in int which;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2D image;
layout(set = 0, binding = 1) uniform Frame {
    int count;
};

bool goesOn = true;

vec4 underACondition() {
    vec4 sum = vec4(0.0);
    if (at.x > 0.5) sum += texture(image, at);
    return sum;
}

vec4 ofACondition() {
    return at.x > 0.5 ? vec4(dFdx(at), 0.0, 0.0) : vec4(0.0);
}

vec4 behindAReturn() {
    if (at.y > 0.5) return vec4(0.0);
    return texture(image, at);
}

vec4 inALoopThatSomeLeave() {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < count; ++i) {
        sum += texture(image, at + float(i));
        if (sum.x > at.x) break;
    }
    return sum;
}

vec4 byWhatIsRead() {
    float bound = textureLod(image, at, 0.0).x;
    vec4 sum = vec4(0.0);
    if (bound > 0.5) sum += vec4(fwidth(at), 0.0, 0.0);
    return sum;
}

vec4 byAndOr() {
    bool both = at.x > 0.5 && at.y > 0.5;
    if (both) return texture(image, at);
    return vec4(0.0);
}

vec4 switched() {
    switch (which) {
    case 0: return texture(image, at);
    default: return vec4(0.0);
    }
}

vec4 calledAlone(vec2 place) {
    return texture(image, place);
}

void stop() {
    if (at.x > 0.9) goesOn = false;
}

vec4 byAGlobal() {
    stop();
    return goesOn ? vec4(dFdy(at), 0.0, 0.0) : vec4(0.0);
}

void discards() {
    if (at.x < 0.1) discard;
}

void main() {
    discards();
    color = underACondition() + ofACondition() + behindAReturn() + inALoopThatSomeLeave() + byWhatIsRead() + byAndOr() + switched();
    color += byAGlobal();
    if (at.y < 0.2) color += calledAlone(at);
}
