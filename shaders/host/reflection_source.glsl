// Where a flat mirror takes what it shows from.

struct Ray {
    vec3 from;        // relative to the eye, at which it is where there is one
    vec3 direction;   // unit
};

// The point that a lookup along one ray shows of a texel whose centre lies on another: as far away as the mirror image
// in that texel, mirrored in the plane. Positions are in metres from the eye; `info` holds a hit; the plane is that of
// the points p with dot(normal, p) + height = 0, so that `height` is the eye's above it, negative for an eye below.
vec3 mirroredPoint(Ray throughPixel, Ray throughTexel, float info, vec3 normal, float height) {
    float nearing = -dot(throughTexel.direction, normal);
    // Where lines of sight are parallel, they may begin behind the mirror: then it is less than nothing.
    float toMirror = (height + dot(throughTexel.from, normal)) / (abs(nearing) > 1e-6 ? nearing : 1e-6);
    vec3 image = throughPixel.from + throughPixel.direction * (toMirror + info);
    return image - 2.0 * (dot(image, normal) + height) * normal;
}
