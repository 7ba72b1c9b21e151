// The wave trains of a shore in time: each a few waves around the sea's peak, and what a crest leaves behind,
// which is stepped from long enough before that it is a function of the time alone.
#include "water/shore/shore.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "water/sea/smoothstep.h"

namespace seaglass {
namespace {

constexpr uint32_t mostRows = 2048;
constexpr double stepsAPeriod = 40;
/// Water rushes up in a part of the peak's period and takes the rest to run down.
constexpr double rushesUp = 0.07, runsDown = 0.28;
/// Sand dries, and the water's edge leaves it, in so long [s].
constexpr double dries = 9;
constexpr double dry = -0.5;

} // namespace

ShoreSignal Shore::signalAt(double time, double decayTime) const {
    const double period = 2 * std::numbers::pi / peak_;
    const double step = std::max(period / stepsAPeriod, longest_ / (mostRows - 2));
    ShoreSignal signal;
    signal.rowsPerSecond = static_cast<float>(1 / step);
    signal.count = std::max(2u, static_cast<uint32_t>(longest_ / step) + 3);
    const double last = std::ceil(time / step);
    signal.offset = static_cast<float>(last - time / step);
    signal.rows.resize(size_t{signal.count} * shoreTrains);
    if (trains_[0].empty()) return signal;

    const auto before = static_cast<int>(std::max(5 * decayTime, 5 * dries) / step);
    // Foam on broken water is thin, and goes sooner than where a crest broke out at sea.
    const double up = 1 - std::exp(-step / (rushesUp * period)),
                 down = 1 - std::exp(-step / (runsDown * period));
    const double fades = std::exp(-step / (0.6 * decayTime)), stays = std::exp(-step / dries);
    for (uint32_t train = 0; train < shoreTrains; ++train) {
        double edge = 0, wet = dry, foam = 0;
        ShoreRow* const rows = &signal.rows[size_t{train} * signal.count];
        for (int back = static_cast<int>(signal.count) - 1 + before; back >= 0; --back) {
            const double at = (last - back) * step;
            double height = 0, sideways = 0;
            for (const Wave& wave : trains_[train]) {
                const double phase = wave.frequency * at + wave.phase;
                height += wave.amplitude * std::cos(phase);
                sideways += wave.amplitude * std::sin(phase);
            }
            edge += (height - edge) * (height > edge ? up : down);
            wet = std::max(edge, dry + (wet - dry) * stays);
            foam = std::max(smoothstep(0.45, 0.95, height), foam * fades);
            if (back >= static_cast<int>(signal.count)) continue;
            rows[back] = {static_cast<float>(height), static_cast<float>(sideways), static_cast<float>(edge),
                          static_cast<float>(wet),    static_cast<float>(foam),     {}};
        }
    }
    return signal;
}

} // namespace seaglass
