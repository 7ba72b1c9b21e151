// One triangle over the whole view.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "one_view.glsl"

void main() {
    if (isOtherView()) {
        gl_Position = outOfSight;
        return;
    }
    gl_Position = vec4(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
