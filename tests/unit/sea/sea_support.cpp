#include "tests/unit/sea/sea_support.h"

#include "water/spectrum/dispersion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tests {

using namespace seaglass;
namespace {

constexpr double tau = 2 * std::numbers::pi;

// Adds the wave 2 Re a e^{i(k.x + wt)}; w may be negative.
void addWave(DirectSum& sum, std::complex<double> a, double ku, double kv, double omega, double angle,
             double chop) {
    const std::complex<double> wave = 2.0 * a * std::polar(1.0, angle);
    const double k = std::sqrt(ku * ku + kv * kv);
    const double c = wave.real(), s = wave.imag();
    // Water at a crest is drawn together: the displacement is -sin where the height is cos.
    sum.h += c;
    sum.hu -= ku * s;
    sum.hv -= kv * s;
    sum.dx -= chop * ku / k * s;
    sum.dz -= chop * kv / k * s;
    sum.dxu -= chop * ku * ku / k * c;
    sum.dxv -= chop * ku * kv / k * c;
    sum.dzv -= chop * kv * kv / k * c;
    sum.vx -= chop * ku / k * omega * c;
    sum.vy -= omega * s;
    sum.vz -= chop * kv / k * omega * c;
}

} // namespace

SeaPtr beachOf(const SwellDesc& swell, double slope, uint32_t offshore) {
    ShoreDesc shore;
    shore.samples[0] = 41;
    shore.samples[1] = offshore + 41;
    shore.origin[0] = -20;
    shore.origin[1] = -static_cast<double>(offshore);
    std::vector<float> bed;
    for (uint32_t j = 0; j < shore.samples[1]; ++j)
        bed.insert(bed.end(), shore.samples[0], static_cast<float>(slope * (shore.origin[1] + j)));
    shore.bed = bed.data();
    SeaDesc desc;
    desc.windSpeed = 0;
    desc.swells[0] = swell;
    desc.samples = 64;
    desc.cascades = 2;
    desc.shore = &shore;
    return makeSea(desc);
}

DirectSum directSum(const Sea& sea, uint32_t cascade, double time, double u, double v) {
    const Modes& modes = sea.modes[cascade];
    const double dk = tau / sea.cascades[cascade].patch;
    const double loop = sea.desc.loopPeriod;
    const double chop = sea.desc.choppiness;
    DirectSum sum;
    for (int32_t n = 0; n <= modes.reach; ++n) {
        for (int32_t m = -modes.reach; m <= modes.reach; ++m) {
            const size_t at = modes.at(m, n);
            if (modes.frequency[at] == 0) continue;
            const long double turns =
                modes.frequency[at] * (std::fmod(static_cast<long double>(time), loop) / loop);
            const double phase = tau * static_cast<double>(turns - std::floor(turns));
            const double omega = modes.frequency[at] * tau / loop;
            const double ku = m * dk, kv = n * dk;
            const double place = ku * u + kv * v;
            const std::complex<double> forward(modes.forwardRe[at], modes.forwardIm[at]);
            const std::complex<double> backward(modes.backwardRe[at], modes.backwardIm[at]);
            addWave(sum, forward, ku, kv, omega, place + phase, chop);
            addWave(sum, backward, ku, kv, -omega, place - phase, chop);
        }
    }
    return sum;
}

double moment(const Spectrum& spectrum, double low, double high, int power) {
    // In ln omega, where the spectrum is smooth; nothing lives below a fifth of the peak or far past it.
    const double from = std::log(std::max(low, spectrum.peak / 5));
    const double to = std::log(std::min(high, spectrum.peak * 1e4));
    constexpr int steps = 40000;
    const double step = (to - from) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double omega = std::exp(from + (i + 0.5) * step);
        sum += energy(spectrum, omega) * std::pow(omega, power + 1) * step;
    }
    return sum;
}

double slopeVariance(const Spectrum& spectrum, double kMax) {
    const double from = std::log(spectrum.peak * spectrum.peak / gravity / 9);
    constexpr int steps = 40000;
    const double step = (std::log(kMax) - from) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double k = std::exp(from + (i + 0.5) * step);
        sum += k * k * k * energy(spectrum, angularFrequency(k)) * groupSpeed(k) * step;
    }
    return sum;
}

} // namespace tests
