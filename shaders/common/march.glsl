// Follows a ray over the picture. Needs mirror.glsl and reflection_info.glsl.
//
// A point moving along a 3D line is a homogeneous screen point that moves linearly: clipping to the picture and to the
// depth range is exact, and between two screen points pixel, depth and 1/w are linear (McGuire and Mara 2014).

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2, std140) uniform MarchSettings {
    mat4 pixelFromRelative;
    vec4 forwardRow;    // distance ahead of the eye [m] is forwardRow.p / weightRow.p for p = (x, y, depth, 1)
    float thickness;    // [m]
    float longest;      // [m] of a ray
    float jitter;       // share of a stride
    int steps;
    bool hasNormals;
};

const int bisections = 6;
const int falseAlarms = 6;   // crossings that bisection may turn down before the ray is given up

struct SightLine {
    vec3 onPlane;         // where it meets the plane, relative to the eye
    vec3 direction;       // unit, away from the eye
    float towardsPlane;   // cosine to the plane's normal; not positive where the plane is not met
};

// Of all that shows at a pixel, whatever the projection.
SightLine sightLine(vec2 pixel) {
    vec4 p = relativeFromPixel * vec4(pixel, 0.5, 1.0);
    vec4 perDepth = relativeFromPixel[2];
    vec3 direction = normalize(depthSign * (p.xyz * perDepth.w - perDepth.xyz * p.w));
    vec3 from = p.xyz / p.w;
    float towards = -dot(plane.xyz, direction);
    return SightLine(from + direction * ((dot(plane.xyz, from) + plane.w) / towards), direction, towards);
}

// A stretch of a ray on the screen. All but the metres is linear in the share of its length.
struct Track {
    vec4 first;           // pixel, depth, 1/w
    vec4 last;
    vec2 ahead;           // of both ends: distance ahead of the eye, times 1/w
    vec2 range;           // [m] along the ray, empty unless the first is less than the second
    float halfPixel;      // as a share
    bool leavesPicture;   // at its end
};

// Narrows `range` to where a linear function is not negative.
void keepWhere(float atStart, float perMetre, inout vec2 range) {
    if (perMetre != 0.0) {
        float crossing = -atStart / perMetre;
        if (perMetre > 0.0) range.x = max(range.x, crossing);
        else range.y = min(range.y, crossing);
    } else if (atStart < 0.0) {
        range.y = -1.0;
    }
}

vec4 screenPoint(vec4 homogeneous) {
    return vec4(homogeneous.xyz, 1.0) / homogeneous.w;
}

Track trackOf(vec4 start, vec4 perMetre) {
    vec2 size = vec2(region.zw);
    vec2 picture = vec2(0.0, longest);
    keepWhere(start.x, perMetre.x, picture);
    keepWhere(start.y, perMetre.y, picture);
    keepWhere(size.x * start.w - start.x, size.x * perMetre.w - perMetre.x, picture);
    keepWhere(size.y * start.w - start.y, size.y * perMetre.w - perMetre.y, picture);
    // Depth runs from the one to the other, one of them the near plane.
    vec2 greatest = vec2(start.w - start.z, perMetre.w - perMetre.z);
    vec2 least = vec2(start.z, perMetre.z);
    vec2 near = depthSign > 0.0 ? greatest : least;
    vec2 far = depthSign > 0.0 ? least : greatest;
    keepWhere(near.x, near.y, picture);
    Track track;
    track.range = picture;
    keepWhere(far.x, far.y, track.range);
    track.leavesPicture = picture.y < longest && track.range.y >= picture.y;
    track.first = screenPoint(start + perMetre * track.range.x);
    track.last = screenPoint(start + perMetre * track.range.y);
    track.ahead = vec2(dot(forwardRow, vec4(track.first.xyz, 1.0)), dot(forwardRow, vec4(track.last.xyz, 1.0)));
    vec2 along = abs(track.last.xy - track.first.xy);
    track.halfPixel = min(0.5 / max(max(along.x, along.y), 1e-6), 1.0);
    return track;
}

vec3 trackPoint(Track track, float share) {
    return mix(track.first.xyz, track.last.xyz, share);
}

float trackMetres(Track track, float share) {
    vec2 weights = vec2(1.0 - share, share) * vec2(track.first.w, track.last.w);
    return dot(weights, track.range) / (weights.x + weights.y);
}

float trackAhead(Track track, float share) {
    float s = clamp(share, 0.0, 1.0);
    return mix(track.ahead.x, track.ahead.y, s) / mix(track.first.w, track.last.w, s);
}

float depthAt(vec2 pixel) {
    return texelFetch(sceneDepth, region.xy + ivec2(pixel), 0).r;
}

// The ray while it crosses a pixel, and how far it is behind what shows there [m], negative before it.
struct Probe {
    float ahead;   // in the pixel's middle [m]
    float least;
    float most;
};

const float nothing = 1e30;   // [m]

Probe probe(Track track, float share) {
    vec2 middle = floor(min(trackPoint(track, share).xy, vec2(region.zw) - 0.5)) + 0.5;
    vec4 seen = vec4(middle, depthAt(middle), 1.0);
    float enters = trackAhead(track, share - track.halfPixel);
    float leaves = trackAhead(track, share + track.halfPixel);
    // What lies on the plane or below is the mirror itself, or shines through it: no ray above can be behind that.
    bool counts = !isFar(seen.z) && !onOrBelowPlane(seen.xyz);
    float surface = counts ? dot(forwardRow, seen) / dot(weightRow, seen) : nothing;
    return Probe(0.5 * (enters + leaves), min(enters, leaves) - surface, max(enters, leaves) - surface);
}

// Where in or next to its pixel the ray is as far ahead as what shows there, if the same still shows there.
float settled(Track track, float share) {
    for (int i = 0; i < 2; ++i) {
        Probe here = probe(track, share);
        float middle = 0.5 * (here.least + here.most);
        float perHalf = trackAhead(track, share + track.halfPixel) - here.ahead;
        float halves = clamp(middle / (abs(perHalf) > 0.0 ? perHalf : 1.0), -1.0, 1.0);
        float moved = clamp(share - track.halfPixel * halves, 0.0, 1.0);
        Probe there = probe(track, moved);
        if (there.most >= 0.0 && there.least <= thickness) share = moved;
    }
    return share;
}

// Whether the far plane shows where the ray was left and where it would end.
bool reachesSky(Track track, vec4 perMetre) {
    if (!(perMetre.w > 0.0)) return false;
    vec2 end = perMetre.xy / perMetre.w;
    if (!insideRegion(end) || !insideRegion(track.last.xy)) return false;
    return isFar(depthAt(end)) && isFar(depthAt(track.last.xy));
}

struct March {
    float info;
    vec2 source;   // pixel of the hit
};

// From `from` along the unit `direction`, which leads away from the plane. `noise` is 0..1.
//
// One loop for strides and halvings: devices that mask branches instead of jumping them pay for one fetch a turn.
March marched(vec3 from, vec3 direction, float noise) {
    vec4 perMetre = pixelFromRelative * vec4(direction, 0.0);
    Track track = trackOf(pixelFromRelative * vec4(from, 1.0), perMetre);
    if (!(track.range.x < track.range.y)) return March(infoUnknown, vec2(0.0));

    float stride = max(2.0 * track.halfPixel, 1.0 / float(steps));
    float reached = 0.0;
    float next = stride * (1.0 - jitter * noise);
    Probe last = probe(track, 0.0);
    Probe strided = last;
    bool inFront = last.most < 0.0;
    bool hidden = false;
    bool hit = false;
    float low = 0.0;
    float high = 0.0;
    float least = 0.0;
    int halvings = 0;
    int turns = int(ceil(1.0 / stride)) + 1 + falseAlarms * bisections;
    for (int turn = 0; turn < turns && !hit; ++turn) {
        float share = halvings > 0 ? 0.5 * (low + high) : min(next, 1.0);
        Probe here = probe(track, share);
        if (halvings > 0) {
            bool crossed = here.most >= 0.0 && (inFront || here.least <= thickness);
            if (crossed) {
                high = share;
                least = here.least;
            } else {
                low = share;
                inFront = inFront || here.most < 0.0;
            }
            if (--halvings > 0) continue;
            hit = least <= thickness;
            here = strided;
        } else if (here.most >= 0.0 && min(here.least, last.ahead - here.ahead + here.least) <= thickness) {
            // The ray was behind by no more than that somewhere on the stride.
            low = reached;
            high = share;
            least = here.least;
            strided = here;
            halvings = bisections;
            continue;
        }
        hidden = hidden || here.most >= 0.0;
        inFront = here.most < 0.0;
        last = here;
        reached = min(next, 1.0);
        if (reached >= 1.0) break;
        next += stride;
    }
    if (hit) {
        float at = settled(track, high);
        return March(infoOfHit(trackMetres(track, at)), trackPoint(track, at).xy);
    }
    bool sky = !hidden && !track.leavesPicture && reachesSky(track, perMetre);
    return March(sky ? infoSky : infoUnknown, vec2(0.0));
}
