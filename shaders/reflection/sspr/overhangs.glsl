// What hangs over a mirror, a pier's deck for one, as the mirror shows it from below: the eye sees its top and its edge, and the
// ray that meets its underside leaves by its hidden back.

const float leastHeight = 3.0;   // of its edge above the mirror [pixels]: what floats hangs nowhere
const float levelWithin = 0.15;  // of its thickness
const float steepestTop = 0.2;   // its rise for each metre of the way between two pixels
const int sideLooks = 9;         // each twice as far aside
const int mostTries = 16;        // at a level top, each twice as far off: more than any picture holds

// What left a key nearer than what shows here, nearer to the eye on the mirror: on the screen, it hides the ray before that
// comes to what shows here.
ivec2 overhangBefore(const MirrorBlock mirror, vec2 q, vec2 away, uint here) {
    LineKey overhang = LineKey(noKey, ivec2(0));
    for (int i = 0; i < 2 * int(mirror.overhangSamples); ++i) {
        ivec2 cell = cellBefore(mirror, q, away, i);
        uint key = keyAt(cell);
        bool found = overhang.key == noKey && key > here;
        overhang.key = found ? key : overhang.key;
        overhang.cell = found ? cell : overhang.cell;
    }
    return sourceOf(mirror, overhang);
}

// What is seen at a point, as a screen point.
vec4 seenPoint(const MirrorBlock mirror, vec2 point) {
    return vec4(point, depthAt(mirror, regionPixel(mirror, point)), 1.0);
}

// The mirrored depth at which a ray is as high.
float depthAtHeight(const MirrorBlock mirror, vec2 q, float height) {
    vec4 start = vec4(q, 0.0, 1.0);
    float perDepth = mirror.heightRow.z + height * mirror.weightRow.z;
    return -(dot(mirror.heightRow, start) + height * dot(mirror.weightRow, start)) / perDepth;
}

float metresPerPixel(const MirrorBlock mirror, vec4 point) {
    vec4 p = mirror.relativeFromPixel * point;
    vec4 beside = p + mirror.relativeFromPixel[0];
    return distance(p.xyz / p.w, beside.xyz / beside.w);
}

// Whether a top is level there, as a rail or a wall is not.
bool isLevel(const MirrorBlock mirror, vec2 point, vec2 away, float edgeHeight) {
    vec4 here = seenPoint(mirror, point);
    vec4 before = seenPoint(mirror, clamp(point - away, vec2(0.5), vec2(regionSize(mirror)) - 0.5));
    if (isFar(mirror, here.z) || isFar(mirror, before.z)) return false;
    float top = heightOf(mirror, here);
    float rise = abs(heightOf(mirror, before) - top);
    vec3 way = unprojected(mirror, here.xyz) - unprojected(mirror, before.xyz);
    return rise < levelWithin * (top - edgeHeight) && rise < steepestTop * length(way);
}

// A level point of the top: the first that is tried from where the ray is hidden on, or where that ends, since posts may
// stand on it.
bool levelPoint(const MirrorBlock mirror, vec2 from, vec2 end, vec2 away, float edgeHeight, out vec2 point) {
    float most = farthest(end - from);
    bool level, last;
    int i = 0;
    do {
        float pixels = float((1 << i) - 1);
        last = !(pixels <= most) || i == mostTries;
        point = last ? end : from + pixels * away;
        level = isLevel(mirror, point, away, edgeHeight);
    } while (++i <= mostTries && !level && !last);
    return level;
}

// Whether a top of that height is seen, to one side along the horizon, past what stands on it and hides a point of it: that
// is seen to be higher all the way.
bool topShowsBeside(const MirrorBlock mirror, vec2 point, vec2 aside, float top, float within, out vec2 beside) {
    float height;
    int i = 1;
    do {
        beside = point + float(1 << i) * aside;
        vec4 seen = seenPoint(mirror, beside);
        height = insideRegion(mirror, beside) && !isFar(mirror, seen.z) ? heightOf(mirror, seen) : -1.0;
    } while (++i < sideLooks && height > top + within);
    return abs(height - top) <= within;
}

// Where the ray is as high as the edge that it goes in under, it meets an underside, provided that straight above a level top
// is seen, as high as the one by which the ray gets out of sight, or what stands on that.
Hit hitUnderTop(const MirrorBlock mirror, vec2 q, ScreenRay ray, float height, float depth, float top) {
    vec4 mirrored = vec4(q, fromInfinity(mirror, depth), 1.0);
    vec4 above = mix(mirrored, ray.origin + depth * ray.along, 0.5 * (top / height + 1.0));
    vec2 source = above.xy / above.w;
    bool shows = top > height && above.w > 0.0 && insideRegion(mirror, source);
    vec2 middle = floor(shows ? source : vec2(0.0)) + 0.5;
    vec4 seen = seenPoint(mirror, middle);
    float within = levelWithin * (top - height);
    bool level = !isFar(mirror, seen.z) && abs(heightOf(mirror, seen) - top) < within;
    if (shows && !isFar(mirror, seen.z) && heightOf(mirror, seen) > top + within) {
        vec2 aside = vec2(-mirror.heightRow.y, mirror.heightRow.x) / max(length(mirror.heightRow.xy), 1e-30);
        vec2 beside;
        level = topShowsBeside(mirror, middle, aside, top, within, beside) ||
                topShowsBeside(mirror, middle, -aside, top, within, beside);
        middle = level ? beside : middle;
    }
    return Hit(shows && level, false, middle, 0.0, depth);
}

Hit underOverhang(const MirrorBlock mirror, vec2 q, ScreenRay ray, Hit shown) {
    vec2 away = awayFrom(mirror, q);
    ivec2 overhang = overhangBefore(mirror, q, away, shown.valid ? keyFromDepth(mirror, shown.depth) : noKey);
    vec2 from = vec2(overhang) + 0.5;
    bool first = !shown.valid || dot(shown.source - from, away) > 2.0;
    float mostPixels = float(firstLook << mirror.overhangSamples);
    Hit hit = noHit;
    if (overhang != nowhere && first) {
        Entry entry = entryBefore(mirror, ray, q, from, mostPixels);
        if (entry.between == noGuesses) return noHit;
        vec4 edge = vec4(entry.hidden, depthAt(mirror, entry.between.other), 1.0);
        if (isFar(mirror, edge.z)) return noHit;
        float height = heightOf(mirror, edge);
        float depth = depthAtHeight(mirror, q, height);
        bool above = height > leastHeight * metresPerPixel(mirror, edge);
        bool before = !shown.valid || signedDepth(mirror, depth - shown.depth) > 0.0;
        if (above && before) {
            vec2 end = exitAfter(mirror, ray, from, away, mostPixels);
            vec2 on;
            bool level = levelPoint(mirror, from, end, away, height, on);
            // The key may be that of what stands on the top, which shows before its foot.
            if (!level && (!shown.valid || shown.front)) level = levelPoint(mirror, from, entry.hidden, -away, height, on);
            if (level) hit = hitUnderTop(mirror, q, ray, height, depth, heightOf(mirror, seenPoint(mirror, on)));
        }
    }
    return hit;
}
