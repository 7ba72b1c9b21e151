// Heights at many points of one time: every cascade's fields on its grid, by Fourier transform, and between
// its samples linearly, as a GPU's filter does, so that they are those of the surface that is drawn. The
// point of the calm plane that the horizontal displacement carries to the point asked for is sought as in
// heights.cpp, but for a block of points at a time, which then do not wait for each other's memory.
#include "seaglass/sea.h"

#include "water/fourier.h"
#include "water/phase.h"
#include "water/sea.h"

#include <algorithm>
#include <array>
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

// A sample of a cascade's grid. The search for a point reads the first 16 bytes of its 48 alone, so they lie
// apart.
struct Moves {
    float u, v;               ///< horizontal displacement [m]
    float stretchU, stretchV; ///< dDx/du, dDz/dv
};
struct Shape {
    float height, shear; ///< [m], dDx/dv
    float slopeU, slopeV;
    float drift, rise, driftV; ///< velocity [m/s]: u, up, v
    float unused;
};

Float4 load(const float* at) {
    Float4 value;
    __builtin_memcpy(&value, at, sizeof value);
    return value;
}

// Sample (i, j), at u = i patch/samples and v = j patch/samples, is number i * samples + j.
struct Tile {
    double patch = 0;    ///< [m]
    double perPatch = 0; ///< [1/m]
    float texelsPerMetre = 0;
    std::vector<Moves> moves;
    std::vector<Shape> shapes;
};

using Int4 = int __attribute__((vector_size(16)));

Float4 all(float value) {
    return Float4{value, value, value, value};
}

// Four places, or ways, along u and v.
struct Four {
    Float4 u, v;
};

// The four samples around each of four points, and where it lies between them.
struct Cells {
    std::array<Int4, 4> at; ///< here, next along v, next along u, next along both
    Four share;
};

Cells cellsAt(const Four& place, int samples) {
    const auto floorOf = [](const Float4& x) {
        const Int4 whole = __builtin_convertvector(x, Int4);
        return whole + (__builtin_convertvector(whole, Float4) > x); // true is -1
    };
    const Int4 i = floorOf(place.u), j = floorOf(place.v),
               mask = Int4{} + (samples - 1); // wraps negative ones too
    const Int4 row = (i & mask) * samples, next = ((i + 1) & mask) * samples;
    const Int4 left = j & mask, right = (j + 1) & mask;
    return {{row + left, row + right, next + left, next + right},
            {place.u - __builtin_convertvector(i, Float4), place.v - __builtin_convertvector(j, Float4)}};
}

// What `at` gives for each sample, between those around point `l`.
template<typename At>
Float4 mix(const Cells& cells, size_t l, At&& at) {
    const auto sample = [&](size_t corner) { return at(static_cast<size_t>(cells.at[corner][l])); };
    const Float4 alongU = all(cells.share.u[l]), alongV = all(cells.share.v[l]);
    const Float4 here = sample(0), next = sample(2);
    const Float4 low = here + alongV * (sample(1) - here);
    return low + alongU * (next + alongV * (sample(3) - next) - low);
}

// Four times four values to four of each.
void transpose(std::array<Float4, 4>& rows) {
    const Float4 a = __builtin_shuffle(rows[0], rows[1], Int4{0, 4, 1, 5});
    const Float4 b = __builtin_shuffle(rows[2], rows[3], Int4{0, 4, 1, 5});
    const Float4 c = __builtin_shuffle(rows[0], rows[1], Int4{2, 6, 3, 7});
    const Float4 d = __builtin_shuffle(rows[2], rows[3], Int4{2, 6, 3, 7});
    rows = {__builtin_shuffle(a, b, Int4{0, 1, 4, 5}), __builtin_shuffle(a, b, Int4{2, 3, 6, 7}),
            __builtin_shuffle(c, d, Int4{0, 1, 4, 5}), __builtin_shuffle(c, d, Int4{2, 3, 6, 7})};
}

// Four points: where they lie on each tile, in samples, and how far from them the water rests that is seen
// there.
struct Search {
    std::array<Four, maxCascades> sample{};
    Four offset{};
    Int4 steep{}; ///< on the way, or out of reach: to be sought with care
};

// All that is known at four resting points, as Moves and Shape.
struct Found {
    std::array<Float4, 4> moves, shape, velocity;

    Float4 stretchU() const { return moves[2]; }
    Float4 stretchV() const { return moves[3]; }
    Float4 shear() const { return shape[1]; }
    Float4 jacobian() const { return (1 + stretchU()) * (1 + stretchV()) - shear() * shear(); }
    Four residual(const Four& offset) const { return {offset.u + moves[0], offset.v + moves[1]}; }
    // Newton's step to where the displacement leads to the point.
    Four step(const Four& offset) const {
        const Four r = residual(offset);
        const Float4 j = jacobian();
        return {-((1 + stretchV()) * r.u - shear() * r.v) / j, -((1 + stretchU()) * r.v - shear() * r.u) / j};
    }
};

float lengthOf(const Four& a, size_t l) {
    return std::sqrt(a.u[l] * a.u[l] + a.v[l] * a.v[l]);
}

} // namespace

struct HeightGrid {
    const Sea& sea;
    InverseFourier fourier;
    std::vector<Tile> tiles;
    std::vector<Complex4> columns, rows, scratch;
    std::vector<Complex> heights, rates; ///< of the modes of one cascade
    float near = 0;                      ///< from where one linear step does [m]

    explicit HeightGrid(const Sea& from);
    void fill(double time);
    void sampleBlock(const double* points, size_t count, HeightSample* out) const;

  private:
    void advance(const Modes& modes, uint32_t now);
    void transform(uint32_t cascade, size_t pair);
    void store(Tile& tile, size_t pair) const;

    void place(Search& search, size_t l, double u, double v) const;
    Cells cells(size_t tile, const Search& search) const;
    void nearer(Search& search) const;
    Found foundAt(const Search& search) const;
    void finish(const Search& search, HeightSample* out) const;
    HeightSample seekWithCare(const Search& search, size_t l) const;
};

namespace {

constexpr size_t pairs = 6;    ///< complex fields
constexpr size_t block = 16;   ///< points that are sought together
constexpr int rounds = 2;      ///< of the search that all points take part in
constexpr int moreRounds = 25; ///< for those that have not arrived by then
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

HeightGrid::HeightGrid(const Sea& from) : sea(from), fourier(from.desc.samples), tiles(from.count) {
    const size_t samples = from.desc.samples;
    size_t widest = 0;
    for (uint32_t c = 0; c < from.count; ++c) {
        tiles[c].patch = from.cascades[c].patch;
        tiles[c].perPatch = 1 / tiles[c].patch;
        tiles[c].texelsPerMetre = static_cast<float>(static_cast<double>(samples) / tiles[c].patch);
        tiles[c].moves.resize(samples * samples);
        tiles[c].shapes.resize(samples * samples);
        widest = std::max(widest, groupsOf(2 * static_cast<size_t>(from.modes[c].reach) + 1));
    }
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

void HeightGrid::store(Tile& tile, size_t pair) const {
    for (size_t i = 0; i < tile.moves.size(); ++i) {
        const Complex4& from = rows[i / lanes];
        const float re = from.re[i % lanes], im = from.im[i % lanes];
        Moves& moves = tile.moves[i];
        Shape& shape = tile.shapes[i];
        switch (pair) {
        case 0:
            moves.u = re, moves.v = im;
            break;
        case 1:
            moves.stretchU = re, moves.stretchV = im;
            break;
        case 2:
            shape.height = re, shape.shear = im;
            break;
        case 3:
            shape.slopeU = re, shape.slopeV = im;
            break;
        case 4:
            shape.drift = re, shape.rise = im;
            break;
        default:
            shape.driftV = re;
        }
    }
}

void HeightGrid::fill(double time) {
    const uint32_t now = loopPhase(time, sea.desc.loopPeriod);
    for (uint32_t c = 0; c < sea.count; ++c) {
        advance(sea.modes[c], now);
        for (size_t pair = 0; pair < pairs; ++pair) {
            transform(c, pair);
            store(tiles[c], pair);
        }
    }
}

void HeightGrid::place(Search& search, size_t l, double u, double v) const {
    constexpr double farthest = 1e12; // [m]: whole tiles still fit an integer
    const bool far = !(std::abs(u) < farthest && std::abs(v) < farthest);
    search.steep[l] = far ? -1 : 0;
    if (!(std::isfinite(u) && std::isfinite(v))) return;
    const auto inTile = [&](double x, const Tile& tile) {
        if (far) return static_cast<float>(std::fmod(x, tile.patch)) * tile.texelsPerMetre;
        const double tilesAway = x * tile.perPatch;
        return static_cast<float>(tilesAway - static_cast<double>(static_cast<int64_t>(tilesAway))) *
               static_cast<float>(sea.desc.samples);
    };
    for (size_t c = 0; c < tiles.size(); ++c) {
        search.sample[c].u[l] = inTile(u, tiles[c]);
        search.sample[c].v[l] = inTile(v, tiles[c]);
    }
}

Cells HeightGrid::cells(size_t tile, const Search& search) const {
    const float scale = tiles[tile].texelsPerMetre;
    const Four& sample = search.sample[tile];
    return cellsAt({sample.u + search.offset.u * scale, sample.v + search.offset.v * scale},
                   static_cast<int>(sea.desc.samples));
}

// Newton's step without the shear; where it would fly off it is left to seekWithCare().
void HeightGrid::nearer(Search& search) const {
    std::array<Float4, 4> moves{};
    for (size_t c = 0; c < tiles.size(); ++c) {
        const Cells around = cells(c, search);
        const Moves* all = tiles[c].moves.data();
        for (size_t l = 0; l < 4; ++l)
            moves[l] += mix(around, l, [all](size_t i) { return load(&all[i].u); });
    }
    transpose(moves);
    const Float4 alongU = 1 + moves[2], alongV = 1 + moves[3], least = all(leastStretch);
    search.steep |= (alongU < least) | (alongV < least);
    search.offset.u -= (search.offset.u + moves[0]) / (alongU < least ? least : alongU);
    search.offset.v -= (search.offset.v + moves[1]) / (alongV < least ? least : alongV);
}

Found HeightGrid::foundAt(const Search& search) const {
    Found found{};
    for (size_t c = 0; c < tiles.size(); ++c) {
        const Cells around = cells(c, search);
        const Moves* moves = tiles[c].moves.data();
        const Shape* shapes = tiles[c].shapes.data();
        for (size_t l = 0; l < 4; ++l) {
            found.moves[l] += mix(around, l, [moves](size_t i) { return load(&moves[i].u); });
            found.shape[l] += mix(around, l, [shapes](size_t i) { return load(&shapes[i].height); });
            found.velocity[l] += mix(around, l, [shapes](size_t i) { return load(&shapes[i].drift); });
        }
    }
    transpose(found.moves);
    transpose(found.shape);
    transpose(found.velocity);
    return found;
}

namespace {

// With a last step of the search, along which the surface is taken for flat.
void writeSamples(const Found& found, const Four& last, const Int4& folded, HeightSample* out) {
    const auto [height, shear, slopeU, slopeV] = found.shape;
    const Float4 jacobian = found.jacobian(), level = height + slopeU * last.u + slopeV * last.v;
    // Across the displaced surface's tangents; turned upwards where it has overturned.
    const Float4 side = jacobian < 0 ? all(-1) : all(1), up = side * jacobian;
    const Float4 u = side * (slopeV * shear - slopeU * (1 + found.stretchV()));
    const Float4 v = side * (slopeU * shear - slopeV * (1 + found.stretchU()));
    const Float4 squared = u * u + up * up + v * v;
    for (size_t l = 0; l < 4; ++l) {
        HeightSample& sample = out[l];
        sample.height = level[l];
        const bool upright = squared[l] > 0;
        const float scale = upright ? 1 / std::sqrt(squared[l]) : 0;
        sample.normal[0] = u[l] * scale;
        sample.normal[1] = upright ? up[l] * scale : 1;
        sample.normal[2] = v[l] * scale;
        for (size_t axis = 0; axis < 3; ++axis) sample.velocity[axis] = found.velocity[axis][l];
        sample.folded = folded[l] ? 1 : 0;
    }
}

} // namespace

// As heights.cpp's invert(). Folded where the surface overturned on the way, or the search did not settle.
HeightSample HeightGrid::seekWithCare(const Search& search, size_t l) const {
    constexpr float leastJacobian = 0.05f;
    Search alone; // four times the same
    for (size_t c = 0; c < tiles.size(); ++c)
        alone.sample[c] = {all(search.sample[c].u[l]), all(search.sample[c].v[l])};
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
    writeSamples(found, last, Int4{} + (smooth && settled ? 0 : -1), same.data());
    return same[0];
}

void HeightGrid::finish(const Search& search, HeightSample* out) const {
    const Found found = foundAt(search);
    const Four last = found.step(search.offset);
    const Float4 squared = last.u * last.u + last.v * last.v;
    const Int4 arrived = ~search.steep & (found.jacobian() > leastStretch) & (squared <= near * near);
    writeSamples(found, last, Int4{}, out);
    for (size_t l = 0; l < 4; ++l)
        if (!arrived[l]) out[l] = seekWithCare(search, l);
}

void HeightGrid::sampleBlock(const double* points, size_t count, HeightSample* out) const {
    std::array<Search, block / 4> searches;
    std::array<HeightSample, block> samples;
    for (size_t i = 0; i < count; ++i) place(searches[i / 4], i % 4, points[2 * i], points[2 * i + 1]);
    const size_t fours = groupsOf(count);
    for (int round = 0; round < rounds; ++round)
        for (size_t i = 0; i < fours; ++i) nearer(searches[i]);
    for (size_t i = 0; i < fours; ++i) finish(searches[i], &samples[4 * i]);
    for (size_t i = 0; i < count; ++i) {
        const bool finite = std::isfinite(points[2 * i]) && std::isfinite(points[2 * i + 1]);
        out[i] = finite ? samples[i] : HeightSample{.folded = 1};
    }
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
    for (size_t first = 0; first < count; first += block)
        grid.sampleBlock(points + 2 * first, std::min(block, count - first), out + first);
}

} // namespace seaglass
