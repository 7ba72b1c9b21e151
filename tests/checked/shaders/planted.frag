// Pixels of the left half end by discard, those of the right half by demote.
#version 450
#extension GL_EXT_demote_to_helper_invocation : require
layout(push_constant) uniform Constants {
    float number;   // 1, or beyond the range of int
};

int beforeDiscard() { return int(number); }
int beforeDemote() { return int(number); }
// Of a helper invocation, which notes nothing.
int afterDemote() { return int(number * 1e10); }

void main() {
    if (gl_FragCoord.x < 8.0) {
        beforeDiscard();
        discard;
    }
    beforeDemote();
    demote;
    afterDemote();
}
