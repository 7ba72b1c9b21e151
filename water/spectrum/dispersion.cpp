#include "water/spectrum/dispersion.h"

#include <algorithm>
#include <cmath>

namespace seaglass {
namespace {

// tanh is 1 to the last bit past 20, and cosh would overflow later.
constexpr double deepEnough = 20.0;

} // namespace

double angularFrequency(double k, double depth) {
    if (!(k > 0)) return 0;
    const double kh = std::min(k * depth, deepEnough);
    return std::sqrt((gravity * k + surfaceTension * k * k * k) * std::tanh(kh));
}

double waveNumber(double omega, double depth) {
    // The frequency rises with k: bracketed from the deep gravity wave, then halved to the last bit.
    double low = 0;
    double high = omega * omega / gravity;
    while (angularFrequency(high, depth) < omega) low = high, high *= 2;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high)) break;
        (angularFrequency(middle, depth) < omega ? low : high) = middle;
    }
    return high;
}

double groupSpeed(double k, double depth) {
    const double omega = angularFrequency(k, depth);
    if (!(omega > 0)) return 0;
    const double kh = k * depth;
    const double restoring = gravity * k + surfaceTension * k * k * k;
    const double stiffening = gravity + 3 * surfaceTension * k * k;
    if (kh >= deepEnough) return stiffening / (2 * omega);
    const double sech = 1 / std::cosh(kh);
    return (stiffening * std::tanh(kh) + restoring * depth * sech * sech) / (2 * omega);
}

} // namespace seaglass
