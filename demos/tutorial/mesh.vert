#version 450

layout(push_constant) uniform Push {
    mat4 clipFromWorld;
    vec4 toSun, sunLight, skyLight;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
layout(location = 0) out vec3 outLight;

void main() {
    gl_Position = clipFromWorld * vec4(position, 1);
    outLight = color * (sunLight.rgb * max(dot(normal, toSun.xyz), 0) + skyLight.rgb * (0.5 + 0.5 * normal.y));
}
