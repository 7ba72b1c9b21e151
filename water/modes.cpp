#include "water/modes.h"

#include "water/dispersion.h"
#include "water/phase.h"
#include "water/spreading.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace seaglass {
namespace {

// SplitMix64's finaliser (Steele, Lea and Flood 2014).
uint64_t scramble(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// In (0, 1], for the logarithm's sake.
double uniform(uint64_t bits) {
    return (static_cast<double>(bits >> 11) + 1) * 0x1p-53;
}

// Two unit normal variates that belong to the mode (Box and Muller 1958).
std::complex<double> normals(uint64_t seed, uint32_t cascade, int32_t m, int32_t n) {
    const uint64_t place = static_cast<uint64_t>(static_cast<uint32_t>(m)) << 32 | static_cast<uint32_t>(n);
    const uint64_t first = scramble(scramble(scramble(seed) ^ cascade) ^ place);
    const uint64_t second = scramble(first);
    return std::polar(std::sqrt(-2 * std::log(uniform(first))), 2 * std::numbers::pi * uniform(second));
}

struct Sheet {
    const SeaDesc& desc;
    const Spectrum& spectrum;
    uint32_t cascade;
    double dk;
    double windU = std::cos(static_cast<double>(desc.windDirection));
    double windV = std::sin(static_cast<double>(desc.windDirection));

    // h0 at (m, n) * dk, whose length is k.
    std::complex<float> amplitude(int32_t m, int32_t n, double k) const {
        const double omega = angularFrequency(k);
        // h0(k) travels towards -k.
        const double cosine = -(m * windU + n * windV) * dk / k;
        const double shape = spreadingShape(spectrum, omega, static_cast<double>(desc.swell));
        const double density = energy(spectrum, omega) * spreading(shape, cosine) * groupSpeed(k) / k;
        return std::complex<float>(normals(desc.seed, cascade, m, n) *
                                   (0.5 * static_cast<double>(desc.amplitude) * std::sqrt(density) * dk));
    }
};

int32_t latticeReach(const Cascade& cascade, double dk) {
    auto reach = static_cast<int32_t>(std::ceil(cascade.kMax / dk)) - 1;
    while (reach > 0 && reach * dk >= cascade.kMax) --reach;
    return reach > 0 ? reach : 0;
}

} // namespace

Modes drawModes(const SeaDesc& desc, const Spectrum& spectrum, uint32_t index, Cascade& cascade) {
    const double dk = 2 * std::numbers::pi / cascade.patch;
    Modes modes;
    modes.reach = latticeReach(cascade, dk);
    modes.pitch = (static_cast<size_t>(2 * modes.reach) + Modes::lanes) / Modes::lanes * Modes::lanes;
    const size_t count = modes.pitch * static_cast<size_t>(modes.reach + 1);
    for (auto* values :
         {&modes.forwardRe, &modes.forwardIm, &modes.backwardRe, &modes.backwardIm, &modes.inverseK})
        values->assign(count, 0.0f);
    modes.frequency.assign(count, 0);

    const Sheet sheet{.desc = desc, .spectrum = spectrum, .cascade = index, .dk = dk};
    double variance = 0;
    for (int32_t n = 0; n <= modes.reach; ++n) {
        for (int32_t m = n > 0 ? -modes.reach : 1; m <= modes.reach; ++m) {
            const double k = dk * std::sqrt(static_cast<double>(m) * m + static_cast<double>(n) * n);
            if (!(k >= cascade.kMin && k < cascade.kMax)) continue;
            const std::complex<float> forward = sheet.amplitude(m, n, k);
            const std::complex<float> backward = std::conj(sheet.amplitude(-m, -n, k));
            const size_t at = modes.at(m, n);
            modes.forwardRe[at] = forward.real();
            modes.forwardIm[at] = forward.imag();
            modes.backwardRe[at] = backward.real();
            modes.backwardIm[at] = backward.imag();
            modes.frequency[at] = frequencyIndex(angularFrequency(k), desc.loopPeriod);
            modes.inverseK[at] = static_cast<float>(1 / k);
            variance +=
                2 * (std::norm(std::complex<double>(forward)) + std::norm(std::complex<double>(backward)));
        }
    }
    cascade.variance = variance;
    return modes;
}

} // namespace seaglass
