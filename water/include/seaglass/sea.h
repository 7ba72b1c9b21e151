// The sea itself: waves, heights and foam, with no Vulkan: a server can link seaglass::sea alone. It is a
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
    float depth = std::numeric_limits<float>::infinity();  ///< [m], 0 (flat) .. infinity: makes waves shorter
                                                           ///< and slower; only `tma` also makes them lower
    SpreadingModel spreading = SpreadingModel::hasselmann; ///< of the wind sea
    float spreadingShape = 5;                              ///< s of `cosine2s`, 0..1000
    float swell = 0.0f; ///< elongation of the directional spreading, 0..1 (Horvath 2015)
    const SpectrumSample* spectrumTable = nullptr; ///< of `table`: frequencies rise; linear between them
    uint32_t spectrumTableCount = 0;               ///< 2..maxSpectrumSamples
    SwellDesc swells[maxSwells] = {};              ///< those of height 0 are none
    float amplitude = 1.0f;  ///< scale of all heights, 0..1: less is water that something shelters, 0 flat
    float choppiness = 1.0f; ///< scale of the horizontal displacement, 0..10; 1 is the linear theory's
    uint32_t samples = 256;  ///< across each cascade, power of two, 16..2048; 256 and more share waves
    uint32_t cascades = 3;   ///< 1..maxCascades
    /// Edge of the largest cascade [m], 1..1e5; resolvedShare() says what it loses. 0 chooses: 16 wavelengths
    /// of the longest peak in 60..2000 m, but at least 6, and no more than the samples carry.
    float largestPatch = 0.0f;
    float warp = 1.0f; ///< how far waves stand aside of their places, 0..1, so that tiles do not show:
                       ///< lengths vary by a tenth or two; 0: the sea repeats after each cascade's patch
    const ShoreDesc* shore = nullptr; ///< null: no bed is felt but `depth`, and none costs anything
    double loopPeriod = 4096.0;       ///< time after which the sea repeats exactly [s], 16..1e6
    uint64_t seed = 1;                ///< of the waves' phases and amplitudes
};

/// The open sea at a force of Beaufort's scale, 0 (flat) to 12, at its probable significant wave height: of
/// mean wind, a plausible fetch and, up to force 5, older waves.
SeaDesc beaufortSea(uint32_t force, float windDirection = 0.0f);

struct Sea;

/// What was wrong.
struct SeaError {
    char text[200] = {}; ///< a line, cut to fit, that ends with a zero; empty: all is well
};

/// Draws the modes. Null on a bad field or when out of memory, which `error` names.
Sea* createSea(const SeaDesc* desc, SeaError* error);
void destroySea(Sea* sea); ///< null is ignored

const SeaDesc& description(const Sea& sea);     ///< as it was given
double peakFrequency(const Sea& sea);           ///< of the system with the greatest peak [rad/s]; 0 when flat
double significantWaveHeight(const Sea& sea);   ///< 4 sqrt(m0) of the waves that the cascades hold [m]
double resolvedSlopeVariance(const Sea& sea);   ///< of these waves, both axes together
double unresolvedSlopeVariance(const Sea& sea); ///< of all shorter: with these Cox and Munk's, by amplitude^2
/// Share of the spectra's height variance that the cascades hold, in the mean of all seeds: about 1, less
/// where waves are too long for `largestPatch` or too short for the samples; 1 when flat. Below
/// leastResolvedShare heights are off by 5 % or more.
double resolvedShare(const Sea& sea);
constexpr double leastResolvedShare = 0.9; ///< of the height's variance

/// How a sea is evaluated on its grids: from a backend's header, such as waves_fftw.h.
struct WavesBackend;

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

/// Foam on breaking crests. A wave breaks where the horizontal displacement of all cascades compresses its
/// surface past a threshold, along the wind above all. Foam drifts with the water and fades: it dies after
/// two or three decay times, bubbles below after nine. Steps of 1/4 s make it a function of the sea and the
/// time alone, whatever frames were drawn, but for hosts that fall behind: simulate().
struct FoamDesc {
    float bias = 0.0f;       ///< off the compression at which waves break, -1..1; 0: as whitecap laws say
    float decayTime = 3.85f; ///< to 1/e in the mean [s], 0.1..20 (Monahan and Zietlow 1969: salt water 3.85)
    float albedo = 0.6f;     ///< diffuse albedo of full foam, 0..1 (Koepke 1984: fresh foam about 0.5)
};

} // namespace seaglass
