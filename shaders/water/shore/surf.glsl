// Waves that feel the bed. Their crests grow narrow, then their fronts steep: harmonics bound to the trains' sum, of which
// z = height + i sideways turns with the phase, as z / (1 - c), c in proportion to z. How much is Stokes' second order; where
// along the wave is the biphase of field data (Ruessink et al. 2012). Their variance stays what it is without. The front of a wave
// that is about to break rises to a wall.
#ifndef SURF_GLSL
#define SURF_GLSL

#include "body.glsl"

const float steepest = 0.4;   // |c| of low waves,
const float steepestWall = 0.85, steepestBore = 0.6;   // and of high ones before they break, and after
const float highestToDepth = 0.9;   // a single wave's height
const float wallAt = 0.43;   // at such a share of the depth fronts are halfway to a wall
const float breaksAt = 0.62, breaksOnAt = 0.26;   // likewise waves break, at first and where all are broken

struct Surf {
    float height;    // of unit variance
    float biphase;   // by which its fronts come before where crests would be [rad]
    vec2 z, c;
    float kept;      // of crests, by the depth
    float over, strained;   // squared: past that limit, and that of c
    float rises;     // by how much more that of c grows with the amount, in shares
};

// `turns`: waves a metre. What is much shorter than `width` is left out.
Surf surfOf(vec2 z, float deviation, float depth, float breaking, float turns, float width) {
    float k = 6.2832 * turns;
    float water_ = max(depth, 0.08);
    float amount = length(z);
    // Of a crest that no depth can bear there is less.
    float most = highestToDepth * water_ / max(2.0 * deviation, 1e-6);
    float over = amount * amount / (most * most);
    float kept = inversesqrt(sqrt(1.0 + over * over));
    float x = k * water_;
    float deep = max(x * inversesqrt(1.0 + x * x), 0.01);   // tanh, within a tenth
    float second = k * deviation * (3.0 - deep * deep) / (4.0 * deep * deep * deep);
    float biphase = 1.5708 * second / (second + 0.8);
    float unseen = 4.0 * width * turns;
    float walls = over * highestToDepth * highestToDepth / (wallAt * wallAt);
    walls = min(walls * walls * walls * walls, 1e6);
    float walled = walls / (1.0 + walls);
    float wall = mix(steepestWall, steepestBore, breaking);
    float limit = mix(steepest, wall, walled);
    float rises = 8.0 * walled * (1.0 - walled) * (wall - steepest) / limit;
    float strained = second * kept * amount / limit;
    float bound = second * kept * inversesqrt(1.0 + strained * strained) / (1.0 + unseen * unseen);
    vec2 a = bound * z;
    vec2 turn = vec2(cos(biphase), sin(biphase));
    vec2 c = vec2(a.x * turn.x - a.y * turn.y, a.x * turn.y + a.y * turn.x);
    vec2 d = vec2(1.0 - c.x, c.y);
    float height = kept * sqrt(1.0 - dot(c, c)) / dot(d, d) * dot(z, vec2(d.x, -d.y));
    return Surf(height, biphase, z, c, kept, over * over, strained * strained, rises);
}

// How its height changes with z's two parts: apart, since what only moves vertices asks for none.
vec2 surfChanges(Surf s) {
    vec2 d = vec2(1.0 - s.c.x, s.c.y);
    float size = 1.0 / dot(d, d);
    vec2 changes = s.kept * sqrt(1.0 - dot(s.c, s.c)) * size * size * vec2(d.x * d.x - d.y * d.y, -2.0 * d.x * d.y);
    // Both limits go by the amount: how `kept` and `bound` change as it grows, in shares.
    float fewer = s.over / (1.0 + s.over);
    float loosens = -fewer - (1.0 - fewer - s.rises) * s.strained / (1.0 + s.strained);
    vec2 ofSecond = vec2(s.z.x * s.c.x - s.z.y * s.c.y, s.z.x * s.c.y + s.z.y * s.c.x);
    float second = dot(s.c, s.c);
    float grows = loosens * dot(ofSecond, changes) - s.height * (fewer + second * (1.0 + loosens) / (1.0 - second));
    return changes + grows * s.z / max(dot(s.z, s.z), 1e-12);
}

// Waves that break there.
struct Breakers {
    float broken;   // share of them
    float turns;    // since the toe of the roller passed, whole ones too
    float shown;    // share of the waves that is wide enough to be seen
};

// A roller comes down from the crest as more of a wave breaks, of waves of this deviation. A front is a wall before.
Breakers breakersOf(vec2 z, float biphase, float deviation, float breaking, float depth, float shown) {
    float amount = length(z);
    float height = 2.0 * amount * deviation / max(depth, 0.08);
    float broken = smoothstep(0.8, 1.2, height / mix(breaksAt, breaksOnAt, breaking)) * smoothstep(0.0, 0.3, breaking);
    float phase = amount > 1e-5 ? atan(z.y, z.x) : 0.0;
    return Breakers(broken, (phase + biphase + 0.45 * broken) / 6.2832, shown);
}

// Cover of the roller and of what it leaves until the next, or their mean; `bend` moves its toe.
float surfFoam(Breakers b, float bend) {
    const float leaves = 0.8;
    float fades = water.shoreForm.w;   // e-folds a period
    float rollsFor = mix(0.06, 0.17, b.broken);   // of the period: from a white lip on
    float rolling = smoothstep(0.0, 0.5, b.broken);
    float age = fract(b.turns + 0.03 * bend) - rollsFor;
    float left = b.broken * leaves * exp(-max(age, 0.0) * fades);
    float mean = rolling * rollsFor + b.broken * leaves / fades * (1.0 - exp((rollsFor - 1.0) * fades));
    return mix(mean, age < 0.0 ? rolling : left, b.shown);
}

#endif
