// Where a ray goes behind what is seen, pixel by pixel: squares of pixels in which all that is seen lies farther than the
// ray are passed over at once.
#ifndef MARCH_CELLS_GLSL
#define MARCH_CELLS_GLSL

#include "march.glsl"
#include "cells.glsl"

layout(set = 0, binding = cellsBinding, std430) readonly buffer Cells {
    uint cells[];
};

Progress atStart(Track track, float noise) {
    return Progress(0.0, true, false, noCover, settings.steps);
}

// Squares of pixels that a track crosses one after the other (Amanatides and Woo 1987).
struct Walk {
    ivec2 square;
    ivec2 last;     // square of the picture
    ivec2 step;
    vec2 borders;   // the shares at which it crosses the square's own, in x and y
    vec2 edge;      // shares from one border to the next
};

Walk walkFrom(Track track, float reached, int shift) {
    // Of the smallest numbers the inverse is infinite, and none at all times 0.
    vec2 along = mix(track.along.xy, vec2(1e-20), lessThan(abs(track.along.xy), vec2(1e-20)));
    vec2 perPixel = 1.0 / along;
    // What lies this close before a border is beyond it: rounding would catch a track that runs along one.
    vec2 point = trackPoint(track, reached).xy + 0.01 * sign(along);
    ivec2 square = pixelAt(track.scene, point) >> shift;
    vec2 next = vec2(square + ivec2(step(vec2(0.0), along))) * float(1 << shift);
    return Walk(square, track.scene.lastPixel >> shift, ivec2(sign(along)), (next - track.first.xy) * perPixel,
                abs(perPixel) * float(1 << shift));
}

float leavesAt(Walk walk) {
    return min(min(walk.borders.x, walk.borders.y), 1.0);
}

// Rounding may lead over the picture's border before the track ends there.
void goOn(inout Walk walk) {
    bool sideways = walk.borders.x < walk.borders.y;
    walk.square = clamp(walk.square + (sideways ? ivec2(walk.step.x, 0) : ivec2(0, walk.step.y)), ivec2(0), walk.last);
    walk.borders += sideways ? vec2(walk.edge.x, 0.0) : vec2(0.0, walk.edge.y);
}

// A track crosses no more squares than that.
int mostSquares(const MirrorBlock mirror, int shift) {
    return squaresAcross(mirror, shift) + squaresDown(mirror, shift);
}

// Passes over squares until one, before `until`, holds something that the ray may be behind; says where that one ends. That is
// beyond `reached`: a square in which rounding leaves nothing of the way is passed over, too.
bool meetsSquare(const MirrorBlock mirror, Track track, int shift, float until, inout float reached, inout float ends) {
    int across = squaresAcross(mirror, shift);
    int first = firstSquare(mirror, shift);
    Walk walk = walkFrom(track, reached, shift);
    float toDepth = track.scene.depthSign;
    uint flipped = toDepth > 0.0 ? 0u : ~0u;   // as keyFromDepth() does
    bool receding = track.along.z < 0.0;
    bool meets = false;
    int left = mostSquares(mirror, shift);
    if (reached < until) {
        do {
            ends = leavesAt(walk);
            float farthest = track.first.z + (receding ? ends : reached) * track.along.z;
            uint key = floatBitsToUint(clamp(toDepth * farthest, 0.0, 1.0)) ^ flipped;
            meets = ends > reached && cells[first + walk.square.y * across + walk.square.x] >= key;
            if (meets) break;
            reached = max(ends, reached);
            goOn(walk);
        } while (--left > 0 && reached < until);
    }
    return meets;
}

// The next pixel before `until` in which the ray crosses what is seen.
Crossing crossedPixel(Track track, float until, inout Progress at) {
    Crossing crossing = noCrossing;
    Walk walk = walkFrom(track, at.reached, 0);
    if (at.reached < until && at.taps > 0) {
        do {
            --at.taps;
            crossing.begins = at.reached;
            crossing.ends = leavesAt(walk);
            Seen seen = seenAt(track.scene, walk.square);
            float entering = track.first.z + crossing.begins * track.along.z;
            float leaving = track.first.z + crossing.ends * track.along.z;
            at.reached = max(crossing.ends, at.reached);
            bool isBehind = seen.counts && seen.depth >= min(entering, leaving);
            at.hidden = at.hidden || isBehind;
            bool ends = coverEnds(track, crossing.begins, entering, seen, isBehind, at.cover);
            crossing.close = isBehind && within(track, crossing.begins, max(entering, leaving), seen.depth);
            crossing.coveredFrom = ends ? at.cover.from : inSight;
            crossing.found = crossing.close || ends;
            if (crossing.found) break;
            goOn(walk);
        } while (at.reached < until && at.taps > 0);
    }
    crossing.share = 0.5 * (crossing.begins + crossing.ends);
    return crossing;
}

// Whether a ray is hidden there, by more than things are thick, and by nothing that lies farther by as much than what hid it.
bool hiddenAt(Track track, float share, inout Cover cover) {
    vec3 point = trackPoint(track, share);
    Seen seen = seenAt(track.scene, pixelAt(track.scene, point.xy));
    bool hidden = seen.counts && seen.depth >= point.z && !within(track, share, point.z, seen.depth) &&
                  within(track, share, point.z, seen.depth, cover.depth);
    cover.depth = seen.depth;
    return hidden;
}

// Whether the same hides a ray all over a square. Of one that has been hidden for a square's width two samples tell, or it had
// none left for where it comes into sight.
bool staysCovered(Track track, float from, float until, inout Cover cover) {
    float width = float(1 << cellShift) * 2.0 * track.halfPixel;
    Cover there = cover;
    bool stays = cover.depth != nothing && from - cover.from > width && hiddenAt(track, 0.5 * (from + until), there) &&
                 hiddenAt(track, until - 0.1 * track.halfPixel, there);
    if (stays) cover = there;
    return stays;
}

// A round comes to the end of a block, or takes a look at a pixel of a cell.
Crossing nextCrossing(const MirrorBlock mirror, Track track, inout Progress at) {
    Crossing crossing = noCrossing;
    float end = 1.0 - 0.02 * track.halfPixel;   // not beyond the picture by rounding
    if (at.taps > 0 && at.reached < end) {
        int rounds = at.taps + mostSquares(mirror, blockShift);
        do {
            float before = at.reached;
            float blockEnds = 0.0;
            float cellEnds = 0.0;
            bool block = meetsSquare(mirror, track, blockShift, end, at.reached, blockEnds);
            bool cell = meetsSquare(mirror, track, cellShift, block ? min(blockEnds, end) : 0.0, at.reached, cellEnds);
            if (at.reached > before) at.cover = noCover;
            float until = cell ? min(cellEnds, end) : 0.0;
            bool covered = cell && staysCovered(track, at.reached, until, at.cover);
            if (covered) {
                at.reached = max(until, at.reached);
                at.taps -= 2;
            }
            crossing = crossedPixel(track, covered ? 0.0 : until, at);
        } while (--rounds > 0 && at.taps > 0 && at.reached < end && !crossing.found);
    }
    at.reached = at.reached < end ? at.reached : 1.0;
    return crossing;
}

#endif
