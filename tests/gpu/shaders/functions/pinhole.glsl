// In place of a body's: an eye four metres over the water that looks along -z, in pictures of 200 x 200 pixels.
#define BODY_GLSL
const float eyeHeight = 4.0;
ivec2 regionSize() {
    return ivec2(200);
}
bool inRegion(vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, vec2(regionSize())));
}
vec2 heldInRegion(vec2 pixel) {
    return clamp(pixel, vec2(0.5), vec2(199.5));
}
float calmLevel() {
    return -eyeHeight;
}
vec3 calmNormal() {
    return vec3(0.0, 1.0, 0.0);
}
bool sightIsParallel() {
    return false;
}
float seenFromAnEye() {
    return 1.0;
}
mat4 pixelFromRelative() {
    return mat4(100.0, 0.0, 0.0, 0.0, 0.0, -100.0, 0.0, 0.0, -100.0, -100.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0);
}
mat4 pixelRows() {
    return transpose(pixelFromRelative());
}
vec4 homogeneousPixel(vec4 position) {
    return pixelFromRelative() * position;
}
vec4 homogeneousPixel(vec3 position) {
    return homogeneousPixel(vec4(position, 1.0));
}
vec4 homogeneousPerMetre(vec3 direction) {
    return pixelFromRelative() * vec4(direction, 0.0);
}
vec4 pixelOf(vec3 position) {
    vec4 p = homogeneousPixel(position);
    return vec4(p.xyz / p.w, p.w);
}
float pixelWidth(vec3 at) {
    return -at.z / 100.0;
}
// So far ahead as the depth says.
vec3 pointAt(vec2 pixel, float depth) {
    return depth * vec3(0.01 * pixel.x - 1.0, 1.0 - 0.01 * pixel.y, -1.0);
}
vec3 sightTo(vec3 at) {
    return at;
}
vec3 sightStart(vec3 at) {
    return vec3(0.0);
}
float distanceTo(vec3 at) {
    return length(at);
}
