// Heights at many points of one time: every cascade's fields on its grid, by Fourier transform, and between
// its samples linearly, as a GPU's filter does, so that they are those of the surface that is drawn. The
// point of the calm plane that the horizontal displacement carries to the point asked for is sought as in
// heights.cpp, but for a block of points at a time, which then do not wait for each other's memory.
#include "seaglass/sea.h"

#include "water/sea/fourier.h"
#include "water/sea/packed_samples.h"
#include "water/sea/phase.h"
#include "water/sea/sea.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <memory>
#include <new>
#include <numbers>
#include <vector>

namespace seaglass {
namespace {

using Complex = std::complex<float>;
constexpr size_t lanes = 4;

// What a sample of a cascade's grid holds, in the order in which a search and its end want it: the first
// field of each pair that is transformed together.
constexpr size_t moveField = 0;            ///< horizontal displacement [m]: u, v
constexpr size_t heightField = 4;          ///< [m]; behind it the shear, dDx/dv
constexpr size_t velocityField = 8;        ///< [m/s]: u, up, v; behind it nothing
constexpr size_t pairs = packedFields / 2; ///< complex fields

// Sample (i, j), at u = i patch/samples and v = j patch/samples, is number i * samples + j; the last row is
// the first one again, so that no cell has to wrap.
struct Tile {
    double patch = 0;    ///< [m]
    double perPatch = 0; ///< [1/m]
    float texelsPerMetre = 0;
    float metresPerTexel = 0;
    std::array<Float4, packedFields / 4> scales; ///< of the samples' fields
    std::vector<PackedSample> samples;
};

using Long2 = int64_t __attribute__((vector_size(16)));
using Double2 = double __attribute__((vector_size(16)));
using Float2 = float __attribute__((vector_size(8)));

Float4 all(float value) {
    return Float4{value, value, value, value};
}

// Four places, or ways, along u and v.
struct Four {
    Float4 u, v;
};

// The cell around each of four points: its first sample, and each corner's share in the point.
struct Cells {
    Int4 at;
    CornerShares shares;
};

struct Lattice {
    int mask;  ///< samples - 1: wraps negative numbers too
    int shift; ///< log2(samples)

    explicit Lattice(uint32_t samples)
        : mask(static_cast<int>(samples) - 1), shift(std::countr_zero(samples)) {}
    size_t pitch() const { return static_cast<size_t>(mask) + 1; }
    Int4 number(const Int4& i, const Int4& j) const { return ((i & mask) << shift) + (j & mask); }
};

Int4 floorOf(const Float4& x) {
    const Int4 whole = __builtin_convertvector(x, Int4);
    return whole + (__builtin_convertvector(whole, Float4) > x); // true is -1
}

Cells cellsAt(const Four& place, const Lattice& lattice) {
    const Int4 i = floorOf(place.u), j = floorOf(place.v);
    return {lattice.number(i, j), cornerShares(place.u - __builtin_convertvector(i, Float4),
                                               place.v - __builtin_convertvector(j, Float4))};
}

// Four times four values to four of each.
void transpose(std::array<Float4, 4>& rows) {
    const Float4 a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
    const Float4 b = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
    const Float4 c = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
    const Float4 d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
    rows = {__builtin_shufflevector(a, b, 0, 1, 4, 5), __builtin_shufflevector(a, b, 2, 3, 6, 7),
            __builtin_shufflevector(c, d, 0, 1, 4, 5), __builtin_shufflevector(c, d, 2, 3, 6, 7)};
}

Float4 magnitude(const Float4& x) {
    return x < 0 ? -x : x;
}

// A scale of the sea's warp, in floats.
struct WarpWaves {
    std::array<float, 2> u{}, v{};
    float amplitude = 0;

    explicit WarpWaves(const WarpScale& from)
        : u{static_cast<float>(from.u[0]), static_cast<float>(from.u[1])}, v{static_cast<float>(from.v[0]),
                                                                             static_cast<float>(from.v[1])},
          amplitude(static_cast<float>(from.amplitude)) {}
};

// The sea's warp at four points: WarpShift.
struct Warped {
    Four by;
    Float4 uu, uv, vu, vv;

    // `turns` are those of both waves where the offset is 0.
    void add(const WarpWaves& waves, const Four& turns, const Four& offset) {
        const auto within = [](const Float4& t) {
            return t - __builtin_convertvector(floorOf(t + 0.5f), Float4);
        };
        const Float4 t = within(turns.u + waves.u[0] * offset.u + waves.u[1] * offset.v);
        const Float4 s = within(turns.v + waves.v[0] * offset.u + waves.v[1] * offset.v);
        const float most = 8 * waves.amplitude;
        by.u += most * t * (1 - 2 * magnitude(t)) - waves.amplitude;
        by.v += most * s * (1 - 2 * magnitude(s)) - waves.amplitude;
        const Float4 rateU = most * (1 - 4 * magnitude(t)), rateV = most * (1 - 4 * magnitude(s));
        uu += rateU * waves.u[0];
        uv += rateU * waves.u[1];
        vu += rateV * waves.v[0];
        vv += rateV * waves.v[1];
    }
    // What is looked up so far aside, from an offset so small that the gradient lasts.
    Four near(const Four& offset) const {
        return {offset.u + by.u + uu * offset.u + uv * offset.v,
                offset.v + by.v + vu * offset.u + vv * offset.v};
    }
    // Derivatives of what is looked up there.
    Four along(const Float4& u, const Float4& v) const { return {u + u * uu + v * vu, v + u * uv + v * vv}; }
};

// Four points: where they lie on each tile, in samples, and how far from them the water rests that is seen
// there.
struct Search {
    std::array<Four, maxCascades> sample;
    std::array<Four, warpScales> turns; ///< of the warp's waves
    Warped warped;                      ///< at the points themselves
    Four offset;
    Int4 steep;   ///< on the way, or out of reach: to be sought with care
    Int4 nowhere; ///< not finite
};

// All that is known at four resting points, as in a sample.
struct Found {
    Four moved, movedU, movedV; ///< and how either part changes along u and v
    Float4 height;
    Four slope;
    std::array<Float4, 4> velocity;

    Float4 jacobian() const { return (1 + movedU.u) * (1 + movedV.v) - movedU.v * movedV.u; }
    Four residual(const Four& offset) const { return {offset.u + moved.u, offset.v + moved.v}; }
    // Newton's step to where the displacement leads to the point.
    Four step(const Four& offset) const {
        const Four r = residual(offset);
        const Float4 j = jacobian();
        return {-((1 + movedV.v) * r.u - movedU.v * r.v) / j, -((1 + movedU.u) * r.v - movedV.u * r.u) / j};
    }
};

float lengthOf(const Four& a, size_t l) {
    return std::sqrt(a.u[l] * a.u[l] + a.v[l] * a.v[l]);
}

} // namespace

struct HeightGrid {
    const Sea& sea;
    double time = 0; ///< [s]
    Lattice lattice;
    InverseFourier fourier;
    std::vector<Tile> tiles;
    std::vector<WarpWaves> warp; ///< none of a sea without
    std::vector<Complex4> columns, rows, scratch;
    std::vector<Complex> heights, rates; ///< of the modes of one cascade
    float near = 0;                      ///< from where one linear step does [m]

    explicit HeightGrid(const Sea& from);
    void fill(double at);
    void sampleBlock(const double* points, size_t count, HeightSample* out) const;

  private:
    void advance(const Modes& modes, uint32_t now);
    void transform(uint32_t cascade, size_t pair);
    float mostOf(Float4 Complex4::*part) const;
    void store(Tile& tile, size_t pair) const;
    void repeatFirst(Tile& tile) const;

    void place(Search& search, const double* points) const;
    using AllCells = std::array<Cells, maxCascades>;
    Warped warpedAt(const Search& search, const Four& offset) const;
    void enter(const Search& search, const Four& aside, AllCells& cells) const;
    Corners cornersOf(size_t c, const Cells& cells, size_t l) const {
        return {&tiles[c].samples[static_cast<size_t>(cells.at[l])], lattice.pitch(), cells.shares.here[l],
                cells.shares.next[l]};
    }
    void guess(Search& search) const;
    void nearer(Search& search) const;
    Found foundAt(const Search& search) const;
    void finish(const Search& search, HeightSample* out) const;
    HeightSample seekWithCare(const Search& search, size_t l) const;
};

namespace {

constexpr size_t block = 16;   ///< points that are sought together
constexpr int moreRounds = 25; ///< for points that have not arrived where all others have
constexpr float leastStretch = 0.2f;

size_t groupsOf(size_t lines) {
    return (lines + lanes - 1) / lanes;
}

// The spectra of (Dx, Dz), (dDx/du, dDz/dv), (h, dDx/dv), (dh/du, dh/dv), (velocity u, up) and (velocity v,
// nothing) at k: h is the height's, r its rate of change's.
Complex spectrumOf(size_t pair, Complex h, Complex r, float ku, float kv, float d) {
    constexpr Complex i(0, 1);
    switch (pair) {
    case 0:
        return i * d * Complex(ku, kv) * h;
    case 1:
        return -d * Complex(ku * ku, kv * kv) * h;
    case 2:
        return Complex(1, -ku * kv * d) * h;
    case 3:
        return i * Complex(ku, kv) * h;
    case 4:
        return i * (ku * d + 1) * r;
    default:
        return i * kv * d * r;
    }
}

} // namespace

HeightGrid::HeightGrid(const Sea& from)
    : sea(from), lattice(from.desc.samples), fourier(from.desc.samples), tiles(from.count) {
    const size_t samples = from.desc.samples, kept = samples * (samples + 1);
    size_t widest = 0;
    for (uint32_t c = 0; c < from.count; ++c) {
        tiles[c].patch = from.cascades[c].patch;
        tiles[c].perPatch = 1 / tiles[c].patch;
        tiles[c].texelsPerMetre = static_cast<float>(static_cast<double>(samples) / tiles[c].patch);
        tiles[c].metresPerTexel = 1 / tiles[c].texelsPerMetre;
        tiles[c].samples.resize(kept);
        widest = std::max(widest, groupsOf(2 * static_cast<size_t>(from.modes[c].reach) + 1));
    }
    if (from.warp[0].amplitude > 0)
        for (const WarpScale& scale : from.warp) warp.emplace_back(scale);
    if (from.count > 0) near = 0.25f / tiles.back().texelsPerMetre;
    columns.resize(samples * widest);
    rows.resize(from.count > 0 ? samples * groupsOf(samples) : 0);
    scratch.resize(std::max(columns.size(), rows.size()));
}

// h(k,t) and its rate of change.
void HeightGrid::advance(const Modes& modes, uint32_t now) {
    const auto step = static_cast<float>(2 * std::numbers::pi / sea.desc.loopPeriod);
    heights.assign(modes.frequency.size(), 0);
    rates.assign(modes.frequency.size(), 0);
    for (size_t at = 0; at < heights.size(); ++at) {
        if (modes.frequency[at] == 0) continue;
        const SineCosine phase = sineCosine(wavePhase(modes.frequency[at], now));
        const Complex turn(phase.cosine, phase.sine);
        const Complex forward = Complex(modes.forwardRe[at], modes.forwardIm[at]) * turn;
        const Complex backward = Complex(modes.backwardRe[at], modes.backwardIm[at]) * std::conj(turn);
        heights[at] = forward + backward;
        rates[at] = Complex(0, static_cast<float>(modes.frequency[at]) * step) * (forward - backward);
    }
}

// Leaves the pair in `rows`: a row a u, its elements along v.
void HeightGrid::transform(uint32_t cascade, size_t pair) {
    const Modes& modes = sea.modes[cascade];
    const size_t samples = sea.desc.samples, acrossV = groupsOf(samples);
    const auto reach = static_cast<size_t>(modes.reach);
    const size_t width = 2 * reach + 1, across = groupsOf(width);
    const auto dk = static_cast<float>(2 * std::numbers::pi / tiles[cascade].patch);
    std::fill_n(columns.begin(), samples * across, Complex4{});
    const auto put = [&](size_t row, size_t column, Complex value) {
        Complex4& at = columns[row * across + column / lanes];
        at.re[column % lanes] = value.real();
        at.im[column % lanes] = value.imag();
    };
    for (size_t n = 0; n <= reach; ++n)
        for (size_t c = n > 0 ? 0 : reach + 1; c < width; ++c) {
            const size_t at = n * modes.pitch + c;
            const float ku = dk * (static_cast<float>(c) - static_cast<float>(reach));
            const float kv = dk * static_cast<float>(n), d = sea.desc.choppiness * modes.inverseK[at];
            put(n, c, spectrumOf(pair, heights[at], rates[at], ku, kv, d));
            put((samples - n) % samples, 2 * reach - c,
                spectrumOf(pair, std::conj(heights[at]), std::conj(rates[at]), -ku, -kv, d));
        }
    fourier.transform(columns.data(), scratch.data(), across);

    std::fill(rows.begin(), rows.end(), Complex4{});
    for (size_t v = 0; v < samples; ++v)
        for (size_t c = 0; c < width; ++c) {
            const Complex4& from = columns[v * across + c / lanes];
            Complex4& to = rows[(c + samples - reach) % samples * acrossV + v / lanes];
            to.re[v % lanes] = from.re[c % lanes];
            to.im[v % lanes] = from.im[c % lanes];
        }
    fourier.transform(rows.data(), scratch.data(), acrossV);
}

float HeightGrid::mostOf(Float4 Complex4::*part) const {
    Float4 most{};
    for (const Complex4& four : rows) {
        const Float4 magnitude = four.*part < 0 ? -(four.*part) : four.*part;
        most = magnitude > most ? magnitude : most;
    }
    return std::max({most[0], most[1], most[2], most[3]});
}

void HeightGrid::store(Tile& tile, size_t pair) const {
    const size_t samples = sea.desc.samples, across = groupsOf(samples);
    for (const size_t half : {0u, 1u}) {
        Float4 Complex4::*const part = half == 0 ? &Complex4::re : &Complex4::im;
        const size_t field = 2 * pair + half;
        const float scale = packedScale(mostOf(part));
        tile.scales[field / 4][field % 4] = scale;
        for (size_t u = 0; u < samples; ++u) {
            const Complex4* const row = &rows[u * across];
            const Int4 first = packed(row[0].*part, scale);
            PackedSample* to = &tile.samples[u * samples];
            Int4 four = first;
            for (size_t group = 1; group <= across; ++group, to += lanes) {
                const Int4 next = group < across ? packed(row[group].*part, scale) : first;
                const Int4 pairs = paired(four, __builtin_shufflevector(four, next, 1, 2, 3, 4));
                for (size_t l = 0; l < lanes; ++l) to[l].pairs[field] = pairs[l];
                four = next;
            }
        }
    }
}

void HeightGrid::repeatFirst(Tile& tile) const {
    std::copy_n(tile.samples.begin(), sea.desc.samples,
                tile.samples.end() - static_cast<ptrdiff_t>(sea.desc.samples));
}

void HeightGrid::fill(double at) {
    time = at;
    const uint32_t now = loopPhase(at, sea.desc.loopPeriod);
    for (uint32_t c = 0; c < sea.count; ++c) {
        advance(sea.modes[c], now);
        for (size_t pair = 0; pair < pairs; ++pair) {
            transform(c, pair);
            store(tiles[c], pair);
        }
        repeatFirst(tiles[c]);
    }
}

namespace {

using Points = std::array<Double2, 4>; // u, v

// Both -1 where a point is neither so far that whole tiles are not exact, nor no number.
Long2 isNear(const Double2& point) {
    constexpr double farthest = 1e12; // [m]
    return (point < farthest) & (point > -farthest);
}

bool isFinite(const Double2& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

Double2 onFirstTile(const Double2& point, double patch) {
    return isFinite(point) ? Double2{std::fmod(point[0], patch), std::fmod(point[1], patch)} : Double2{};
}

// Where two points lie on their tiles, as shares of them.
Float4 sharesOfTile(const Double2& first, const Double2& second, double perPatch) {
    const auto share = [perPatch](const Double2& point) {
        const Double2 away = point * perPatch;
        constexpr double noFraction = 0x1.8p52; // what is added to this has none
        return __builtin_convertvector(away - ((away + noFraction) - noFraction), Float2);
    };
    return __builtin_shufflevector(share(first), share(second), 0, 1, 2, 3);
}

} // namespace

void HeightGrid::place(Search& search, const double* points) const {
    Points asked, near;
    __builtin_memcpy(asked.data(), points, sizeof asked);
    search.offset = Four{};
    search.steep = search.nowhere = Int4{};
    const Long2 inside = isNear(asked[0]) & isNear(asked[1]) & isNear(asked[2]) & isNear(asked[3]);
    const bool anyFar = (inside[0] & inside[1]) == 0;
    for (size_t l = 0; anyFar && l < 4; ++l) {
        const Long2 both = isNear(asked[l]);
        search.steep[l] = (both[0] & both[1]) == 0 ? -1 : 0;
        search.nowhere[l] = isFinite(asked[l]) ? 0 : -1;
    }
    const auto samples = static_cast<float>(sea.desc.samples);
    for (size_t s = 0; s < warp.size(); ++s) {
        for (size_t l = 0; l < 4; ++l) {
            const bool somewhere = search.nowhere[l] == 0;
            search.turns[s].u[l] =
                somewhere ? static_cast<float>(warpTurns(sea.warp[s].u, asked[l][0], asked[l][1])) : 0;
            search.turns[s].v[l] =
                somewhere ? static_cast<float>(warpTurns(sea.warp[s].v, asked[l][0], asked[l][1])) : 0;
        }
    }
    search.warped = warpedAt(search, Four{});
    for (size_t c = 0; c < tiles.size(); ++c) {
        const Tile& tile = tiles[c];
        for (size_t l = 0; anyFar && l < 4; ++l)
            near[l] = search.steep[l] ? onFirstTile(asked[l], tile.patch) : asked[l];
        const Points& at = anyFar ? near : asked;
        const Float4 low = sharesOfTile(at[0], at[1], tile.perPatch);
        const Float4 high = sharesOfTile(at[2], at[3], tile.perPatch);
        search.sample[c] = {__builtin_shufflevector(low, high, 0, 2, 4, 6) * samples,
                            __builtin_shufflevector(low, high, 1, 3, 5, 7) * samples};
    }
}

Warped HeightGrid::warpedAt(const Search& search, const Four& offset) const {
    Warped warped{};
    for (size_t s = 0; s < warp.size(); ++s) warped.add(warp[s], search.turns[s], offset);
    return warped;
}

// The cells so far aside of the points.
void HeightGrid::enter(const Search& search, const Four& aside, AllCells& cells) const {
    for (size_t c = 0; c < tiles.size(); ++c) {
        const float scale = tiles[c].texelsPerMetre;
        const Four& sample = search.sample[c];
        cells[c] = cellsAt({sample.u + aside.u * scale, sample.v + aside.v * scale}, lattice);
    }
}

namespace {

// Where four points move, all tiles together.
struct Moved {
    Four by, stretch;

    // Newton's step without the shear, nowhere steeper than leastStretch.
    Four step(const Four& offset) const {
        const Float4 least = all(leastStretch), alongU = 1 + stretch.u, alongV = 1 + stretch.v;
        return {-(offset.u + by.u) / (alongU < least ? least : alongU),
                -(offset.v + by.v) / (alongV < least ? least : alongV)};
    }
};

} // namespace

// A first step, from the nearest samples and how they change from there; without the smallest tile, whose
// waves move water least.
void HeightGrid::guess(Search& search) const {
    Moved moved{};
    const size_t count = std::max<size_t>(tiles.size(), 2) - 1;
    for (size_t c = 0; c < count; ++c) {
        const Tile& tile = tiles[c];
        const Four &by = search.warped.by, from = search.sample[c];
        const Four sample{from.u + by.u * tile.texelsPerMetre, from.v + by.v * tile.texelsPerMetre};
        const Int4 i = floorOf(sample.u + 0.5f), j = floorOf(sample.v + 0.5f);
        const Int4 at = lattice.number(i, j);
        std::array<Float4, 4> moves;
        for (size_t l = 0; l < 4; ++l)
            moves[l] = tile.scales[0] * fourOf(tile.samples[static_cast<size_t>(at[l])], moveField);
        transpose(moves);
        const Float4 pastU = (sample.u - __builtin_convertvector(i, Float4)) * tile.metresPerTexel;
        const Float4 pastV = (sample.v - __builtin_convertvector(j, Float4)) * tile.metresPerTexel;
        moved.by.u += moves[0] + moves[2] * pastU;
        moved.by.v += moves[1] + moves[3] * pastV;
        moved.stretch.u += moves[2];
        moved.stretch.v += moves[3];
    }
    search.offset = moved.step(search.offset);
}

// Where Newton's step would fly off it is left to seekWithCare(). Point after point, so that sums stay in
// registers; so in foundAt().
void HeightGrid::nearer(Search& search) const {
    AllCells cells;
    enter(search, search.warped.near(search.offset), cells);
    const size_t count = tiles.size();
    std::array<Float4, 4> moves;
    for (size_t l = 0; l < 4; ++l) {
        Float4 sum{};
        for (size_t c = 0; c < count; ++c)
            sum += tiles[c].scales[0] * fourBetween(cornersOf(c, cells[c], l), moveField);
        moves[l] = sum;
    }
    transpose(moves);
    const Moved moved{{moves[0], moves[1]}, {moves[2], moves[3]}};
    search.steep |= (1 + moves[2] < leastStretch) | (1 + moves[3] < leastStretch);
    const Four step = moved.step(search.offset);
    search.offset = {search.offset.u + step.u, search.offset.v + step.v};
}

Found HeightGrid::foundAt(const Search& search) const {
    const Warped warped = warpedAt(search, search.offset);
    AllCells cells;
    enter(search, {search.offset.u + warped.by.u, search.offset.v + warped.by.v}, cells);
    const size_t count = tiles.size();
    std::array<Float4, 4> allMoves, allShape;
    Found found;
    for (size_t l = 0; l < 4; ++l) {
        Float4 moves{}, shape{}, velocity{};
        for (size_t c = 0; c < count; ++c) {
            const Corners corners = cornersOf(c, cells[c], l);
            moves += tiles[c].scales[0] * fourBetween(corners, moveField);
            shape += tiles[c].scales[1] * fourBetween(corners, heightField);
            velocity += tiles[c].scales[2] * fourBetween(corners, velocityField);
        }
        allMoves[l] = moves;
        allShape[l] = shape;
        found.velocity[l] = velocity;
    }
    transpose(allMoves);
    transpose(allShape);
    transpose(found.velocity);
    const auto& [movedU, movedV, stretchU, stretchV] = allMoves;
    const auto& [height, shear, slopeU, slopeV] = allShape;
    found.moved = {movedU, movedV};
    found.movedU = warped.along(stretchU, shear);
    found.movedV = warped.along(shear, stretchV);
    found.height = height;
    found.slope = warped.along(slopeU, slopeV);
    return found;
}

namespace {

// With a last step of the search, along which the surface is taken for flat.
// `folded` is 1 or 0.
void writeSamples(const Found& found, const Four& last, const Int4& folded, HeightSample* out) {
    const auto& [slopeU, slopeV] = found.slope;
    const Float4 jacobian = found.jacobian(), level = found.height + slopeU * last.u + slopeV * last.v;
    // Across the displaced surface's tangents; turned upwards where it has overturned.
    const Float4 side = jacobian < 0 ? all(-1) : all(1), up = side * jacobian;
    const Float4 u = side * (slopeV * found.movedV.u - slopeU * (1 + found.movedV.v));
    const Float4 v = side * (slopeU * found.movedU.v - slopeV * (1 + found.movedU.u));
    const Float4 squared = u * u + up * up + v * v;
    const Int4 upright = squared > 0;
    Float4 length;
    for (size_t l = 0; l < 4; ++l) length[l] = std::sqrt(squared[l]);
    const Float4 scale = upright ? 1 / length : all(0);
    std::array<Float4, 4> above{level, u * scale, upright ? up * scale : all(1), v * scale};
    transpose(above);
    std::array<Float4, 4> moving = found.velocity;
    moving[3] = reinterpret_cast<Float4>(folded);
    transpose(moving);
    static_assert(offsetof(HeightSample, velocity) == sizeof(Float4));
    static_assert(sizeof(HeightSample) == 2 * sizeof(Float4));
    for (size_t l = 0; l < 4; ++l) {
        auto* const to = reinterpret_cast<std::byte*>(&out[l]);
        __builtin_memcpy(to, &above[l], sizeof(Float4));
        __builtin_memcpy(to + sizeof(Float4), &moving[l], sizeof(Float4));
    }
}

} // namespace

// As heights.cpp's invert(). Folded where the surface overturned on the way, or the search did not settle.
HeightSample HeightGrid::seekWithCare(const Search& search, size_t l) const {
    constexpr float leastJacobian = 0.05f;
    Search alone{}; // four times the same
    for (size_t c = 0; c < tiles.size(); ++c)
        alone.sample[c] = {all(search.sample[c].u[l]), all(search.sample[c].v[l])};
    for (size_t s = 0; s < warp.size(); ++s)
        alone.turns[s] = {all(search.turns[s].u[l]), all(search.turns[s].v[l])};
    Found found{};
    Four last{};
    bool smooth = true, settled = false;
    for (int step = 0; step < moreRounds && !settled; ++step) {
        found = foundAt(alone);
        const float jacobian = found.jacobian()[0];
        smooth &= jacobian > 0;
        const Four residual = found.residual(alone.offset);
        Four move{residual.u * -0.5f, residual.v * -0.5f};
        if (jacobian > leastJacobian) {
            move = found.step(alone.offset);
            settled = lengthOf(move, 0) <= near / 16;
            if (settled) last = move;
            const float excess = lengthOf(move, 0) / (2 * lengthOf(residual, 0));
            if (excess > 1) move = {move.u / excess, move.v / excess};
        }
        alone.offset = {alone.offset.u + move.u, alone.offset.v + move.v};
    }
    std::array<HeightSample, 4> same;
    writeSamples(found, last, Int4{} + (smooth && settled ? 0 : 1), same.data());
    return same[0];
}

void HeightGrid::finish(const Search& search, HeightSample* out) const {
    const Found found = foundAt(search);
    const Four last = found.step(search.offset);
    const Float4 squared = last.u * last.u + last.v * last.v;
    const Int4 lost = search.steep | ~(found.jacobian() > leastStretch) | ~(squared <= near * near);
    writeSamples(found, last, Int4{}, out);
    const auto pairsLost = reinterpret_cast<Long2>(lost);
    if ((pairsLost[0] | pairsLost[1]) == 0) return;
    for (size_t l = 0; l < 4; ++l) {
        if (!lost[l]) continue;
        out[l] = search.nowhere[l] ? HeightSample{.folded = 1} : seekWithCare(search, l);
    }
}

void HeightGrid::sampleBlock(const double* points, size_t count, HeightSample* out) const {
    std::array<Search, block / 4> searches;
    const size_t whole = count / 4, fours = groupsOf(count);
    for (size_t i = 0; i < whole; ++i) place(searches[i], points + 8 * i);
    if (whole < fours) {
        std::array<double, 8> last{};
        std::copy_n(points + 8 * whole, 2 * (count % 4), last.begin());
        place(searches[whole], last.data());
    }
    for (size_t i = 0; i < fours; ++i) guess(searches[i]);
    for (size_t i = 0; i < fours; ++i) nearer(searches[i]);
    for (size_t i = 0; i < whole; ++i) finish(searches[i], out + 4 * i);
    if (whole == fours) return;
    std::array<HeightSample, 4> last;
    finish(searches[whole], last.data());
    std::copy_n(last.begin(), count % 4, out + 4 * whole);
}

HeightGrid* createHeightGrid(const Sea& sea, double time) {
    try {
        auto grid = std::make_unique<HeightGrid>(sea);
        grid->fill(time);
        return grid.release();
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void setTime(HeightGrid& grid, double time) {
    grid.fill(time);
}

void destroyHeightGrid(HeightGrid* grid) {
    delete grid;
}

void sampleHeights(const HeightGrid& grid, const double* points, size_t count, HeightSample* out) {
    if (grid.tiles.empty()) {
        std::fill_n(out, count, HeightSample{});
        return;
    }
    if (grid.sea.shore) return sampleHeights(grid.sea, grid.time, points, count, out);
    for (size_t first = 0; first < count; first += block)
        grid.sampleBlock(points + 2 * first, std::min(block, count - first), out + first);
}

} // namespace seaglass
