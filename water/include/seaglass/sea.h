// The sea itself: spectrum, waves and heights, with no Vulkan, so that a server can link it alone
// (seaglass::sea).
//
// A sea is a fixed function of (desc, time): the same bits for the same seed and time, whatever was asked
// before. Local frame: u and v are horizontal metres (u = world x, v = world z for a body whose plane faces
// +Y), height is along the plane's normal, above the calm plane.
#ifndef SEAGLASS_SEA_H
#define SEAGLASS_SEA_H

#include <cstddef>
#include <cstdint>

namespace seaglass {

constexpr uint32_t maxCascades = 4;

enum class SpectrumModel : uint32_t { jonswap = 0, piersonMoskowitz = 1 };

struct SeaDesc {
    SpectrumModel spectrum = SpectrumModel::jonswap;
    float windSpeed = 10.0f;      ///< U10, at 10 m [m/s], 0..60; 0 is a flat sea, by branch
    float windDirection = 0.0f;   ///< where it blows towards, from +u to +v [rad]
    float fetch = 300e3f;         ///< [m], 1..1e7
    bool capFetch = true;         ///< hold g F / U^2 at 1e4, past which JONSWAP exceeds a fully developed sea
    float peakEnhancement = 3.3f; ///< JONSWAP gamma, 1..10
    float swell = 0.0f;           ///< elongation of the directional spreading, 0..1 (Horvath 2015)
    /// Scale of all heights, 0..1: 1 is the spectrum's own sea, less is water that something shelters; 0 is
    /// flat.
    float amplitude = 1.0f;
    float choppiness = 1.0f; ///< scale of the horizontal displacement, 0..10; 1 is the linear theory's
    uint32_t samples = 256;  ///< across each cascade, power of two, 16..1024; from 256 up, fewer samples are
                             ///< the same sea without its shortest waves
    uint32_t cascades = 3;   ///< 1..maxCascades
    float largestPatch =
        0.0f; ///< edge of the largest cascade [m], 1..1e5; 0 is 16 peak wavelengths, in 60..2000
    double loopPeriod = 4096.0; ///< time after which the sea repeats exactly [s], 16..1e6
    uint64_t seed = 1;
};

/// One band of wave vectors on its own tile. Each wave vector of the sea lives in exactly one cascade.
struct Cascade {
    double patch = 0;     ///< tile edge [m]
    uint32_t samples = 0; ///< across the tile
    double kMin = 0;      ///< wave numbers kMin <= k < kMax [rad/m]; at least 4 samples a wave
    double kMax = 0;
    double variance = 0; ///< of height, from the modes it holds [m^2]
};

struct Sea;

/// Errors as a line of text, cut to fit; empty when all is well.
struct SeaError {
    char text[200] = {};
};

/// Checks the description and draws the modes. Null on a bad field or when out of memory, which `error`
/// names.
Sea* createSea(const SeaDesc* desc, SeaError* error);
void destroySea(Sea* sea);

const SeaDesc& description(const Sea& sea);
uint32_t cascadeCount(const Sea& sea);                  ///< 0 when the sea is flat
const Cascade& cascade(const Sea& sea, uint32_t index); ///< index < cascadeCount
double peakFrequency(const Sea& sea);                   ///< [rad/s], 0 when flat
double significantWaveHeight(const Sea& sea);           ///< 4 sqrt(m0) of the modes held [m]
/// Slope variance (both axes together) of the waves that the cascades hold.
double resolvedSlopeVariance(const Sea& sea);
/// Slope variance (both axes together) of the waves shorter than the shortest mode: a surface's roughness.
double unresolvedSlopeVariance(const Sea& sea);

/// The surface on one cascade's grid at one time: three maps of samples*samples texels, four floats each,
/// rows along v. Texel (i, j) is at u = i patch/samples, v = j patch/samples, and at [(j*samples + i)*4]; the
/// tile repeats. With h the height and (Dx, Dz) the horizontal displacement (choppiness included):
struct CascadeMaps {
    float* displacement = nullptr; ///< Dx, h, Dz, dDx/dv (= dDz/du)            [m, m, m, 1]
    float* derivatives = nullptr;  ///< dh/du, dh/dv, dDx/du, dDz/dv            [1]
    float* moments = nullptr;      ///< (dh/du)^2, (dh/dv)^2, dh/du*dh/dv, (dDx/du + dDz/dv)^2
};

/// How a sea is evaluated on its grids. Obtained from a backend's header; never filled in by the host.
struct WavesBackend {
    const char* name = nullptr;
    /// Makes whatever the backend keeps for one sea (plans, scratch), which must outlive it. Null when out of
    /// memory. Any thread.
    void* (*create)(const Sea& sea) = nullptr;
    void (*destroy)(void* state) = nullptr;
    /// Fills all maps of one cascade, index < cascadeCount. Calls with the same state must not overlap. A
    /// time that is not finite counts as 0.
    void (*evaluate)(void* state, uint32_t cascade, double time, const CascadeMaps& out) = nullptr;
};

struct HeightSample {
    float height = 0;              ///< above the calm plane [m]
    float normal[3] = {0, 1, 0};   ///< unit: u, up, v
    float velocity[3] = {0, 0, 0}; ///< of the water at the surface: u, up, v [m/s]
    uint32_t folded = 0; ///< 1 where the surface overturns at or near the point, or the search did not
                         ///< settle: height may be one of several
};

/// Heights at `count` points (u, v in metres, interleaved) at any time, future included. No GPU. Any thread,
/// several at once. Sums every mode, so it is exact for the sea and costs O(modes) a point, and as much again
/// a call. A point that is not finite, and every point when out of memory, gets a calm sample marked folded.
void sampleHeights(const Sea& sea, double time, const double* points, size_t count, HeightSample* out);

} // namespace seaglass

#endif
