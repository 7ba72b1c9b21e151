// What hangs over a mirror, a pier's deck for one, as the mirror shows it from below: the eye sees its top and its edge, and the
// ray that meets its underside leaves by its hidden back. Needs hits.glsl, keys.glsl and look_before.glsl.

const float leastHeight = 3.0;   // of its edge above the mirror [pixels]: what floats hangs nowhere
const float levelWithin = 0.15;  // of its thickness
const float steepestTop = 0.2;   // its rise for each metre of the way between two pixels
const int sideLooks = 9;         // each twice as far aside
const int mostTries = 16;        // at a level top, each twice as far off: more than any picture holds

// What left a key nearer than what shows here, nearer to the eye on the mirror: on the screen, it hides the ray before that
// comes to what shows here.
ivec2 roofBefore(vec2 q, vec2 away, uint here) {
    LineKey roof = LineKey(noKey, ivec2(0));
    for (int i = 0; i < 2 * int(mirror.roofLooks); ++i) {
        ivec2 cell = cellBefore(q, away, i);
        uint key = keyAt(cell);
        bool found = roof.key == noKey && key > here;
        roof.key = found ? key : roof.key;
        roof.cell = found ? cell : roof.cell;
    }
    return sourceOf(roof);
}

float heightOf(vec4 point) {
    return dot(mirror.heightRow, point) / dot(mirror.weightRow, point);
}

// What is seen at a point, as a screen point.
vec4 seenPoint(vec2 point) {
    return vec4(point, depthAt(texelAt(point, mirror.region.zw - 1)), 1.0);
}

// The mirrored depth at which a ray is as high.
float depthAtHeight(vec2 q, float height) {
    vec4 start = vec4(q, 0.0, 1.0);
    return -(dot(mirror.heightRow, start) + height * dot(mirror.weightRow, start)) / (mirror.heightRow.z + height * mirror.weightRow.z);
}

float metresPerPixel(vec4 point) {
    vec4 p = mirror.relativeFromPixel * point;
    vec4 beside = p + mirror.relativeFromPixel[0];
    return distance(p.xyz / p.w, beside.xyz / beside.w);
}

// Whether a top is level there, as a rail or a wall is not.
bool isLevel(vec2 point, vec2 away, float edgeHeight) {
    vec4 here = seenPoint(point);
    vec4 before = seenPoint(clamp(point - away, vec2(0.5), vec2(mirror.region.zw) - 0.5));
    if (isFar(here.z) || isFar(before.z)) return false;
    float top = heightOf(here);
    float rise = abs(heightOf(before) - top);
    vec3 way = unprojected(here.xyz) - unprojected(before.xyz);
    return rise < levelWithin * (top - edgeHeight) && rise < steepestTop * length(way);
}

// A level point of the top: the first that is tried from where the ray is hidden on, or where that ends, since posts may
// stand on it.
bool levelPoint(vec2 from, vec2 end, vec2 away, float edgeHeight, out vec2 point) {
    float most = farthest(end - from);
    bool level, last;
    int i = 0;
    do {
        float pixels = float((1 << i) - 1);
        last = !(pixels <= most) || i == mostTries;
        point = last ? end : from + pixels * away;
        level = isLevel(point, away, edgeHeight);
    } while (++i <= mostTries && !level && !last);
    return level;
}

// Whether a top of that height is seen, to one side along the horizon, past what stands on it and hides a point of it: that
// is seen to be higher all the way.
bool topShowsBeside(vec2 point, vec2 aside, float top, float within, out vec2 beside) {
    float height;
    int i = 1;
    do {
        beside = point + float(1 << i) * aside;
        vec4 seen = seenPoint(beside);
        height = insideRegion(beside) && !isFar(seen.z) ? heightOf(seen) : -1.0;
    } while (++i < sideLooks && height > top + within);
    return abs(height - top) <= within;
}

// Where the ray is as high as the edge that it goes in under, it meets an underside, provided that straight above a level top
// is seen, as high as the one by which the ray gets out of sight, or what stands on that.
Hit hitUnderTop(vec2 q, ScreenRay ray, float height, float depth, float top) {
    vec4 mirrored = vec4(q, depth - mirror.infinityDepth, 1.0);
    vec4 above = mix(mirrored, ray.origin + depth * ray.along, 0.5 * (top / height + 1.0));
    vec2 source = above.xy / above.w;
    bool shows = top > height && above.w > 0.0 && insideRegion(source);
    vec2 middle = floor(shows ? source : vec2(0.0)) + 0.5;
    vec4 seen = seenPoint(middle);
    float within = levelWithin * (top - height);
    bool level = !isFar(seen.z) && abs(heightOf(seen) - top) < within;
    if (shows && !isFar(seen.z) && heightOf(seen) > top + within) {
        vec2 aside = vec2(-mirror.heightRow.y, mirror.heightRow.x) / max(length(mirror.heightRow.xy), 1e-30);
        vec2 beside;
        level = topShowsBeside(middle, aside, top, within, beside) || topShowsBeside(middle, -aside, top, within, beside);
        middle = level ? beside : middle;
    }
    return Hit(shows && level, false, middle, 0.0, depth);
}

Hit underRoof(vec2 q, ScreenRay ray, Hit shown) {
    vec2 away = awayFrom(q);
    ivec2 roof = roofBefore(q, away, shown.valid ? keyFromDepth(shown.depth) : noKey);
    vec2 from = vec2(roof) + 0.5;
    bool first = !shown.valid || dot(shown.source - from, away) > 2.0;
    float mostPixels = float(firstLook << mirror.roofLooks);
    Hit hit = noHit;
    if (roof != nowhere && first) {
        Entry entry = entryBefore(ray, q, from, mostPixels);
        if (entry.between == noGuesses) return noHit;
        vec4 edge = vec4(entry.hidden, depthAt(entry.between.other), 1.0);
        if (isFar(edge.z)) return noHit;
        float height = heightOf(edge);
        float depth = depthAtHeight(q, height);
        bool above = height > leastHeight * metresPerPixel(edge);
        bool before = !shown.valid || mirror.depthSign * (depth - shown.depth) > 0.0;
        if (above && before) {
            vec2 end = exitAfter(ray, from, away, mostPixels);
            vec2 on;
            bool level = levelPoint(from, end, away, height, on);
            // The key may be that of what stands on the top, which shows before its foot.
            if (!level && (!shown.valid || shown.front)) level = levelPoint(from, entry.hidden, -away, height, on);
            if (level) hit = hitUnderTop(q, ray, height, depth, heightOf(seenPoint(on)));
        }
    }
    return hit;
}
