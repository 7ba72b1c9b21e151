// Fog between the eye and what it sees, for the host's own materials as for the water: FogDesc of seaglass/fog.h. Fogged is
// `radiance * m.a + m.rgb` of m = seaglass_medium(...); of what is blended by premultiplied alpha `rgb * m.a + alpha * m.rgb`.

// seaglass::FogBlock.
struct SeaglassFog {
    vec4 color;   // radiance of endless fog; share of it that is the sky's own
    vec4 form;    // density [1/m], falloff [1/m], falloff times the eye's height above the base, share taken at most
    vec4 reach;   // of the linear: end [m], 1 / (end - start); FogShape; 1 where it lies over the sky
};

const int seaglass_fogLinear = 1;
const int seaglass_fogExponential = 2;
const int seaglass_fogExponentialSquared = 3;
const int seaglass_fogHeight = 4;

const float seaglass_endless = 1e9;   // [m]; how far away the sky is

// Mean of exp(-x) from `a` to `b`. What lies close together would cancel out, and what lies far below the base be infinite.
float seaglass_meanOfExp(float a, float b) {
    float apart = min(abs(b - a), 1e12);
    float even = 1.0 - apart * (0.5 - apart * (1.0 / 6.0 - apart / 24.0));
    float share = apart < 0.02 ? even : (1.0 - exp(-min(apart, 80.0))) / apart;
    return exp(-clamp(min(a, b), -50.0, 80.0)) * share;
}

// What share of light passes along `way` metres that begin `above` the eye and rise by `rise` [m]. `shape` is fog.reach.z, or
// a constant of the pipeline.
float seaglass_transmittance(int shape, SeaglassFog fog, float above, float rise, float way) {
    float share = min(seaglass_endless / max(way, 1e-9), 1.0);
    way *= share;
    rise *= share;
    float passes = 1.0;
    if (shape == seaglass_fogLinear) {
        passes = clamp((fog.reach.x - way) * fog.reach.y, 0.0, 1.0);
    } else if (shape == seaglass_fogExponentialSquared) {
        float x = min(fog.form.x * way, 9.0);
        passes = exp(-x * x);
    } else {
        float x = fog.form.x * way;
        if (shape == seaglass_fogHeight) {
            float from = fog.form.z + fog.form.y * above;
            x *= seaglass_meanOfExp(from, from + fog.form.y * rise);
        }
        passes = exp(-min(x, 80.0));
    }
    return 1.0 - fog.form.w * (1.0 - passes);
}

// Radiance of endless fog before what is seen along `sight`, unit: `sky` is the sky's cube at seaglass_fogSight(sight), on its
// mip seaglass_fogMip().
vec3 seaglass_fogColor(SeaglassFog fog, vec3 sky) {
    return mix(fog.color.rgb, sky, fog.color.w);
}

// Below the horizon fog is lit as at the horizon: the sky there, without the darker ground that a blur would mix in.
vec3 seaglass_fogSight(vec3 sight) {
    return vec3(sight.x, max(sight.y, 0.03), sight.z);
}

// Smooth: of 32 texels across each face, nearly three degrees. Coarser ones are darker than the horizon that fog fades into.
float seaglass_fogMip(float mips) {
    return max(mips - 6.0, 0.0);
}

// What fog of that `color` adds, and what share of light it lets through.
vec4 seaglass_medium(int shape, SeaglassFog fog, vec3 color, float above, float rise, float way) {
    float passes = seaglass_transmittance(shape, fog, above, rise, way);
    return vec4((1.0 - passes) * color, passes);
}

// The sky's own radiance, seen along `sight` from `above` the eye [m].
vec3 seaglass_foggedSky(int shape, SeaglassFog fog, vec3 sky, float above, vec3 sight) {
    vec4 m = seaglass_medium(shape, fog, seaglass_fogColor(fog, sky), above, sight.y * seaglass_endless, seaglass_endless);
    return sky * m.a + m.rgb;
}

// Of a straight way from the first height over the water to the second: where it comes into the air, and where it leaves it
// [shares of it].
vec2 seaglass_partInAir(float from, float to) {
    if (from >= 0.0 && to >= 0.0) return vec2(0.0, 1.0);
    if (from <= 0.0 && to <= 0.0) return vec2(0.0);
    float crossing = from / (from - to);
    return from > 0.0 ? vec2(0.0, crossing) : vec2(crossing, 1.0);
}
