#include "water/interface/whitecaps.h"

#include "water/interface/foam_gate.h"
#include "water/sea/sea.h"
#include "water/spectrum/dispersion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

// Waves of 10 m and more, and down to a twelfth of the peak's, make the whitecaps that are seen; shorter ones
// break without much foam.
double shortestBreaker(const Sea& sea) {
    return std::max(12 * sea.peak * sea.peak / gravity, 2 * std::numbers::pi / 10);
}

// The geometric mean of the two laws.
double whitecapsWanted(double wind) {
    return std::sqrt(whitecapsOfMonahan(wind) * whitecapsOfCallaghan(wind));
}

// Foam goes with the square of the threshold as exp(-0.57 z^2).
constexpr double rarer = 0.57;

// Below how many deviations of the Jacobian of all cascades the sea breaks. Foam is rarer in less wind though
// waves are about as steep: fitted, for what foam_gate.h shows, to the geometric mean of the two laws at 8 to
// 20 m/s (docs/physics.md).
double deviationsToBreak(double wind, bool gated) {
    const double z = std::max(6.57 - 1.65 * std::log(wind), 0.5);
    return gated ? z : std::sqrt(z * z - std::log(foamGateMean) / rarer);
}

// Beyond what e a share of the unit Gaussian lies (Abramowitz and Stegun 26.2.23), within 5e-4.
double deviationsBeyond(double share) {
    const double t = std::sqrt(-2 * std::log(std::clamp(share, 1e-9, 0.5)));
    return t -
           (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
}

// Crests that run with the wind break along their length: of what runs across it so much counts.
constexpr double acrossTheWind = 0.2;

void lookAlongTheWind(const SeaDesc& desc, Breaking& breaking) {
    const double u = std::cos(double{desc.windDirection}), v = std::sin(double{desc.windDirection});
    breaking.along[0] = static_cast<float>(u * u + acrossTheWind * v * v);
    breaking.along[1] = static_cast<float>(v * v + acrossTheWind * u * u);
    breaking.along[2] = static_cast<float>(2 * (1 - acrossTheWind) * u * v);
}

// Variances of one cascade at full amplitude and choppiness 1. Calmer water than the wind's own keeps the
// threshold and so foams less.
struct Variance {
    double compression = 0;
    double whitecaps = 0; ///< of the compression, by the waves that make those that are seen
    double slopes = 0;
};

Variance varianceOf(const Sea& sea, uint32_t cascade, const Breaking& breaking) {
    const Modes& modes = sea.modes[cascade];
    const double shortest = shortestBreaker(sea), dk = 2 * std::numbers::pi / sea.cascades[cascade].patch;
    Variance sum;
    for (int32_t n = 0; n <= modes.reach; ++n)
        for (int32_t m = -modes.reach; m <= modes.reach; ++m) {
            const size_t at = modes.at(m, n);
            if (modes.inverseK[at] == 0) continue;
            const double perK = static_cast<double>(modes.inverseK[at]), u = m * dk * perK, v = n * dk * perK;
            const double along = double{breaking.along[0]} * u * u + double{breaking.along[1]} * v * v +
                                 double{breaking.along[2]} * u * v;
            const double slopes = varianceAt(modes, at) / (perK * perK);
            sum.slopes += slopes;
            sum.compression += slopes * along * along;
            sum.whitecaps += slopes * along * along / (1 + std::pow(1 / (perK * shortest), 4));
        }
    for (double* const variance : {&sum.compression, &sum.whitecaps, &sum.slopes})
        *variance /= double{sea.desc.amplitude} * double{sea.desc.amplitude};
    return sum;
}

/// Of the waves of a cascade whose slopes add up to its breakers: the mean phase speed by slope variance
/// [m/s].
double crestSpeed(const Sea& sea, uint32_t cascade) {
    const Modes& modes = sea.modes[cascade];
    double slopes = 0, speeds = 0;
    for (size_t at = 0; at < modes.inverseK.size(); ++at) {
        const auto inverseK = static_cast<double>(modes.inverseK[at]);
        if (!(inverseK > 0)) continue;
        const double slope = varianceAt(modes, at) / (inverseK * inverseK);
        const double frequency = 2 * std::numbers::pi * modes.frequency[at] / sea.desc.loopPeriod;
        slopes += slope;
        speeds += slope * frequency * inverseK;
    }
    return slopes > 0 ? speeds / slopes : 0;
}

/// Of the first cascades, as many as count.
struct Variances {
    uint32_t count = 0;
    Variance of[maxCascades], sum;
};

Variances variancesOf(const Sea& sea, const Breaking& breaking) {
    constexpr double leastShare = 0.1; // what has less decides nothing
    Variances all;
    for (; all.count < sea.count; ++all.count) {
        const Variance more = varianceOf(sea, all.count, breaking);
        if (all.count > 0 && more.whitecaps < leastShare * (all.sum.whitecaps + more.whitecaps)) break;
        all.of[all.count] = more;
        all.sum.compression += more.compression;
        all.sum.whitecaps += more.whitecaps;
        all.sum.slopes += more.slopes;
    }
    return all;
}

// What the cascade counts that is too short to leave foam: in more wind more, so that breakers are as long,
// and as much in line with the wind, as at sea (Korinenko, Malinovsky and Kudryavtsev 2018; docs/physics.md).
double shortWavesCount(double wind) {
    return std::clamp((wind - 5) / 14, 0.0, 1.0);
}

/// How compressed are all that count at a moment.
Variance countedAtOnce(const Sea& sea, const Variances& variances, Breaking& breaking) {
    Variance sum = variances.sum;
    for (uint32_t c = 0; c < variances.count; ++c) breaking.counts[c] = 1;
    if (variances.count == sea.count) return sum;
    const double counts = shortWavesCount(double{sea.desc.windSpeed});
    const Variance shorter = varianceOf(sea, variances.count, breaking);
    breaking.counts[variances.count] = static_cast<float>(counts);
    sum.compression += counts * counts * shorter.compression;
    sum.slopes += counts * counts * shorter.slopes;
    return sum;
}

Breaking breakingInTheOpen(const Sea& sea, const FoamDesc& foam) {
    constexpr double leastWind = 2;          // [m/s]; either law leaves less than 5e-5 here
    constexpr double never = 7;              // deviations: no sample of a loop's whole time
    constexpr double shareThatBreaks = 0.15; // of the foam, at a moment
    constexpr double least = 1e-6;           // that is divided by: a puddle has hardly any waves
    Breaking breaking;
    const double wind = sea.desc.windSpeed, bias = foam.bias;
    if (wind < leastWind) return breaking;
    lookAlongTheWind(sea.desc, breaking);
    const Variances variances = variancesOf(sea, breaking);
    const double toBreak = deviationsToBreak(wind, sea.desc.warp > 0), choppiness = sea.desc.choppiness;
    const double drawn = double{sea.desc.amplitude} * choppiness, all = std::sqrt(variances.sum.whitecaps);
    if (!(all > 0) || never * drawn * all < toBreak * all - bias) return breaking;
    breaking.count = variances.count;
    for (uint32_t c = 0; c < breaking.count; ++c) {
        const Variance& own = variances.of[c];
        const double share = own.whitecaps / variances.sum.whitecaps, deviation = std::sqrt(own.compression);
        breaking.share[c] = static_cast<float>(share);
        // Waves that are too long for this sea leave it to the others.
        const bool breaks = share > least;
        breaking.threshold[c] =
            static_cast<float>(breaks ? toBreak * std::sqrt(share) * deviation - share * bias : -1);
        breaking.softness[c] = static_cast<float>(std::max(0.3 * deviation, least));
        const double speed = crestSpeed(sea, c), towards = double{sea.desc.windDirection};
        breaking.runs[c][0] = static_cast<float>(speed * std::cos(towards));
        breaking.runs[c][1] = static_cast<float>(speed * std::sin(towards));
    }
    const Variance counted = countedAtOnce(sea, variances, breaking);
    const double gate = sea.desc.warp > 0 ? foamGateMean : 1, deviation = std::sqrt(counted.compression);
    breaking.now = static_cast<float>(
        deviationsBeyond(shareThatBreaks * whitecapsWanted(wind) / gate) * deviation - bias);
    breaking.nowWidth = static_cast<float>(std::max(0.12 * deviation, least));
    breaking.hidden = static_cast<float>(choppiness * choppiness * counted.compression / counted.slopes);
    const double slopes = counted.slopes * double{sea.desc.amplitude} * double{sea.desc.amplitude};
    breaking.narrower = static_cast<float>(std::min(double{breaking.now}, 0.9) / std::max(slopes, least));
    return breaking;
}

} // namespace

Breaking breakingOf(const Sea& sea, const FoamDesc& foam) {
    Breaking breaking;
    if (sea.count == 0) return breaking;
    breaking = breakingInTheOpen(sea, foam);
    if (breaking.count == 0 && sea.shore) {
        // A history is kept, in which nothing happens.
        breaking.threshold[0] = breaking.now = 1e6f;
        breaking.softness[0] = breaking.share[0] = 1;
        breaking.count = 1;
    }
    return breaking;
}

double whitecapsOfMonahan(double windSpeed) {
    return 3.84e-6 * std::pow(std::max(windSpeed, 0.0), 3.41);
}

double whitecapsOfCallaghan(double windSpeed) {
    const auto cubed = [](double x) { return x * x * x; };
    // The two fits overlap from 9.25 to 11.25 m/s, and cross here.
    constexpr double crossing = 10.187;
    if (windSpeed < crossing) return 3.18e-5 * cubed(std::max(windSpeed - 3.70, 0.0));
    return 4.82e-6 * cubed(windSpeed + 1.98);
}

} // namespace seaglass
