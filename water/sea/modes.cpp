#include "water/sea/modes.h"

#include "water/sea/phase.h"
#include "water/sea/scramble.h"
#include "water/spectrum/dispersion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>

namespace seaglass {
namespace {

// In (0, 1], for the logarithm's sake.
double unitAboveZero(uint64_t bits) {
    return (static_cast<double>(bits >> 11) + 1) * 0x1p-53;
}

// Two unit normal variates that belong to the mode (Box and Muller 1958).
std::complex<double> normals(uint64_t seed, uint32_t cascade, int32_t m, int32_t n) {
    const uint64_t place = static_cast<uint64_t>(static_cast<uint32_t>(m)) << 32 | static_cast<uint32_t>(n);
    const uint64_t first = scramble(scramble(scramble(seed) ^ cascade) ^ place);
    const uint64_t second = scramble(first);
    return std::polar(std::sqrt(-2 * std::log(unitAboveZero(first))),
                      2 * std::numbers::pi * unitAboveZero(second));
}

struct Amplitudes {
    std::complex<float> forward;  ///< h0(k)
    std::complex<float> backward; ///< h0(-k)
    double expected;              ///< variance of the height, of all seeds in the mean [m^2]
};

class Sheet {
  public:
    Sheet(const SeaDesc& desc, const WaveSystems& systems, uint32_t cascade, double dk)
        : systems_(systems), seed_(desc.seed), cascade_(cascade), dk_(dk),
          scale_(0.5 * static_cast<double>(desc.amplitude) * dk) {
        for (uint32_t s = 0; s < systems.count; ++s)
            along_[s] = {std::cos(systems.system[s].direction), std::sin(systems.system[s].direction)};
    }

    // At k = (m, n) dk and at -k.
    Amplitudes at(int32_t m, int32_t n) const {
        const Densities found = isCoarse(m, n) ? overCell(m, n) : densitiesAt(m, n);
        return {draw(m, n, found.forward), draw(-m, -n, found.backward),
                4 * scale_ * scale_ * (found.forward + found.backward)};
    }

  private:
    struct Direction {
        double u = 0, v = 0;
    };

    // Of h0's square, at k and at -k.
    struct Densities {
        double forward = 0, backward = 0;
    };

    // The systems are independent: their energies add, and one draw serves them all.
    Densities densitiesAt(double m, double n) const {
        const double k = std::sqrt(m * m + n * n) * dk_;
        const double omega = angularFrequency(k, systems_.depth);
        const double area = groupSpeed(k, systems_.depth) / k;
        Densities sum;
        for (uint32_t s = 0; s < systems_.count; ++s) {
            const WaveSystem& system = systems_.system[s];
            const double all = energy(system.spectrum, omega) * area;
            if (!(all > 0)) continue;
            const Spread spread = spreadAt(system.spreading, system.spectrum, omega);
            const double cosine = (m * along_[s].u + n * along_[s].v) * dk_ / k;
            sum.forward += all * density(spread, -cosine); // h0(k) travels towards -k.
            sum.backward += all * density(spread, cosine);
        }
        return sum;
    }

    // Among the first waves of a lattice a spectrum changes within one cell.
    static bool isCoarse(int32_t m, int32_t n) { return std::max(std::abs(m), std::abs(n)) <= 1; }

    // The mean over the lattice's cell.
    Densities overCell(int32_t m, int32_t n) const {
        constexpr int parts = 4;
        Densities sum;
        for (int i = 0; i < parts; ++i) {
            for (int j = 0; j < parts; ++j) {
                const Densities part = densitiesAt(m + (i + 0.5) / parts - 0.5, n + (j + 0.5) / parts - 0.5);
                sum.forward += part.forward / (parts * parts);
                sum.backward += part.backward / (parts * parts);
            }
        }
        return sum;
    }

    std::complex<float> draw(int32_t m, int32_t n, double density) const {
        return std::complex<float>(normals(seed_, cascade_, m, n) * (scale_ * std::sqrt(density)));
    }

    const WaveSystems& systems_;
    uint64_t seed_;
    uint32_t cascade_;
    double dk_;
    double scale_;
    std::array<Direction, 1 + maxSwells> along_;
};

int32_t latticeReach(const Cascade& cascade, double dk) {
    auto reach = static_cast<int32_t>(std::ceil(cascade.kMax / dk)) - 1;
    while (reach > 0 && reach * dk >= cascade.kMax) --reach;
    return reach > 0 ? reach : 0;
}

} // namespace

Modes drawModes(const SeaDesc& desc, const WaveSystems& systems, uint32_t index, Cascade& cascade) {
    const double dk = 2 * std::numbers::pi / cascade.patch;
    Modes modes;
    modes.reach = latticeReach(cascade, dk);
    modes.pitch = (static_cast<size_t>(2 * modes.reach) + Modes::lanes) / Modes::lanes * Modes::lanes;
    const size_t count = modes.pitch * static_cast<size_t>(modes.reach + 1);
    for (auto* values :
         {&modes.forwardRe, &modes.forwardIm, &modes.backwardRe, &modes.backwardIm, &modes.inverseK})
        values->assign(count, 0.0f);
    modes.frequency.assign(count, 0);

    const Sheet sheet(desc, systems, index, dk);
    double variance = 0;
    for (int32_t n = 0; n <= modes.reach; ++n) {
        for (int32_t m = n > 0 ? -modes.reach : 1; m <= modes.reach; ++m) {
            const double k = dk * std::sqrt(static_cast<double>(m) * m + static_cast<double>(n) * n);
            if (!(k >= cascade.kMin && k < cascade.kMax)) continue;
            const Amplitudes drawn = sheet.at(m, n);
            const std::complex<float> forward = drawn.forward;
            const std::complex<float> backward = std::conj(drawn.backward);
            const size_t at = modes.at(m, n);
            modes.forwardRe[at] = forward.real();
            modes.forwardIm[at] = forward.imag();
            modes.backwardRe[at] = backward.real();
            modes.backwardIm[at] = backward.imag();
            modes.frequency[at] = frequencyIndex(angularFrequency(k, systems.depth), desc.loopPeriod);
            modes.inverseK[at] = static_cast<float>(1 / k);
            modes.expected += drawn.expected;
            variance +=
                2 * (std::norm(std::complex<double>(forward)) + std::norm(std::complex<double>(backward)));
        }
    }
    cascade.variance = variance;
    return modes;
}

} // namespace seaglass
