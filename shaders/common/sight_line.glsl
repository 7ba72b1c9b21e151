// What shows at a pixel lies on a line through it, whatever the projection. Needs mirror.glsl.

struct SightLine {
    vec3 onPlane;         // where it meets the plane, relative to the eye
    vec3 direction;       // unit, away from the eye
    float towardsPlane;   // cosine to the plane's normal; not positive where the plane is not met
};

SightLine sightLine(mat4 fromPixel, vec2 pixel) {
    vec4 p = fromPixel * vec4(pixel, 0.5, 1.0);
    vec4 perDepth = fromPixel[2];
    vec3 direction = normalize(depthSign * (p.xyz * perDepth.w - perDepth.xyz * p.w));
    vec3 from = p.xyz / p.w;
    float towards = -dot(plane.xyz, direction);
    return SightLine(from + direction * ((dot(plane.xyz, from) + plane.w) / towards), direction, towards);
}
