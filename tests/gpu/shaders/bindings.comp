// Binds one resource of each kind, by numbers with gaps between them.
#version 450

layout(local_size_x = 1) in;

layout(set = 0, binding = 1, std140) uniform Size {
    uint size;
};
layout(set = 0, binding = 7, std430) writeonly buffer Words {
    float words[];
};
layout(set = 0, binding = 3) uniform sampler2D sampled;
layout(set = 0, binding = 4, r32f) uniform readonly image2D stored;

float sampledAt(vec2 at) {
    return textureLod(sampled, at, 0.0).x;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < size) words[i] = imageLoad(stored, ivec2(i, 0)).x + sampledAt(vec2(0.5));
}
