#include "reference/water/shore_wave.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace demos::reference {

namespace {

using seaglass::ShorePlace;

constexpr double lowestSwash = -1.2; ///< of its deviation: the water's edge runs down no lower

ShorePlace mix(const ShorePlace& a, const ShorePlace& b, float share) {
    ShorePlace out;
    const auto mixed = [&](float ShorePlace::*m) { out.*m = std::lerp(a.*m, b.*m, share); };
    for (float ShorePlace::*const member : {&ShorePlace::depth, &ShorePlace::height, &ShorePlace::breaking,
                                            &ShorePlace::sideways, &ShorePlace::swash})
        mixed(member);
    for (size_t i = 0; i < out.arrival.size(); ++i)
        out.arrival[i] = std::lerp(a.arrival[i], b.arrival[i], share);
    for (size_t i = 0; i < out.kept.size(); ++i) out.kept[i] = std::lerp(a.kept[i], b.kept[i], share);
    return out;
}

/// Waves with their bound harmonics, and how these change with the free ones.
struct Bound {
    double height;
    std::complex<double> change;
    double biphase;
};

constexpr double leastWater = 0.08; ///< [m]

/// z / (1 - c), where |c| is Stokes' ratio of second to first harmonic and its phase the biphase of waves on
/// beaches (Ruessink et al. 2012); of the variance that z has. |c| is 0.4 at the most, and 0.85 of waves that
/// become high, where few have broken.
Bound boundTo(const std::complex<double>& z, const ShorePlace& here, double wavesPerM, double width) {
    const double deviation{here.height}, depth{here.depth};
    const double water = std::max(depth, leastWater), k = 2 * std::numbers::pi * wavesPerM;
    const double steepnessToDepth = 2 * std::abs(z) * deviation / (0.9 * water);
    const double borne = std::pow(1 + std::pow(steepnessToDepth, 4), -0.25);
    const double kd = k * water, tanhKd = std::max(kd / std::hypot(1, kd), 0.01);
    const double stokes = k * deviation * (3 - tanhKd * tanhKd) / (4 * std::pow(tanhKd, 3));
    const double biphase = std::numbers::pi / 2 * stokes / (stokes + 0.8);
    const double unlimited = stokes * borne * std::abs(z);
    const double seen = 1 + std::pow(4 * width * wavesPerM, 2);
    const double risen = std::pow(steepnessToDepth * 0.9 / 0.43, 8), wall = risen / (1 + risen);
    const double higher = glm::mix(0.85, 0.6, double{here.breaking}) - 0.4, most = 0.4 + higher * wall;
    const double size = unlimited / std::hypot(1, unlimited / most) / seen;
    const std::complex<double> c = std::polar(size, std::arg(z) + biphase);
    const double whole = borne * std::sqrt(1 - size * size);
    const double height = whole * (z / (1.0 - c)).real();
    std::complex<double> change = whole / ((1.0 - c) * (1.0 - c));
    // As waves grow, that they are limited takes these shares of what they would gain.
    const double fourth = std::pow(steepnessToDepth, 4), lost = fourth / (1 + fourth);
    const double strained = std::pow(unlimited / most, 2), mostGrows = higher * 8 * wall * (1 - wall) / most;
    const double eased = lost + (1 - lost - mostGrows) * strained / (1 + strained);
    const double grows =
        -eased * (z * c * change).real() - height * (lost + size * size * (1 - eased) / (1 - size * size));
    change += grows * std::conj(z) / std::max(std::norm(z), 1e-12);
    return {height, change, biphase};
}

/// Which share of the waves breaks there.
double brokenOf(const std::complex<double>& z, const ShorePlace& here) {
    const double height = 2 * std::abs(z) * double{here.height} / std::max(double{here.depth}, leastWater);
    const double breaking{here.breaking};
    return glm::smoothstep(0.8, 1.2, height / glm::mix(0.62, 0.26, breaking)) *
           glm::smoothstep(0.0, 0.3, breaking);
}

} // namespace

/// A train where it arrives, and how fast that changes [1/s].
struct ShoreWaves::Train {
    std::complex<double> height, heightRate; ///< and a quarter of a wave later
    double swash, swashRate, wet;
};

ShorePlace ShoreWaves::placeAt(const glm::dvec2& calm) const {
    const size_t across = shore_.samples()[0], rows = shore_.samples()[1];
    const glm::dvec2 last(static_cast<double>(across) - 1, static_cast<double>(rows) - 1);
    const glm::dvec2 origin(shore_.origin()[0], shore_.origin()[1]);
    const glm::dvec2 at = glm::clamp((calm - origin) / shore_.spacing(), glm::dvec2(0), last);
    const glm::dvec2 first = glm::min(glm::floor(at), last - 1.0);
    const glm::vec2 share(at - first);
    const ShorePlace* corner =
        &shore_.places()[static_cast<size_t>(first.y) * across + static_cast<size_t>(first.x)];
    return mix(mix(corner[0], corner[1], share.x), mix(corner[across], corner[across + 1], share.x), share.y);
}

ShoreWaves::Train ShoreWaves::trainAt(size_t which, double arrival) const {
    const double perSecond{signal_.rowsPerSecond};
    const double row = std::clamp(arrival * perSecond + double{signal_.offset}, 0.0, signal_.count - 1.001);
    const size_t whole = static_cast<size_t>(row);
    const seaglass::ShoreRow& a = signal_.rows[which * signal_.count + whole];
    const seaglass::ShoreRow& b = signal_.rows[which * signal_.count + whole + 1];
    const auto value = [&](float now, float before) {
        return std::lerp(double{now}, double{before}, row - static_cast<double>(whole));
    };
    // Rows go back in time.
    const auto rate = [&](float now, float before) { return double{now - before} * perSecond; };
    return {{value(a.height, b.height), value(a.sideways, b.sideways)},
            {rate(a.height, b.height), rate(a.sideways, b.sideways)},
            value(a.swash, b.swash),
            rate(a.swash, b.swash),
            value(a.wet, b.wet)};
}

double ShoreWave::surfFoam(double bend) const {
    const double rolls = glm::mix(0.06, 0.17, broken); // of the period
    const double age = glm::fract(turns + 0.03 * bend);
    return age < rolls ? glm::smoothstep(0.0, 0.5, broken)
                       : 0.8 * broken * std::exp((rolls - age) * foamFades);
}

ShoreWave ShoreWaves::at(const glm::dvec2& calm, double width) const {
    const double spacing = shore_.spacing();
    const ShorePlace here = placeAt(calm), alongU = placeAt(calm + glm::dvec2(spacing, 0)),
                     alongV = placeAt(calm + glm::dvec2(0, spacing));
    ShoreWave wave;
    wave.depth = double{here.depth};
    wave.bedSlope = glm::dvec2(here.depth - alongU.depth, here.depth - alongV.depth) / spacing;
    std::ranges::copy(here.kept, wave.kept.begin());
    if (here.height == 0 && here.swash == 0) return wave;
    // A breaker leans forwards.
    const double lean = 0.6 * double{here.breaking}, amount{here.swash};
    double swash = 0, rushes = 0, wet = 0, wavesPerM = 0;
    glm::dvec2 swashSlope(0);
    std::complex<double> all, wide, slopeU, slopeV; // of waves that are seen
    for (size_t t = 0; t < seaglass::shoreTrains; ++t) {
        const Train train = trainAt(t, double{here.arrival[t]});
        const glm::dvec2 slowness =
            glm::dvec2(alongU.arrival[t] - here.arrival[t], alongV.arrival[t] - here.arrival[t]) / spacing;
        const double length = std::max(glm::length(slowness), 1e-4);
        const glm::dvec2 ahead = slowness / length;
        const double samplesAWave = width * length * shore_.peak() / (2 * std::numbers::pi);
        const double seen = 1 - glm::smoothstep(0.15, 0.4, samplesAWave);
        const double sideways = double{here.sideways} * seen;
        const double forward = train.height.imag() + lean * train.height.real();
        const double forwardRate = train.heightRate.imag() + lean * train.heightRate.real();
        all += train.height;
        wide += seen * train.height;
        slopeU -= seen * slowness.x * train.heightRate;
        slopeV -= seen * slowness.y * train.heightRate;
        wavesPerM += length * shore_.peak() / (2 * std::numbers::pi) / seaglass::shoreTrains;
        wave.move += sideways * forward * ahead;
        wave.stretch -= sideways * forwardRate *
                        glm::dvec3(ahead.x * slowness.x, ahead.y * slowness.y, ahead.x * slowness.y);
        // The swash follows the crest a seventh of a wave later.
        wave.advected += amount * (train.height * std::polar(1.0, -0.873)).real() * shore_.carried() * ahead;
        swash += train.swash;
        swashSlope -= train.swashRate * slowness;
        rushes += train.swashRate;
        wet += train.wet;
    }
    const double deviation{here.height};
    const Bound bound = boundTo(wide, here, wavesPerM, width);
    const auto along = [&](const std::complex<double>& slope) {
        return deviation * (bound.change * slope).real();
    };
    wave.height = deviation * bound.height + amount * std::max(swash, lowestSwash);
    wave.slope = {along(slopeU), along(slopeV)};
    if (swash > lowestSwash) {
        wave.slope += amount * swashSlope;
        wave.rushes = amount * rushes;
    }
    wave.swash = amount;
    wave.wetTo = amount * wet;
    wave.broken = brokenOf(all, here);
    wave.turns = (std::arg(all) + bound.biphase + 0.45 * wave.broken) / (2 * std::numbers::pi);
    wave.foamFades = double{signal_.foamFades};
    return wave;
}

} // namespace demos::reference
