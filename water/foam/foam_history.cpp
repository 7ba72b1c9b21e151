#include "water/foam/foam_history.h"

#include "water/interface/foam_layers.h"
#include "water/interface/waves_backend.h"
#include "water/sea/sea.h"

#include <algorithm>
#include <cmath>

namespace seaglass {
namespace {

/// A map that repeats, as it lies (u, v) samples aside; rows along v.
class Shifted {
  public:
    Shifted(const std::vector<float>& map, uint32_t samples, double u, double v)
        : map_(map.data()), samples_(samples), left_(wholeOf(u)), top_(wholeOf(v)),
          pastU_(static_cast<float>(u - std::floor(u))), pastV_(static_cast<float>(v - std::floor(v))) {}

    /// Calls use(n, value) for each sample n, between the four that it lies between.
    template<typename Use>
    void each(const Use& use) const {
        for (uint32_t j = 0, n = 0; j < samples_; ++j) {
            const float* const high = rowOf(j + top_);
            const float* const low = rowOf(j + top_ + 1);
            const auto inColumn = [&](uint32_t i) { return high[i] + pastV_ * (low[i] - high[i]); };
            uint32_t column = left_;
            float left = inColumn(column);
            for (uint32_t i = 0; i < samples_; ++i, ++n) {
                if (++column == samples_) column = 0;
                const float right = inColumn(column);
                use(n, left + pastU_ * (right - left));
                left = right;
            }
        }
    }

  private:
    const float* rowOf(uint32_t j) const { return map_ + size_t{j % samples_} * samples_; }
    uint32_t wholeOf(double way) const {
        const double across = samples_;
        return static_cast<uint32_t>(std::floor(way) - across * std::floor(std::floor(way) / across));
    }

    const float* map_;
    uint32_t samples_, left_, top_;
    float pastU_, pastV_;
};

} // namespace

FoamHistory::FoamHistory(const Sea& sea, const FoamDesc& foam)
    : sea_(&sea), breaking_(breakingOf(sea, foam)), fading_(fadingsOf(foam, breaking_)),
      bands_(breaking_.count) {
    if (breaking_.count == 0) return;
    const size_t texels = size_t{sea.desc.samples} * sea.desc.samples;
    for (Band& band : bands_)
        for (auto* map : {&band.foam, &band.foamNext, &band.plume, &band.plumeNext})
            map->assign(texels, 0.0f);
    for (auto& map : maps_) map.assign(4 * texels, 0.0f);
    compression_.assign(texels, 0.0f);
}

void FoamHistory::advance(const WavesBackend& backend, void* state, int64_t step) {
    const FoamSteps steps = stepsUntil(known_, step, fading_[0]);
    for (int64_t i = 0; i < steps.all(); ++i) stepTo(backend, state, steps.at(i));
    known_ = {steps.last, steps.caughtUp};
}

void FoamHistory::stepTo(const WavesBackend& backend, void* state, const FoamStep& step) {
    const double time = foamStepTime(step.step);
    for (uint32_t c = 0; c < breaking_.count; ++c) {
        backend.evaluate(state, c, time, {maps_[0].data(), maps_[1].data(), maps_[2].data()});
        for (size_t i = 0; i < compression_.size(); ++i)
            compression_[i] =
                breaking_.compression(maps_[1][4 * i + 2], maps_[1][4 * i + 3], maps_[0][4 * i + 3]);
        if (step.plumeAnew)
            for (auto* plumes : {&bands_[c].plume, &bands_[c].plumeNext}) std::ranges::fill(*plumes, 0.0f);
        stepFoam(c, time, step);
        if (step.plumeFadings > 0) stepPlume(c, time, step);
    }
}

void FoamHistory::stepFoam(uint32_t c, double time, const FoamStep& step) {
    Band& band = bands_[c];
    const Cascade& cascade = sea_->cascades[c];
    const FoamDrift drift = foamDriftOf(sea_->desc, cascade, time);
    const double samples = cascade.samples;
    const Shifted here(compression_, cascade.samples, samples * drift.u, samples * drift.v);
    const float threshold = breaking_.threshold[c], perCompression = 1 / breaking_.softness[c];
    const float floor = fading_[c].foam.floor, fade = fading_[c].foam.over(step.fadings);
    std::swap(band.foam, band.foamNext);
    if (step.foamAnew) std::ranges::fill(band.foam, 0.0f);
    here.each([&](uint32_t n, float compression) {
        const float breaks = std::min((compression - threshold) * perCompression, 1.0f);
        band.foamNext[n] = std::max(fadedFoam(band.foam[n], fade, floor), breaks);
    });
}

void FoamHistory::stepPlume(uint32_t c, double time, const FoamStep& step) {
    Band& band = bands_[c];
    const Cascade& cascade = sea_->cascades[c];
    const FoamDrift drift = foamDriftOf(sea_->desc, cascade, time);
    const double samples = cascade.samples;
    const float threshold = breaking_.threshold[c], perCompression = 1 / breaking_.softness[c];
    const float floor = fading_[c].plume.floor, fade = fading_[c].plume.over(step.plumeFadings);
    std::swap(band.plume, band.plumeNext);
    for (size_t n = 0; n < band.plume.size(); ++n) band.plumeNext[n] = fadedPlume(band.plume[n], fade, floor);
    for (int tap = 0; tap < plumeTaps; ++tap) {
        const double ahead = plumeTap(tap) * samples / cascade.patch;
        const Shifted there(compression_, cascade.samples,
                            samples * drift.u + ahead * double{breaking_.runs[c][0]},
                            samples * drift.v + ahead * double{breaking_.runs[c][1]});
        there.each([&](uint32_t n, float compression) {
            const float breaks = std::min((compression - threshold) * perCompression, 1.0f);
            band.plumeNext[n] = std::max(band.plumeNext[n], breaks);
        });
    }
}

} // namespace seaglass
