#include "host/timing/pass_samples.h"

#include <algorithm>
#include <cmath>

namespace demos {

double quantile(std::vector<double> samples, double q) {
    if (samples.empty()) return 0;
    std::sort(samples.begin(), samples.end());
    const double at = q * static_cast<double>(samples.size() - 1);
    const auto below = static_cast<size_t>(at);
    const size_t above = std::min(below + 1, samples.size() - 1);
    return samples[below] + (at - std::floor(at)) * (samples[above] - samples[below]);
}

PassTime summary(const std::string& name, const std::vector<double>& ms) {
    return {name, quantile(ms, 0.5), quantile(ms, 0.75) - quantile(ms, 0.25)};
}

void PassSamples::add(const std::string& name, double ms) {
    const auto known = std::find_if(samples_.begin(), samples_.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    if (known == samples_.end())
        samples_.push_back({name, {ms}});
    else
        known->second.push_back(ms);
}

std::vector<PassTime> PassSamples::medians() const {
    std::vector<PassTime> times;
    for (const auto& [name, ms] : samples_) times.push_back(summary(name, ms));
    return times;
}

} // namespace demos
