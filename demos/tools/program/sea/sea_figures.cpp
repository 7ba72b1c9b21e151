#include "program/sea/sea_figures.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "metrics/repetition/fft.h"
#include "water/interface/whitecaps.h"

namespace demos {

namespace {

constexpr double tau = 2 * std::numbers::pi;
constexpr double timeS = 100; ///< at which each seed is measured
constexpr double binRatio = 1.12;
constexpr uint32_t whitecapSeeds = 4; ///< foam has a history, and takes long

using SeaPtr = std::unique_ptr<seaglass::Sea, decltype(&seaglass::destroySea)>;
using StatePtr = std::unique_ptr<void, void (*)(void*)>;

/// Of gravity-capillary waves, from the formula rather than the library: what is measured here is its
/// surface.
double frequencyOf(double k, double depthM) {
    return std::sqrt((9.81 * k + 7.4e-5 * k * k * k) * std::tanh(std::min(k * depthM, 20.0)));
}

/// The integral of omega^power S over [low, high], by the midpoint rule over equal ratios.
double moment(const seaglass::Sea& sea, double low, double high, int power) {
    constexpr double step = 1e-3;
    const auto steps = static_cast<int>(std::ceil(std::log(high / low) / step));
    const double ratio = std::log(high / low) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double omega = low * std::exp((i + 0.5) * ratio);
        sum += seaglass::frequencySpectrum(sea, omega) * std::pow(omega, power + 1) * ratio;
    }
    return sum;
}

constexpr double longest = 1e-3, shortest = 1e4; // [rad/s]: no wave of wind lies beyond

void describeAsked(const seaglass::Sea& sea, SeaFigures& out) {
    if (seaglass::cascadeCount(sea) == 0) return;
    const double m0 = moment(sea, longest, shortest, 0), m2 = moment(sea, longest, shortest, 2);
    out.hsSpectrumM = 4 * std::sqrt(m0);
    out.resolvedShare = seaglass::resolvedShare(sea);
    out.hsResolvedM = out.hsSpectrumM * std::sqrt(out.resolvedShare);
    out.tpS = tau / seaglass::peakFrequency(sea);
    if (m2 > 0) out.tzS = tau * std::sqrt(m0 / m2);
    out.slopesRoughness = seaglass::unresolvedSlopeVariance(sea);
}

/// Height variance by frequency, in bins of equal ratio.
class Histogram {
  public:
    void add(double omega, double variance) {
        secondMoment_ += omega * omega * variance;
        const auto bin = static_cast<size_t>(std::max(std::log(omega / longest) / std::log(binRatio), 0.0));
        if (bin >= variance_.size()) variance_.resize(bin + 1);
        variance_[bin] += variance;
    }

    double secondMoment() const { return secondMoment_; }

    /// Those that hold more than rounding leaves in empty ones.
    std::vector<SpectrumBin> bins(const seaglass::Sea& sea, double seeds) const {
        std::vector<SpectrumBin> found;
        double all = 0;
        for (const double variance : variance_) all += variance;
        for (size_t i = 0; i < variance_.size(); ++i) {
            if (variance_[i] < 1e-9 * all) continue;
            const double low = longest * std::pow(binRatio, static_cast<double>(i)), high = low * binRatio;
            found.push_back({std::sqrt(low * high), moment(sea, low, high, 0) / (high - low),
                             variance_[i] / seeds / (high - low)});
        }
        return found;
    }

  private:
    std::vector<double> variance_;
    double secondMoment_ = 0;
};

/// The maps of one cascade.
struct Maps {
    std::vector<float> displacement, derivatives, moments;

    explicit Maps(uint32_t samples) {
        for (auto* map : {&displacement, &derivatives, &moments}) map->resize(size_t{4} * samples * samples);
    }
    seaglass::CascadeMaps out() { return {displacement.data(), derivatives.data(), moments.data()}; }
};

class Survey {
  public:
    Survey(const seaglass::WavesBackend& backend, SeaFigures& out) : backend_(backend), out_(out) {}

    bool add(const seaglass::Sea& sea) {
        const StatePtr state(backend_.create(sea), backend_.destroy);
        if (!state) return false;
        const uint32_t count = seaglass::cascadeCount(sea);
        out_.cascades.resize(count);
        double all = 0;
        for (uint32_t c = 0; c < count; ++c) {
            Maps maps(seaglass::cascade(sea, c).samples);
            backend_.evaluate(state.get(), c, timeS, maps.out());
            const double variance = addMaps(sea, c, maps);
            const double before = out_.cascades[c].variance;
            out_.cascades[c] = seaglass::cascade(sea, c);
            out_.cascades[c].variance = before + variance / seaSeeds;
            all += variance;
        }
        variance_ += all / seaSeeds;
        out_.hsSimulatedM += 4 * std::sqrt(all) / seaSeeds;
        return true;
    }

    void finish(const seaglass::Sea& sea) {
        if (variance_ == 0) return;
        out_.tzSimulatedS = tau * std::sqrt(variance_ / (histogram_.secondMoment() / seaSeeds));
        out_.bins = histogram_.bins(sea, seaSeeds);
    }

  private:
    /// The heights' variance.
    double addMaps(const seaglass::Sea& sea, uint32_t index, const Maps& maps) {
        const seaglass::Cascade& cascade = seaglass::cascade(sea, index);
        const size_t samples = cascade.samples;
        const auto texels = static_cast<double>(samples * samples);
        std::vector<std::complex<double>> heights(samples * samples);
        double variance = 0;
        for (size_t i = 0; i < heights.size(); ++i) {
            const double h = maps.displacement[4 * i + 1];
            heights[i] = h;
            variance += h * h / texels;
            out_.slopesResolved +=
                (static_cast<double>(maps.moments[4 * i]) + static_cast<double>(maps.moments[4 * i + 1])) /
                texels / seaSeeds;
        }
        fft2d(heights, samples);
        const double dk = tau / cascade.patch;
        const auto depth = static_cast<double>(seaglass::description(sea).depth);
        const auto signedIndex = [samples](size_t i) {
            return static_cast<double>(i) - (2 * i < samples ? 0.0 : static_cast<double>(samples));
        };
        for (size_t i = 0; i < heights.size(); ++i) {
            const double k = std::hypot(signedIndex(i % samples), signedIndex(i / samples)) * dk;
            // Of the rest the transform holds rounding alone, which high frequencies would make much of.
            if (!(k >= cascade.kMin && k < cascade.kMax && k > 0)) continue;
            histogram_.add(frequencyOf(k, depth), std::norm(heights[i]) / (texels * texels));
        }
        return variance;
    }

    const seaglass::WavesBackend& backend_;
    SeaFigures& out_;
    Histogram histogram_;
    double variance_ = 0;
};

SeaPtr makeSea(const seaglass::SeaDesc& desc, Error& error) {
    seaglass::SeaError problem;
    SeaPtr sea(seaglass::createSea(&desc, &problem), &seaglass::destroySea);
    if (!sea) error.text = problem.text;
    return sea;
}

bool outOfMemory(Error& error) {
    error.text = "out of memory, expected fewer --samples or --cascades";
    return false;
}

} // namespace

bool measureSea(const seaglass::SeaDesc& desc, const seaglass::WavesBackend& backend, SeaFigures& out,
                Error& error) {
    out = {};
    const SeaPtr first = makeSea(desc, error);
    if (!first) return false;
    describeAsked(*first, out);
    Survey survey(backend, out);
    seaglass::SeaDesc next = desc;
    for (uint32_t i = 0; i < seaSeeds; ++i, ++next.seed) {
        const SeaPtr sea = makeSea(next, error);
        if (!sea) return false;
        if (!survey.add(*sea)) return outOfMemory(error);
        if (i >= whitecapSeeds) continue;
        double cover = 0;
        if (!seaglass::whitecapCover(*sea, backend, {}, timeS, &cover)) return outOfMemory(error);
        out.whitecaps += cover / whitecapSeeds;
    }
    survey.finish(*first);
    return true;
}

} // namespace demos
