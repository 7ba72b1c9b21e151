// The sea itself: spectrum, waves and heights, with no Vulkan: a server can link seaglass::sea alone. It is a
// function of (desc, time) alone, to the bit.
//
// Local frame: u and v are metres along a body's calm plane n.p + d = 0, n unit: world x and z where level,
// else (x, z) - (n.x, n.z) (y - d) / (1 + n.y) of its points; height is along n, above the calm plane.
#pragma once

#include <cstddef>

#include "seaglass/fields.h"

namespace seaglass {

constexpr uint32_t maxCascades = 4;           ///< of a sea
constexpr uint32_t maxSwells = 4;             ///< of a SeaDesc
constexpr uint32_t maxSpectrumSamples = 4096; ///< of a SeaDesc

/// How the wind sea's energy lies over frequency.
enum class SpectrumModel : uint32_t {
    jonswap = 0,          ///< grows with wind and fetch (Hasselmann et al. 1973)
    piersonMoskowitz = 1, ///< fully developed, by the wind alone (Pierson and Moskowitz 1964)
    tma = 2,              ///< JONSWAP over a bottom: times Kitaigorodskii's factor (Bouws et al. 1985)
    phillips = 3, ///< alpha/2 k^-3 exp(-1/(k L)^2), L = U^2/g, alpha 0.0081 (Tessendorf 2001): in his terms
                  ///< an amplitude of 1.29e-3 without his cos^2, which the spreading replaces
    table = 4     ///< SeaDesc.spectrumTable
};
/// Its names, from 0 on.
inline constexpr const char* spectrumModels[] = {"jonswap", "pierson-moskowitz", "tma", "phillips", "table"};

/// How energy lies over direction, at each frequency; each integrates to 1 over the circle.
enum class SpreadingModel : uint32_t {
    hasselmann = 0,    ///< cos^2s(theta/2), s by frequency and wave age (Hasselmann et al. 1980)
    mitsuyasu = 1,     ///< the same with s of Mitsuyasu et al. 1975
    donelanBanner = 2, ///< sech^2(beta theta) (Donelan et al. 1985, Banner 1990)
    cosine2s = 3       ///< cos^2s(theta/2) with SeaDesc.spreadingShape everywhere
};
/// Its names, from 0 on.
inline constexpr const char* spreadingModels[] = {"hasselmann", "mitsuyasu", "donelan-banner", "cos2s"};

/// One point of a measured spectrum, as buoys report it.
struct SpectrumSample {
    float frequency = 0; ///< [Hz], 0.01..50
    float density = 0;   ///< [m^2/Hz], 0..1e6
};

/// Waves that have left the wind that made them: long, of nearly one period and direction.
struct SwellDesc {
    float height = 0;        ///< their own significant wave height [m], 0..30; 0: none
    float peakPeriod = 12;   ///< [s], 1..30
    float direction = 0;     ///< where they run towards, from +u to +v [rad]
    float bandwidth = 0.08f; ///< standard deviation of frequency, as a share of the peak's, 0.02..0.25
    float spreading = 50;    ///< s of cos^2s(theta/2), 0..1000
};

/// A bed that waves slow down, turn and break over, and run up: docs/surface.md. Beyond, as at its edge.
struct ShoreDesc {
    const float* bed = nullptr;   ///< heights above the calm plane [m], -1e4..1e4; rows along u, v rising
    uint32_t samples[2] = {0, 0}; ///< along u and v, 2..1024
    float spacing = 1;            ///< of samples [m], 0.05..100
    double origin[2] = {0, 0};    ///< (u, v) of the first [m], -1e6..1e6
};

/// A wind sea and up to maxSwells swells; their energies add. Copied by createSea, pointees included.
struct SeaDesc {
    SpectrumModel spectrum = SpectrumModel::jonswap; ///< of the wind sea
    float windSpeed = 10.0f;                         ///< U10, at 10 m [m/s], 0..100; 0: no wind sea
    float windDirection = 0.0f;                      ///< where it blows towards, from +u to +v [rad]
    float fetch = 300e3f;                            ///< [m], 1..1e6
    bool capFetch = true;         ///< hold g F / U^2 at 1e4, past which JONSWAP exceeds a fully developed sea
    float peakEnhancement = 3.3f; ///< JONSWAP gamma, 1..10
    /// Of the water [m], 0..infinity; 0: flat. Shallow water shortens and slows waves; only `tma` lowers
    /// them, other models say what waves there are.
    float depth = std::numeric_limits<float>::infinity();
    SpreadingModel spreading = SpreadingModel::hasselmann; ///< of the wind sea
    float spreadingShape = 5;                              ///< s of `cosine2s`, 0..1000
    float swell = 0.0f; ///< elongation of the directional spreading, 0..1 (Horvath 2015)
    /// Of `table`: at rising frequencies, linear between and nothing outside; 2..maxSpectrumSamples.
    const SpectrumSample* spectrumTable = nullptr;
    uint32_t spectrumTableCount = 0;  ///< of spectrumTable
    SwellDesc swells[maxSwells] = {}; ///< those of height 0 are none
    float amplitude = 1.0f;  ///< scale of all heights, 0..1: less is water that something shelters, 0 flat
    float choppiness = 1.0f; ///< scale of the horizontal displacement, 0..10; 1 is the linear theory's
    uint32_t samples = 256;  ///< across each cascade, power of two, 16..2048; 256 and more share waves
    uint32_t cascades = 3;   ///< 1..maxCascades
    /// Edge of the largest cascade [m], 1..1e5; resolvedShare() says what it loses. 0 chooses: 16 wavelengths
    /// of the longest peak in 60..2000 m, but at least 6, and no more than the samples carry.
    float largestPatch = 0.0f;
    /// How far waves stand aside of their places in their tiles, 0..1, so that tiles do not show: lengths
    /// vary by a tenth or two. 0: the sea repeats exactly after each cascade's patch.
    float warp = 1.0f;
    const ShoreDesc* shore = nullptr; ///< null: no bed is felt but `depth`, and none costs anything
    double loopPeriod = 4096.0;       ///< time after which the sea repeats exactly [s], 16..1e6
    uint64_t seed = 1;                ///< of the waves' phases and amplitudes
};

/// The open sea at a force of Beaufort's scale, 0 (flat) to 12, at its probable significant wave height: of
/// mean wind, a plausible fetch and, up to force 5, older waves.
SeaDesc beaufortSea(uint32_t force, float windDirection = 0.0f);

/// One band of wave vectors on its own tile. Each wave vector of the sea lives in exactly one cascade.
struct Cascade {
    double patch = 0;     ///< tile edge [m]
    uint32_t samples = 0; ///< across the tile
    double kMin = 0;      ///< wave numbers kMin <= k < kMax [rad/m]; at least 4 samples a wave
    double kMax = 0;      ///< likewise
    double variance = 0;  ///< of height, from the modes it holds [m^2]
};

struct Sea;

/// What was wrong.
struct SeaError {
    char text[200] = {}; ///< a line, cut to fit, that ends with a zero; empty: all is well
};

/// Draws the modes. Null on a bad field or when out of memory, which `error` names.
Sea* createSea(const SeaDesc* desc, SeaError* error);
void destroySea(Sea* sea); ///< null is ignored

const SeaDesc& description(const Sea& sea);             ///< as it was given
uint32_t cascadeCount(const Sea& sea);                  ///< 0 when the sea is flat
const Cascade& cascade(const Sea& sea, uint32_t index); ///< index < cascadeCount
double peakFrequency(const Sea& sea); ///< of the system with the greatest peak [rad/s]; 0 when flat
/// S(omega) of all systems together as asked for, resolved or not [m^2 s]; 0 when flat.
double frequencySpectrum(const Sea& sea, double omega);
double significantWaveHeight(const Sea& sea); ///< 4 sqrt(m0) of the modes held [m]
/// Share of the spectra's height variance that the cascades hold, in the mean of all seeds: about 1, less
/// where waves are too long for `largestPatch` or too short for the samples; 1 when flat. Below
/// leastResolvedShare heights are off by 5 % or more.
double resolvedShare(const Sea& sea);
constexpr double leastResolvedShare = 0.9; ///< of the height's variance

/// Variances and covariance of the surface's slopes.
struct SlopeCovariance {
    double uu = 0; ///< of dh/du
    double vv = 0; ///< of dh/dv
    double uv = 0; ///< of both
};

SlopeCovariance resolvedSlopes(const Sea& sea); ///< of the waves that the cascades hold
/// Of all that is shorter. With the resolved slopes it makes Cox and Munk's variance, times amplitude^2.
SlopeCovariance roughness(const Sea& sea);
double resolvedSlopeVariance(const Sea& sea);   ///< both axes together
double unresolvedSlopeVariance(const Sea& sea); ///< of the roughness, both axes together

/// Slope variance of a clean sea, both axes together, 0.003 + 5.12e-3 U at 12.5 m (Cox and Munk 1954), from
/// U10 [m/s]: less below 1 m/s, where water turns to glass, and no more past 30 m/s.
double coxMunkSlopeVariance(double windSpeed);

/// One cascade's grid at one time: maps of samples*samples texels, four floats each, rows along v. Texel (i,
/// j) is at u = i patch/samples, v = j patch/samples, and at [(j*samples + i)*4]. The tile repeats; `warp`
/// shifts what lies where. h is the height, (Dx, Dz) the horizontal displacement, choppiness included.
struct CascadeMaps {
    float* displacement = nullptr; ///< Dx, h, Dz, dDx/dv (= dDz/du)            [m, m, m, 1]
    float* derivatives = nullptr;  ///< dh/du, dh/dv, dDx/du, dDz/dv            [1]
    float* moments = nullptr;      ///< (dh/du)^2, (dh/dv)^2, dh/du*dh/dv, dDx/dv: what shading needs beside
};

/// How a sea is evaluated on its grids: from a backend's header, never filled in by the host.
struct WavesBackend {
    const char* name = nullptr; ///< for people
    /// Makes what the backend keeps for a sea, which must outlive it. Null: out of memory. Any thread.
    void* (*create)(const Sea& sea) = nullptr;
    void (*destroy)(void* state) = nullptr; ///< of what create() made
    /// Fills all maps of one cascade. Calls with one state must not overlap. Not finite times count as 0.
    void (*evaluate)(void* state, uint32_t cascade, double time, const CascadeMaps& out) = nullptr;
};

/// The surface at one point.
struct HeightSample {
    float height = 0;              ///< above the calm plane [m]
    float normal[3] = {0, 1, 0};   ///< unit: u, up, v
    float velocity[3] = {0, 0, 0}; ///< of the water at the surface: u, up, v [m/s]
    uint32_t folded = 0;           ///< 1 where the surface overturns near by: height may be one of several
};

/// Heights at `count` points (u, v in metres, interleaved) at any time, future included. Exact: sums every
/// mode, O(modes) a point and as much again a call. A point that is not finite, and every point when out of
/// memory, gets a calm sample marked folded. Any thread, several at once.
void sampleHeights(const Sea& sea, double time, const double* points, size_t count, HeightSample* out);

/// A sea at one time, laid out for many queries: 48 bytes a sample of each cascade (9.4 MB for three of 256
/// across). Linear between samples, as the drawn surface: 0.8 % of Hs off the sum of modes in the mean, 5 %
/// at most.
struct HeightGrid;

/// Null when out of memory. The sea must outlive it. A time that is not finite counts as 0. Any thread.
HeightGrid* createHeightGrid(const Sea& sea, double time);
void setTime(HeightGrid& grid, double time); ///< nothing is allocated; not while it is sampled
void destroyHeightGrid(HeightGrid* grid);    ///< null is ignored

/// Of a sea at the grid's time. Any thread, several at once.
void sampleHeights(const HeightGrid& grid, const double* points, size_t count, HeightSample* out);

FieldTable fieldsOf(const SeaDesc&);        ///< its settings
FieldTable fieldsOf(const SpectrumSample&); ///< its settings
FieldTable fieldsOf(const SwellDesc&);      ///< its settings
FieldTable fieldsOf(const ShoreDesc&);      ///< its settings

} // namespace seaglass
