// The waves ahead of a point of the surface, which hide low sky, low sun and low things from it. Those that can be told apart
// are looked for; of the rest, and of all without `waveShadowSteps`, Smith's masking says how many rays get by.
#ifndef WAVES_AHEAD_GLSL
#define WAVES_AHEAD_GLSL

#include "surface_point.glsl"
#include "slopes.glsl"
#include "wave_displacement.glsl"

struct WavesAhead {
    float horizon;   // tangent of the highest wave ahead
    float slope;     // of the pixel's middle, towards there
    float unseen;    // deviation of the slopes of waves that are not looked for
    float alike;     // correlation of such slopes around a facet with its own
};

const float noWave = -1e3;

bool wavesAreLookedFor() {
    return waveShadowSteps > 0;
}

// The tangent of the highest wave `from` a place to where none hides what rises by `lowest`: four deviations of height over another
// there are few, nor does it matter what lies beyond the length of the longest, 100 of them. Distances grow evenly: what is
// nearer is finer, but no finer than the pixel; and many begin nearer than few. Heights are all of the maps: the
// mesh's differ by more than near waves rise.
float horizonTowards(const SurfacePoint s, vec2 from, vec2 along, float lowest) {
    float nearest = max(min(0.5, 4.8 / float(waveShadowSteps)) * heightDeviation(), s.pixelLength);
    float farthest = heightDeviation() * min(4.0 / max(lowest, 1e-3), 100.0);
    float growth = pow(max(farthest / nearest, 2.0), 1.0 / float(waveShadowSteps - 1));
    float blur = 0.2 * (growth - 1.0);   // less than half a step, which would flatten the crests that cast shadows
    float finest = 0.5 * s.pixelLength;
    float away = nearest;
    vec3 here = waveDisplacementAt(waveDisplacement, from, max(blur * away, finest), keptAt(s));
    vec2 moved = here.xz;
    float tangent = noWave;
    int i = 0;
    [[dont_unroll]] do {
        // What moved the last one stands for what moves this one.
        vec2 calm = from + here.xz + along * away - moved;
        vec3 there = waveDisplacementAt(waveDisplacement, calm, max(blur * away, finest), keptAt(s));
        moved = there.xz;
        tangent = max(tangent, (there.y - here.y) / away);
        away *= growth;
    } while (++i < waveShadowSteps);
    return tangent;
}

// Of rays that rise by `lowest` or more. A pixel that is a quarter of the longest wave's length holds all of what casts shadows.
WavesAhead wavesAhead(const SurfacePoint s, vec2 along, float lowest) {
    const float alikeInAll = 0.2;
    const float alikeInShort = 0.85;
    if (!wavesAreLookedFor()) return WavesAhead(noWave, 0.0, slopeDeviation(), 0.0);
    float held = s.pixelLength / (25.0 * heightDeviation());
    float horizon = noWave;
    if (held < 1.0) horizon = max(dot(s.slope, along), horizonTowards(s, s.calm, along, lowest));
    float alike = mix(alikeInShort, alikeInAll, smoothstep(0.5, 2.0, held));
    return WavesAhead(horizon, dot(s.slope, along), sqrt(max(varianceAlong(along, s.covariance), 0.0)), alike);
}

// Share of the rays that pass above the highest wave.
float pastHorizon(float tangent, float horizon) {
    const float soft = 0.005;   // the sun's disc, and as much for the sky: wider lets its glint into shadows
    return smoothstep(horizon - soft, horizon + soft, tangent);
}

// Share of the rays of this rise that meet no other wave, from facets of this `slope` towards where they go. Smith's facets
// lean each for itself. Those of a sea lie on the sides of longer waves: around one that leans to the ray others do, and
// leave its way free. Where no wave is looked for, that would light the lee of those that the picture shows.
float clearShare(float rise, float slope, WavesAhead ahead) {
    if (rise <= 0.0) return 0.0;
    float tangent = rise * inversesqrt(max(1.0 - rise * rise, 1e-4));
    float around = mix(ahead.slope, slope, ahead.alike);
    float deviation = sqrt(1.0 - ahead.alike * ahead.alike) * max(ahead.unseen, 1e-5);
    return pastHorizon(tangent, ahead.horizon) / hiddenPer(max(tangent - around, 0.0) / deviation);
}

#endif
