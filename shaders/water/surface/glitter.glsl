// Glitter: the sun's path as points that thin outwards. A Gaussian of slopes is one of less variance around means that are
// themselves distributed so. Here each cell of a lattice has a mean of its own, as a patch of facets on a wave that is too small to be
// seen. So the mean over many pixels stays the smooth lobe's. Glints on two scales: Zirr and Kaplanyan 2016; on cells that are as long
// and as wide as a pixel sees the surface: Deliot and Belcour 2023. The lattice stays on the calm water, whose waves carry it along.
#ifndef GLITTER_GLSL
#define GLITTER_GLSL

#include "surface_point.glsl"
#include "hash.glsl"

// Cells along the longer side of the pixel and across, from 1 to 2 of its lengths.
struct FacetLattice {
    uvec2 cell;
    vec2 past;      // within it, 0..1
    uint levels;    // which lattice it is
    float turns;    // of its patches in a loop
};

// Integers of 1/65,536 m, which wrap, so that a lattice is as exact far from the origin as near by.
void placeAlong(int eye, float fromEye, int level, out uint cell, out float past) {
    int bits = level + 16;
    float at = float(uint(eye) & ((1u << bits) - 1u)) * exp2(-float(bits)) + fromEye * exp2(-float(level));
    float whole = floor(at);
    cell = (uint(eye) >> bits) + uint(int(whole));
    cell &= 0xffffffffu >> bits;
    past = at - whole;
}

int levelOf(float width) {
    const int finest = -7;   // half of the shortest ripples that stand for long [log2 m]
    return max(int(ceil(log2(clamp(width, 1e-3, 4096.0)))), finest);
}

// Sheared along the pixel, by steps that move a cell's end by half a width.
FacetLattice facetLattice(const SurfacePoint s) {
    vec2 along = s.footprint.longer;
    bool byV = abs(along.y) > abs(along.x);
    if (byV) along = along.yx;
    float reach = max(abs(along.x), 1e-4);
    float slant = clamp(along.y / (along.x < 0.0 ? -reach : reach), -1.0, 1.0);
    ivec2 level = ivec2(levelOf(reach), levelOf(length(along) * length(s.footprint.shorter) / reach));
    int steps = min(2 << clamp(level.x - level.y, 0, 5), 64);
    int shear = int(round(slant * float(steps))) * (64 / steps);
    ivec2 eye = byV ? water.glitter.yx : water.glitter.xy;
    vec2 calm = byV ? s.calm.yx : s.calm;
    FacetLattice lattice;
    placeAlong(64 * eye.x, calm.x, level.x, lattice.cell.x, lattice.past.x);
    placeAlong(64 * eye.y - shear * eye.x, calm.y - float(shear) / 64.0 * calm.x, level.y, lattice.cell.y, lattice.past.y);
    lattice.levels = uint((level.x * 32 + level.y) * 2 + int(byV));
    lattice.turns = float(water.glitter.z) * exp2(-0.25 * float(level.x + level.y));
    return lattice;
}

// Of a patch, in deviations: sines of the time with amplitudes by Rayleigh, which are Gaussians at any moment.
vec2 facetsOf(uvec2 cell, FacetLattice lattice) {
    uint bits = scrambled(scrambled(cell.x + (lattice.levels << 16)) ^ (cell.y * 0x9e3779b9u));
    vec2 amplitude = sqrt(-2.0 * log(1.0 - vec2(shareOf(bits), shareOf(bits * 0x2c1b3c6du))));
    uint turned = uint(lattice.turns * (0.7 + 0.6 * shareOf(bits * 0x297a2d39u))) * uint(water.glitter.w);
    ivec2 phase = ivec2(uvec2(bits * 0x85ebca6bu, bits * 0x7feb352du) + turned);
    return amplitude * cos(vec2(phase) * 1.4629180e-9);
}

// Between patches it is mixed so that the variance stays.
vec2 facetsAt(const SurfacePoint s) {
    FacetLattice lattice = facetLattice(s);
    vec2 past = lattice.past * lattice.past * (3.0 - 2.0 * lattice.past);
    vec2 sum = vec2(0.0);
    float squares = 0.0;
    for (int i = 0; i < 4; ++i) {
        uvec2 corner = uvec2(i & 1, i >> 1);
        vec2 near = mix(1.0 - past, past, vec2(corner));
        float weight = near.x * near.y;
        sum += weight * facetsOf(lattice.cell + corner, lattice);
        squares += weight * weight;
    }
    return sum * inversesqrt(squares);
}

// Of the slopes' variance. Waves that are too small to be seen tilt a metre or less of water together: a pixel of many such places has
// the mean of them all, whose variance falls with their number. So points are near by, and the path is smooth farther off.
float sharedByAPatch(Footprint pixel) {
    const float tiltedAsOne = 1.0;   // [m^2]
    float area = 4.0 * pixel.reach * length(pixel.shorter);
    return water.glitterShare.x * tiltedAsOne / (tiltedAsOne + area);
}

// The point as a patch of its facets shows.
SurfacePoint patchOf(SurfacePoint s) {
    float share = sharedByAPatch(s.footprint);
    vec2 drawn = facetsAt(s);
    vec3 varies = share * s.covariance;
    float alongU = sqrt(max(varies.x, 1e-10));
    float skewed = varies.z / alongU;
    s.slope += vec2(alongU * drawn.x, skewed * drawn.x + sqrt(max(varies.y - skewed * skewed, 0.0)) * drawn.y);
    s.covariance -= varies;
    s.bounded *= 1.0 - share;
    return s;
}

#endif
