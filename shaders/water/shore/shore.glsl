// What a bed makes of the sea: water/shore/shore.h. The wave trains that it guides, how much of each cascade it leaves, and the
// water's edge on the sand.
#ifndef SHORE_GLSL
#define SHORE_GLSL

#include "wave_warp.glsl"
#include "body.glsl"

layout(set = 0, binding = shoreMapBinding) uniform sampler2DArray shoreMap;
layout(set = 0, binding = shoreSignalBinding, std430) readonly buffer ShoreSignal {
    vec4 shoreRows[];   // height, sideways, swash, wet
};

const int shoreTrains = 3;
const float lowestSwash = -1.2;
const float filmLift = 0.012;   // of a film over the sand, so that none of its grains hides it [m]

#include "surf.glsl"

struct ShoreWave {
    vec4 kept;       // of each cascade's amplitude
    float depth;     // of calm water
    vec2 bedSlope;
    float height;
    vec2 move;
    mat2 slopes;     // of the trains' height and sideways, before the surf
    vec2 swashSlope;
    vec3 stretch;    // dDx/du, dDz/dv, dDx/dv
    vec3 covariance; // of slopes too narrow to be seen
    float swash;     // how far the water's edge moves [m]
    float wetTo;     // height up to which sand is wet
    vec2 advected;   // what the swash has carried foam by [m]
    float rushes;    // how fast the water's edge rises [m/s]
    float deviation; // of the trains' height [m]
    float breaking;  // share of the waves, by the depth
    vec2 all;        // the trains' height and sideways, of waves too narrow to be seen too
    float shown;     // share of the waves that is wide enough to be seen
    Surf surf;
};

ShoreWave withoutTrains(vec4 kept, float depth, vec2 bedSlope, float swash) {
    Surf still = Surf(0.0, 0.0, vec2(0.0), vec2(0.0), 0.0, 0.0, 0.0, 0.0);
    return ShoreWave(kept, depth, bedSlope, 0.0, vec2(0.0), mat2(0.0), vec2(0.0), vec3(0.0), vec3(0.0), swash, -1e9, vec2(0.0), 0.0, 0.0, 0.0, vec2(0.0), 0.0, still);
}

const float lagCosine = 0.64, lagSine = 0.77;   // foam in the swash follows the crest a seventh of a wave later

// What the trains make there, by the map's rows; `alongU` and `alongV` change in a metre.
void addTrains(inout ShoreWave w, vec4 here, vec4 alongU, vec4 alongV, vec4 form, float width, int rows, float arrives) {
    float lean = 0.6 * form.y;
    float perTrain = inversesqrt(float(shoreTrains));
    float swash = 0.0, rushes = 0.0, wet = 0.0, turns = 0.0;
    vec2 swashSlope = vec2(0.0);
    vec2 wide = vec2(0.0);   // height and sideways of waves wide enough to be seen
    int t = 0;
    // All share one copy of the code.
    [[dont_unroll]] do {
        vec2 slowness = vec2(alongU.y, alongV.y);
        float size = max(length(slowness), 1e-4);
        vec2 towards = slowness / size;
        float row = here.y * water.shoreSignal.x + arrives;
        row = row > 0.0 ? min(row, water.shoreSignal.z - 1.001) : 0.0;   // a map of the host's may hold anything
        int i = rows + t * int(water.shoreSignal.z) + int(row);
        vec4 a = shoreRows[i];
        vec4 b = shoreRows[i + 1];
        vec4 now = mix(a, b, fract(row));
        vec4 rate = (a - b) * water.shoreSignal.x;   // rows go back in time
        float seen = 1.0 - smoothstep(0.15, 0.4, width * size * water.shoreForm.x);
        float sideways = form.z * seen;
        float lost = form.x * perTrain * size * 6.2832 * water.shoreForm.x;
        w.all += now.xy;
        wide += seen * now.xy;
        w.shown += seen / float(shoreTrains);
        w.slopes -= outerProduct(slowness, seen * rate.xy);
        w.covariance += lost * lost * (1.0 - seen * seen) * vec3(towards * towards, towards.x * towards.y);
        swash += now.z;
        wet += now.w;
        rushes += rate.z;
        swashSlope -= rate.z * slowness;
        w.move += sideways * (now.y + lean * now.x) * towards;
        float stretches = -sideways * (rate.y + lean * rate.x) * size;
        w.stretch += stretches * vec3(towards * towards, towards.x * towards.y);
        w.advected += towards * ((lagCosine * now.x + lagSine * now.y) * form.w * water.shoreForm.y);
        turns += size * water.shoreForm.x / float(shoreTrains);
        here.yzw = here.zwy;
        alongU.yzw = alongU.zwy;
        alongV.yzw = alongV.zwy;
    } while (++t < shoreTrains);
    w.deviation = form.x;
    w.breaking = form.y;
    w.surf = surfOf(wide, form.x, here.x, form.y, turns, width);
    w.height = form.x * w.surf.height + form.w * max(swash, lowestSwash);
    if (swash > lowestSwash) {
        w.swashSlope = form.w * swashSlope;
        w.rushes = form.w * rushes;
    }
    w.wetTo = form.w * wet;
}

// At calm (u, v); `width` is what is seen as one [m]. Of the moment whose rows begin at `rows`, `arrives` the row of what
// arrives then at the edge.
ShoreWave shoreWaveOf(vec2 calm, float width, int rows, float arrives) {
    vec2 at = water.shorePlace.xy + calm * water.shorePlace.zw;
    float spacing = water.shoreSignal.w;
    vec2 texel = spacing * water.shorePlace.zw;
    vec4 here = textureLod(shoreMap, vec3(at, 0.0), 0.0);
    vec4 alongU = (textureLod(shoreMap, vec3(at.x + texel.x, at.y, 0.0), 0.0) - here) / spacing;
    vec4 alongV = (textureLod(shoreMap, vec3(at.x, at.y + texel.y, 0.0), 0.0) - here) / spacing;
    vec4 form = textureLod(shoreMap, vec3(at, 1.0), 0.0);   // height, breaking, sideways, swash
    ShoreWave w = withoutTrains(vec4(0.0), here.x, -vec2(alongU.x, alongV.x), form.w);
    if (form.x + form.w > 0.0) addTrains(w, here, alongU, alongV, form, width, rows, arrives);
    w.kept = textureLod(shoreMap, vec3(at, 2.0), 0.0);
    return w;
}

ShoreWave shoreWave(vec2 calm, float width) {
    return shoreWaveOf(calm, width, 0, water.shoreSignal.y);
}

// In the last frame.
ShoreWave lastShoreWave(vec2 calm, float width) {
    return shoreWaveOf(calm, width, shoreTrains * int(water.shoreSignal.z), water.shoreForm.z);
}

// The height above calm water of a film that lies on the sand, or of the surface where that is higher.
float withFilm(ShoreWave w, float height, float lift) {
    float bed = -w.depth + dot(w.bedSlope, w.move);
    return w.wetTo > bed ? max(height, bed + lift) : height;
}

// The slopes and stretch of its own trains.
void addShore(ShoreWave shore, inout WaveGradient gradient) {
    gradient.height += shore.deviation * (shore.slopes * surfChanges(shore.surf)) + shore.swashSlope;
    gradient.movedU += shore.stretch.xz;
    gradient.movedV += shore.stretch.zy;
}

Breakers breakersOf(ShoreWave w) {
    return breakersOf(w.all, w.surf.biphase, w.deviation, w.breaking, w.depth, w.shown);
}

#endif
