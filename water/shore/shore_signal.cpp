// The wave trains of a shore in time: each a few waves around the sea's peak, and what a crest leaves behind,
// which is stepped from long enough before that it is a function of the time alone.
#include "water/shore/shore.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

constexpr uint32_t mostRows = 2048;
constexpr double stepsAPeriod = 40;
/// Water rushes up in a part of the peak's period and takes the rest to run down.
constexpr double rushesUp = 0.1, runsDown = 0.34;
/// The film stays where the water's edge has left it, and has gone after so long [s].
constexpr double dries = 9;
constexpr double dry = -0.5;

} // namespace

double Shore::rowStep() const {
    const double period = 2 * std::numbers::pi / peak_;
    return std::max(period / stepsAPeriod, longest_ / (mostRows - 2));
}

uint32_t Shore::rowCount() const {
    return std::max(2u, static_cast<uint32_t>(longest_ / rowStep()) + 3);
}

void Shore::follow(uint32_t train, double time, uint32_t oldest,
                   const std::function<void(uint32_t, const ShoreRow&)>& visit) const {
    const double period = 2 * std::numbers::pi / peak_, step = rowStep();
    const double last = std::ceil(time / step);
    const auto before = static_cast<uint32_t>(5 * dries / step);
    const double up = 1 - std::exp(-step / (rushesUp * period)),
                 down = 1 - std::exp(-step / (runsDown * period));
    double edge = 0, wet = dry, most = dry, since = 0;
    for (uint32_t back = oldest + before + 1; back-- > 0;) {
        const double at = (last - back) * step;
        double height = 0, sideways = 0;
        for (const Wave& wave : trains_[train]) {
            const double phase = wave.frequency * at + wave.phase;
            height += wave.amplitude * std::cos(phase);
            sideways += wave.amplitude * std::sin(phase);
        }
        edge += (height - edge) * (height > edge ? up : down);
        since += step;
        wet = dry + (most - dry) * std::exp(-(since / dries) * (since / dries));
        if (edge >= wet) {
            most = wet = edge;
            since = 0;
        }
        if (back > oldest) continue;
        visit(back, {static_cast<float>(height), static_cast<float>(sideways), static_cast<float>(edge),
                     static_cast<float>(wet)});
    }
}

double Shore::heldTime(double time) {
    constexpr double farthest = 1e15; // [s]; beyond, a double tells no steps of rows apart
    return std::isfinite(time) ? std::clamp(time, -farthest, farthest) : 0;
}

ShoreSignal Shore::signalAt(double asked, double decayTime) const {
    const double time = heldTime(asked), step = rowStep();
    ShoreSignal signal;
    signal.rowsPerSecond = static_cast<float>(1 / step);
    signal.count = rowCount();
    // What a wave leaves in the surf is stirred until the next comes, and goes a little later than out at
    // sea.
    signal.foamFades = static_cast<float>(2 * std::numbers::pi / peak_ / (1.2 * decayTime));
    signal.offset = static_cast<float>(std::ceil(time / step) - time / step);
    signal.rows.resize(size_t{signal.count} * shoreTrains);
    if (trains_[0].empty()) return signal;
    for (uint32_t train = 0; train < shoreTrains; ++train) {
        ShoreRow* const rows = &signal.rows[size_t{train} * signal.count];
        follow(train, time, signal.count - 1,
               [rows](uint32_t back, const ShoreRow& row) { rows[back] = row; });
    }
    return signal;
}

} // namespace seaglass
