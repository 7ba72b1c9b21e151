// Derivatives that are defined: defined_derivatives.py finds nothing in them.
#version 450
#extension GL_EXT_demote_to_helper_invocation : require

layout(location = 0) in vec2 at;
layout(location = 0) out vec4 color;
layout(constant_id = 0) const bool sharp = true;
layout(set = 0, binding = 0) uniform sampler2D image;
layout(set = 0, binding = 1) uniform Frame {
    int count;
    vec4 places[4];
};

vec4 underWhatIsUniform() {
    vec4 sum = vec4(0.0);
    if (count > 2 && places[count].x > 0.0) sum += texture(image, at);
    return sharp ? sum + texture(image, 2.0 * at) : sum;
}

vec4 inALoop() {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < count; ++i) sum += texture(image, at + places[i].xy);
    return sum;
}

vec4 behindACondition() {
    vec4 sum = vec4(0.0);
    if (at.x > 0.5) sum += textureLod(image, at, 0.0);
    sum += textureGrad(image, at, sum.xy, sum.zw);
    return sum + texture(image, at);
}

vec4 behindADemotion() {
    if (at.x > 0.5) demote;
    return texture(image, at) + vec4(dFdx(at), dFdy(at));
}

void main() {
    color = underWhatIsUniform() + inALoop() + behindACondition() + behindADemotion();
}
