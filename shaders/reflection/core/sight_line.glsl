// What shows at a pixel lies on a line through it, whatever the projection.
#ifndef SIGHT_LINE_GLSL
#define SIGHT_LINE_GLSL

struct SightLine {
    vec3 onPlane;         // where it meets the plane, relative to the eye
    vec3 direction;       // unit, away from the eye
    float towardsPlane;   // cosine to the plane's normal; not positive where the plane is not met
};

// Away from the eye, of any length: linear in the pixels. `p` is fromPixel's of the pixel, at whatever depth; `depthSign` is +1
// where nearer is greater.
vec3 alongSight(mat4 fromPixel, vec4 p, float depthSign) {
    vec4 perDepth = fromPixel[2];
    return depthSign * (p.xyz * perDepth.w - perDepth.xyz * p.w);
}

SightLine sightLine(mat4 fromPixel, vec2 pixel, vec4 plane, float depthSign) {
    vec4 p = fromPixel * vec4(pixel, 0.5, 1.0);
    vec3 direction = normalize(alongSight(fromPixel, p, depthSign));
    vec3 from = p.xyz / p.w;
    float towards = -dot(plane.xyz, direction);
    return SightLine(from + direction * ((dot(plane.xyz, from) + plane.w) / towards), direction, towards);
}

#endif
