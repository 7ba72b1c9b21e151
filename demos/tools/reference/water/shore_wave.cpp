#include "reference/water/shore_wave.h"

#include <algorithm>
#include <cmath>
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

} // namespace

/// A train where it arrives, and how fast that changes [1/s].
struct ShoreWaves::Train {
    double height, sideways, swash, wet, foam;
    double heightRate, sidewaysRate, swashRate;
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
    return {value(a.height, b.height),    value(a.sideways, b.sideways), value(a.swash, b.swash),
            value(a.wet, b.wet),          value(a.foam, b.foam),         rate(a.height, b.height),
            rate(a.sideways, b.sideways), rate(a.swash, b.swash)};
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
    double swash = 0, wet = 0, white = 0;
    glm::dvec2 swashSlope(0);
    for (size_t t = 0; t < seaglass::shoreTrains; ++t) {
        const Train train = trainAt(t, double{here.arrival[t]});
        const glm::dvec2 slowness =
            glm::dvec2(alongU.arrival[t] - here.arrival[t], alongV.arrival[t] - here.arrival[t]) / spacing;
        const double length = std::max(glm::length(slowness), 1e-4);
        const glm::dvec2 ahead = slowness / length;
        const double samplesAWave = width * length * shore_.peak() / (2 * std::numbers::pi);
        const double seen = 1 - glm::smoothstep(0.15, 0.4, samplesAWave);
        const double height = double{here.height} * seen, sideways = double{here.sideways} * seen;
        const double forward = train.sideways + lean * train.height;
        const double forwardRate = train.sidewaysRate + lean * train.heightRate;
        wave.height += height * train.height;
        wave.slope -= height * train.heightRate * slowness;
        wave.move += sideways * forward * ahead;
        wave.stretch -= sideways * forwardRate *
                        glm::dvec3(ahead.x * slowness.x, ahead.y * slowness.y, ahead.x * slowness.y);
        wave.advected += amount * train.swash * shore_.carried() * ahead;
        swash += train.swash;
        swashSlope -= train.swashRate * slowness;
        wet += train.wet;
        white += train.foam;
    }
    wave.height += amount * std::max(swash, lowestSwash);
    if (swash > lowestSwash) wave.slope += amount * swashSlope;
    wave.swash = amount;
    wave.wetTo = amount * wet;
    wave.foam = double{here.breaking} * std::min(0.5 * white, 1.0);
    return wave;
}

} // namespace demos::reference
