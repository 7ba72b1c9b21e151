// Writes a word where its buffer has none.
#version 450
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std430) buffer Words {
    uint words[];
};

void main() {
    words[1000000 + gl_GlobalInvocationID.x] = 1u;
}
