#include "program/measure/measures.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace demos {

namespace {

[[gnu::format(printf, 1, 2)]] std::string print(const char* format, ...) {
    char text[128];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof(text), format, arguments);
    va_end(arguments);
    return text;
}

std::string atMost(double limit) {
    return print("at most %.6g", limit);
}

std::string atMost(const std::optional<double>& limit) {
    return limit ? atMost(*limit) : "";
}

std::string pixels(uint64_t count) {
    return std::to_string(count) + " pixels";
}

} // namespace

std::vector<Measure> measures(const Comparison& comparison, PictureKind kind, const Limits& limits) {
    const bool linear = kind == PictureKind::linear;
    const char* const name = linear ? "HDR-FLIP" : "FLIP";
    std::vector<Measure> all = {
        {"NaN or infinity, reference", pixels(comparison.notFiniteInReference), "none"},
        {"NaN or infinity, test", pixels(comparison.notFiniteInTest), "none"},
        {name + std::string(", mean"), print("%.6f", comparison.flipMean), atMost(limits.flipMean)},
        {name + std::string(", 99th percentile"), print("%.6f", comparison.flipP99), ""},
        {name + std::string(", greatest"), print("%.6f", comparison.flipMax), ""},
        {linear ? "PSNR, of the reference's greatest" : "PSNR",
         std::isfinite(comparison.psnrDb) ? print("%.2f dB", comparison.psnrDb) : "infinite", ""},
        {"difference, mean", print("%.6g", comparison.difference.mean), atMost(limits.differenceMean)},
        {"difference, greatest", print("%.6g", comparison.difference.max), ""},
    };
    for (size_t i = 0; i < limits.shares.size(); ++i) {
        all.push_back({print("share off by more than %.6g", limits.shares[i].over),
                       print("%.6g", comparison.shares[i]), atMost(limits.shares[i].share)});
    }
    const ExposureRange& range = comparison.exposures;
    if (linear) {
        all.push_back({"exposures of HDR-FLIP",
                       print("%.2f to %.2f EV, %d", range.startEv, range.stopEv, range.count), ""});
    }
    return all;
}

std::string measuresTable(const std::vector<Measure>& measures) {
    size_t width = 0;
    for (const Measure& measure : measures) width = std::max(width, measure.name.size());
    std::string table;
    for (const Measure& measure : measures) {
        table += measure.name + std::string(width + 2 - measure.name.size(), ' ') + measure.value;
        table += (measure.limit.empty() ? "" : ", expected " + measure.limit) + "\n";
    }
    return table;
}

std::string measuresJson(const Comparison& comparison, PictureKind kind, const CompareOptions& options,
                         const Image& size) {
    nlohmann::ordered_json json;
    const std::vector<std::string> found = objections(comparison, options.limits);
    json["reference"] = options.reference.string();
    json["test"] = options.test.string();
    json["size"] = {size.width, size.height};
    json["same"] = found.empty();
    json["objections"] = found;
    json["not_finite_pixels"] = {{"reference", comparison.notFiniteInReference},
                                 {"test", comparison.notFiniteInTest}};
    json["flip"] = {{"kind", kind == PictureKind::linear ? "hdr" : "ldr"},
                    {"pixels_per_degree", standardPixelsPerDegree},
                    {"mean", comparison.flipMean},
                    {"p99", comparison.flipP99},
                    {"max", comparison.flipMax}};
    if (options.limits.flipMean) json["flip"]["max_mean"] = *options.limits.flipMean;
    if (kind == PictureKind::linear) {
        const ExposureRange& range = comparison.exposures;
        json["flip"]["exposures"] = {
            {"start_ev", range.startEv}, {"stop_ev", range.stopEv}, {"count", range.count}};
    }
    // JSON knows no infinity: equal pictures have null.
    json["psnr_db"] = comparison.psnrDb;
    json["difference"] = {{"mean", comparison.difference.mean}, {"max", comparison.difference.max}};
    json["shares"] = nlohmann::ordered_json::array();
    for (size_t i = 0; i < options.limits.shares.size(); ++i) {
        const ShareLimit& limit = options.limits.shares[i];
        json["shares"].push_back(
            {{"over", limit.over}, {"share", comparison.shares[i]}, {"max_share", limit.share}});
    }
    // Names come from file systems: what is no UTF-8 is replaced rather than thrown over.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace demos
