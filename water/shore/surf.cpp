// As shaders/water/shore/surf.glsl.
#include "water/shore/surf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "water/sea/smoothstep.h"

namespace seaglass {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double steepest = 0.4;                          ///< |c| of low waves
constexpr double steepestWall = 0.85, steepestBore = 0.6; ///< of high ones before they break, and after
constexpr double highestToDepth = 0.9;                    ///< a single wave's height
constexpr double wallAt = 0.43; ///< at such a share of the depth fronts are halfway to a wall
constexpr double breaksAt = 0.62, breaksOnAt = 0.26; ///< likewise waves break: at first, where all do
constexpr double leastWater = 0.08;                  ///< [m]

} // namespace

Surf surfOf(const std::complex<double>& z, const SurfPlace& place) {
    const double k = turn * place.wavesPerMetre, water = std::max(place.depth, leastWater);
    const double amount = std::abs(z);
    const double most = highestToDepth * water / std::max(2 * place.deviation, 1e-6);
    const double over = amount * amount / (most * most), kept = 1 / std::sqrt(std::sqrt(1 + over * over));
    const double x = k * water, deep = std::max(x / std::sqrt(1 + x * x), 0.01); // tanh, within a tenth
    const double second = k * place.deviation * (3 - deep * deep) / (4 * deep * deep * deep);
    const double biphase = turn / 4 * second / (second + 0.8), unseen = 4 * place.width * place.wavesPerMetre;
    const double risen = over * highestToDepth * highestToDepth / (wallAt * wallAt);
    const double walls = std::min(std::pow(risen, 4), 1e6);
    const double walled = walls / (1 + walls), wall = std::lerp(steepestWall, steepestBore, place.breaking);
    const double limit = std::lerp(steepest, wall, walled);
    const double rises = 8 * walled * (1 - walled) * (wall - steepest) / limit;
    const double strained = second * kept * amount / limit;
    const double bound = second * kept / std::sqrt(1 + strained * strained) / (1 + unseen * unseen);
    const std::complex<double> c = bound * z * std::polar(1.0, biphase), shape = 1.0 / (1.0 - c);
    const double gain = kept * std::sqrt(1 - std::norm(c));
    const double height = gain * (z * shape).real();
    std::complex<double> change = gain * shape * shape;
    // Both limits go by the amount: how `kept` and `bound` change as it grows, in shares.
    const double fewer = over * over / (1 + over * over);
    const double loosens = -fewer - (1 - fewer - rises) * strained * strained / (1 + strained * strained);
    const double grows = loosens * (z * c * change).real() -
                         height * (fewer + std::norm(c) * (1 + loosens) / (1 - std::norm(c)));
    change += grows * std::conj(z) / std::max(amount * amount, 1e-12);
    return {height, {change.real(), -change.imag()}, biphase};
}

double surfFoam(const std::complex<double>& z, double biphase, const SurfPlace& place, double fades) {
    constexpr double leaves = 0.8;
    const double height = 2 * std::abs(z) * place.deviation / std::max(place.depth, leastWater);
    const double broken = smoothstep(0.8, 1.2, height / std::lerp(breaksAt, breaksOnAt, place.breaking)) *
                          smoothstep(0, 0.3, place.breaking);
    const double turns = (std::arg(z) + biphase + 0.45 * broken) / turn;
    const double rollsFor = std::lerp(0.06, 0.17, broken); // of the period: from a white lip on
    const double age = turns - std::floor(turns) - rollsFor;
    return age < 0 ? smoothstep(0, 0.5, broken) : broken * leaves * std::exp(-age * fades);
}

} // namespace seaglass
