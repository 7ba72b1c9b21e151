// What the tests of the sea share.
#pragma once

#include "water/interface/waves_backend.h"
#include "water/sea/sea.h"
#include "water/spectrum/spectrum.h"

#include <complex>
#include <memory>
#include <vector>

namespace tests {

using namespace seaglass;

using SeaPtr = std::unique_ptr<Sea, decltype(&destroySea)>;

inline SeaPtr makeSea(const SeaDesc& desc) {
    return {createSea(&desc, nullptr), &destroySea};
}

/// A small sea of one cascade, gentle enough not to fold, and no warp: the tile as it is.
inline SeaDesc oneCascade() {
    SeaDesc desc;
    desc.samples = 64;
    desc.cascades = 1;
    desc.largestPatch = 512;
    desc.choppiness = 0.8f;
    desc.warp = 0;
    return desc;
}

/// Swell without wind over a plane that rises towards +v, from `offshore` metres before the water's edge at v
/// = 0.
SeaPtr beachOf(const SwellDesc& swell, double slope, uint32_t offshore);

/// One cascade's maps at one time.
struct Maps {
    size_t samples;
    std::vector<float> displacement, derivatives, moments;

    explicit Maps(size_t across)
        : samples(across), displacement(4 * across * across), derivatives(4 * across * across),
          moments(4 * across * across) {}

    CascadeMaps out() { return {displacement.data(), derivatives.data(), moments.data()}; }
    size_t texels() const { return samples * samples; }
    double height(size_t texel) const { return displacement[4 * texel + 1]; }
    double jacobian(size_t texel) const {
        const double shear = displacement[4 * texel + 3];
        return (1.0 + derivatives[4 * texel + 2]) * (1.0 + derivatives[4 * texel + 3]) - shear * shear;
    }
    bool operator==(const Maps&) const = default;
};

/// The backend that this build has: FFTW's, or one made of wave_truth.h, in doubles and slow.
const WavesBackend& builtBackend();

/// A backend on one sea.
class Waves {
  public:
    explicit Waves(const Sea& sea, const WavesBackend& backend = builtBackend())
        : sea_(sea), backend_(backend), state_(backend_.create(sea)) {}
    Waves(const Waves&) = delete;
    Waves& operator=(const Waves&) = delete;
    ~Waves() { backend_.destroy(state_); }

    Maps at(uint32_t cascade, double time) {
        Maps maps(description(sea_).samples);
        backend_.evaluate(state_, cascade, time, maps.out());
        return maps;
    }

  private:
    const Sea& sea_;
    const WavesBackend& backend_;
    void* state_;
};

/// All fields of one cascade at one point, summed wave by wave from the definition. Slow, and shares no code
/// with what it checks: each wave 2 Re h0 e^{i(k.x + wt)} on its own, its phase from the loop's fraction in
/// long double.
struct DirectSum {
    double h = 0, hu = 0, hv = 0;
    double dx = 0, dz = 0, dxu = 0, dxv = 0, dzv = 0;
    double vx = 0, vy = 0, vz = 0;
    double jacobian() const { return (1 + dxu) * (1 + dzv) - dxv * dxv; }
};
DirectSum directSum(const Sea& sea, uint32_t cascade, double time, double u, double v);

/// The integral of omega^power S over [low, high] [rad/s]; high may be infinite.
double moment(const Spectrum& spectrum, double low, double high, int power = 0);

/// The integral of k^2 S over the waves up to kMax [rad/m].
double slopeVariance(const Spectrum& spectrum, double kMax);

} // namespace tests
