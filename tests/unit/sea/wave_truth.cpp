#include "tests/unit/sea/wave_truth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace tests {

using namespace seaglass;
namespace {

using Complex = std::complex<double>;
constexpr double tau = 2 * std::numbers::pi;

// h(k,t) of a mode of the stored half plane.
Complex heightNow(const Sea& sea, const Modes& modes, size_t at, double time) {
    const long double loop = sea.desc.loopPeriod;
    const long double turns = modes.frequency[at] * (std::fmod(static_cast<long double>(time), loop) / loop);
    const Complex turn = std::polar(1.0, tau * static_cast<double>(turns - std::floor(turns)));
    return Complex(modes.forwardRe[at], modes.forwardIm[at]) * turn +
           Complex(modes.backwardRe[at], modes.backwardIm[at]) * std::conj(turn);
}

// What h(k) is multiplied with for each field.
std::array<Complex, waveFields> factors(double ku, double kv, double choppiness) {
    const double d = choppiness / std::hypot(ku, kv);
    const Complex i(0, 1);
    return {i * ku * d, 1, i * kv * d, -ku * kv * d, i * ku, i * kv, -ku * ku * d, -kv * kv * d};
}

// Unnormalised, e^{+2 pi i jk/n}, in place, by halves; `turns` holds e^{2 pi i k/n}, n a power of two.
void inverseFourier(Complex* line, const std::vector<Complex>& turns) {
    const size_t points = turns.size();
    for (size_t at = 1, reversed = 0; at < points; ++at) {
        size_t bit = points / 2;
        for (; reversed & bit; bit /= 2) reversed ^= bit;
        reversed ^= bit;
        if (at < reversed) std::swap(line[at], line[reversed]);
    }
    for (size_t half = 1; half < points; half *= 2)
        for (size_t first = 0; first < points; first += 2 * half)
            for (size_t k = 0; k < half; ++k) {
                Complex &low = line[first + k], &high = line[first + k + half];
                const Complex turned = high * turns[k * (points / 2 / half)];
                high = low - turned;
                low += turned;
            }
}

void transpose(std::vector<Complex>& field, size_t samples) {
    for (size_t row = 0; row < samples; ++row)
        for (size_t column = 0; column < row; ++column)
            std::swap(field[row * samples + column], field[column * samples + row]);
}

void inverseFourier2d(std::vector<Complex>& field, const std::vector<Complex>& turns) {
    const size_t samples = turns.size();
    for (int direction = 0; direction < 2; ++direction) {
        for (size_t row = 0; row < samples; ++row) inverseFourier(&field[row * samples], turns);
        transpose(field, samples);
    }
}

std::vector<Complex> turnsOf(size_t points) {
    std::vector<Complex> turns;
    for (size_t k = 0; k < points; ++k)
        turns.push_back(std::polar(1.0, tau * static_cast<double>(k) / static_cast<double>(points)));
    return turns;
}

} // namespace

WaveTruth waveTruth(const Sea& sea, uint32_t cascade, double time) {
    const Modes& modes = sea.modes[cascade];
    const double dk = tau / sea.cascades[cascade].patch;
    const auto samples = static_cast<int32_t>(sea.desc.samples);
    const auto texels = static_cast<size_t>(samples) * sea.desc.samples;
    const auto texel = [samples](int32_t m, int32_t n) {
        return static_cast<size_t>((n + samples) % samples) * static_cast<size_t>(samples) +
               static_cast<size_t>((m + samples) % samples);
    };
    struct Mode {
        int32_t m, n;
        Complex h;
        std::array<Complex, waveFields> factor;
    };
    std::vector<Mode> held;
    for (int32_t n = 0; n <= modes.reach; ++n)
        for (int32_t m = -modes.reach; m <= modes.reach; ++m) {
            const size_t at = modes.at(m, n);
            if (modes.frequency[at] == 0) continue;
            held.push_back({m, n, heightNow(sea, modes, at, time),
                            factors(m * dk, n * dk, static_cast<double>(sea.desc.choppiness))});
        }
    std::vector<Complex> field(texels); // one for all: pages are slow to come by
    const std::vector<Complex> turns = turnsOf(sea.desc.samples);
    WaveTruth truth;
    for (size_t f = 0; f < waveFields; ++f) {
        std::ranges::fill(field, 0);
        for (const Mode& mode : held) {
            field[texel(mode.m, mode.n)] = mode.factor[f] * mode.h;
            field[texel(-mode.m, -mode.n)] = std::conj(mode.factor[f] * mode.h);
        }
        inverseFourier2d(field, turns);
        truth[f].reserve(texels);
        for (const Complex& value : field) truth[f].push_back(value.real());
    }
    return truth;
}

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

WaveError waveError(const WaveTruth& truth, const std::vector<float>& displacement,
                    const std::vector<float>& derivatives) {
    WaveError error;
    for (size_t f = 0; f < waveFields; ++f) {
        std::vector<double> off(truth[f].size());
        for (size_t t = 0; t < off.size(); ++t)
            off[t] = static_cast<double>(f < 4 ? displacement[4 * t + f] : derivatives[4 * t + f - 4]) -
                     truth[f][t];
        error.relative[f] = rootMeanSquare(off) / rootMeanSquare(truth[f]);
        if (f >= 3) continue;
        for (const double o : off) error.worst = std::max(error.worst, std::abs(o));
    }
    return error;
}

} // namespace tests
