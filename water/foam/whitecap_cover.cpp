// How much of the simulated sea is white.
#include "gpu/field_error.h"
#include "water/foam/foam_history.h"
#include "water/interface/fields/sea.h"
#include "water/interface/foam_gate.h"
#include "water/interface/foam_layers.h"
#include "water/sea/sea.h"

#include <cmath>
#include <memory>
#include <new>
#include <numbers>

namespace seaglass {
namespace {

constexpr uint32_t pointsAcross = 256;

struct Grid {
    const Sea& sea;
    const FoamHistory& foam;
    float past;
    FoamGate gate;
    std::vector<FoamDrift> drift; ///< of each cascade that counts where waves break
    std::vector<std::vector<float>> displacement, derivatives; ///< likewise

    // The sample of cascade c nearest to a point of the calm plane.
    size_t nearest(uint32_t c, double u, double v) const {
        const auto samples = static_cast<double>(sea.cascades[c].samples);
        const auto along = [&](double x) {
            const double tiles = x / sea.cascades[c].patch;
            return static_cast<size_t>((tiles - std::floor(tiles)) * samples) % sea.cascades[c].samples;
        };
        return along(v) * sea.cascades[c].samples + along(u);
    }

    // What breakers of a cascade left at a point.
    double leftBy(uint32_t c, double u, double v) const {
        const double patch = sea.cascades[c].patch;
        const size_t i = nearest(c, u - drift[c].u * patch, v - drift[c].v * patch);
        const FoamHistory::Band& band = foam.band(c);
        return static_cast<double>(std::lerp(band.foam[i], band.foamNext[i], past));
    }

    // Foam at a point, and how much of the displaced surface the point stands for.
    void at(double u, double v, double& cover, double& area) const {
        const double seen = gate.at(u / sea.cascades[0].patch, v / sea.cascades[0].patch);
        double left = seen, uu = 1, vv = 1, uv = 0, compression = 0;
        for (uint32_t c = 0; c < displacement.size(); ++c) {
            const size_t i = nearest(c, u, v);
            const float *const moved = &displacement[c][4 * i], *const changed = &derivatives[c][4 * i];
            compression += static_cast<double>(foam.breaking().counts[c] *
                                               foam.breaking().compression(changed[2], changed[3], moved[3]));
            if (c >= foam.breaking().count) continue; // as much as is seen of it
            left *= leftBy(c, u, v);
            uu += static_cast<double>(changed[2]);
            vv += static_cast<double>(changed[3]);
            uv += static_cast<double>(moved[3]);
        }
        const double now = 0.5 * std::erfc((double{foam.breaking().now} - compression) /
                                           (std::numbers::sqrt2 * double{foam.breaking().nowWidth}));
        cover = 1 - (1 - left) * (1 - seen * now);
        area = std::max(uu * vv - uv * uv, 0.0);
    }
};

double coverOf(const Sea& sea, const WavesBackend& backend, void* state, const FoamDesc& desc, double time) {
    FoamHistory foam(sea, desc);
    const uint32_t count = foam.breaking().count;
    if (count == 0) return 0;
    const FoamTime now = foamTimeOf(time, sea.desc.loopPeriod);
    foam.advance(backend, state, now.step);
    const size_t floats = size_t{4} * sea.desc.samples * sea.desc.samples;
    Grid grid{sea, foam, now.past, FoamGate(sea, time), {}, {}, {}};
    std::vector<float> moments(floats);
    for (uint32_t c = 0; c < sea.count && foam.breaking().counts[c] > 0; ++c) {
        grid.drift.push_back(foamDriftOf(sea.desc, sea.cascades[c], time));
        grid.displacement.emplace_back(floats);
        grid.derivatives.emplace_back(floats);
        backend.evaluate(state, c, time,
                         {grid.displacement[c].data(), grid.derivatives[c].data(), moments.data()});
    }
    // The smaller tiles repeat on the largest: several turns of it, that they may be met with other waves,
    // and that its gate is seen open as often as it is.
    const double spacing = sea.cascades[0].patch * (11 + 1 / std::numbers::phi) / pointsAcross;
    double foamy = 0, whole = 0;
    for (uint32_t y = 0; y < pointsAcross; ++y)
        for (uint32_t x = 0; x < pointsAcross; ++x) {
            double cover = 0, area = 0;
            grid.at(x * spacing, y * spacing, cover, area);
            foamy += cover * area;
            whole += area;
        }
    return whole > 0 ? foamy / whole : 0;
}

} // namespace

bool whitecapCover(const Sea& sea, const WavesBackend& backend, const FoamDesc& foam, double time,
                   double* cover) {
    *cover = 0;
    if (outOfRange(foamFields, &foam)) return false;
    if (sea.count == 0) return true;
    const std::unique_ptr<void, void (*)(void*)> state(backend.create(sea), backend.destroy);
    if (!state) return false;
    try {
        *cover = coverOf(sea, backend, state.get(), foam, time);
    } catch (const std::bad_alloc&) {
        return false;
    }
    return true;
}

} // namespace seaglass
