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
        {name + std::string(", 99th percentile"), print("%.6f", comparison.flipP99), atMost(limits.flipP99)},
        {name + std::string(", greatest"), print("%.6f", comparison.flipMax), atMost(limits.flipMax)},
        {print("%s, greatest mean of %ux%u", name, localSide, localSide),
         print("%.6f", comparison.local.mean), atMost(limits.flipLocal)},
        {linear ? "PSNR, of the reference's greatest" : "PSNR",
         std::isfinite(comparison.psnrDb) ? print("%.2f dB", comparison.psnrDb) : "infinite", ""},
        {"difference, mean", print("%.6g", comparison.difference.mean), atMost(limits.differenceMean)},
        {"difference, greatest", print("%.6g", comparison.difference.max), ""},
    };
    for (size_t i = 0; i < limits.shares.size(); ++i) {
        all.push_back({print("share off by more than %.6g%s", limits.shares[i].over,
                             limits.shares[i].around ? " from all around" : ""),
                       print("%.6g", comparison.shares[i]), atMost(limits.shares[i].share)});
    }
    const WrongLimit& wrong = limits.wrong;
    all.push_back({print("share of FLIP over %.6g", wrong.over), print("%.6g", comparison.wrongShare()),
                   atMost(wrong.share)});
    all.push_back({"most of those that touch", pixels(comparison.wrong.largest.pixels),
                   wrong.blob ? print("at most %llu", static_cast<unsigned long long>(*wrong.blob)) : ""});
    if (comparison.difference.alpha > 0)
        all.push_back({print("share of alpha off by more than %.6g", wrong.over),
                       print("%.6g", comparison.alphaShare), atMost(wrong.share)});
    if (limits.outliers)
        all.push_back({"over twice as bright as all around", pixels(comparison.outliers.pixels),
                       print("at most %llu", static_cast<unsigned long long>(*limits.outliers))});
    if (comparison.leftOut > 0) all.push_back({"left out", pixels(comparison.leftOut), ""});
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

std::string measuresJson(const Pair& pair, const CompareOptions& options) {
    const Comparison& comparison = pair.comparison;
    const Limits& limits = pair.limits;
    const bool linear = pair.kind == PictureKind::linear;
    const auto orNull = [](const auto& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json json;
    json["reference"] = options.reference.string();
    json["test"] = options.test.string();
    json["size"] = {pair.expected().width, pair.expected().height};
    json["same"] = pair.objections.empty();
    json["objections"] = pair.objections;
    json["left_out_pixels"] = comparison.leftOut;
    json["not_finite_pixels"] = {{"reference", comparison.notFiniteInReference},
                                 {"test", comparison.notFiniteInTest}};
    json["flip"] = {{"kind", linear ? "hdr" : "ldr"},
                    {"pixels_per_degree", standardPixelsPerDegree},
                    {"mean", comparison.flipMean},
                    {"p99", comparison.flipP99},
                    {"max", comparison.flipMax},
                    {"local", comparison.local.mean},
                    {"worst", {comparison.worst.x, comparison.worst.y}}};
    if (limits.flipMean) json["flip"]["max_mean"] = *limits.flipMean;
    if (limits.flipP99) json["flip"]["max_p99"] = *limits.flipP99;
    if (limits.flipLocal) json["flip"]["max_local"] = *limits.flipLocal;
    if (limits.flipMax) json["flip"]["max_pixel"] = *limits.flipMax;
    if (linear) {
        const ExposureRange& range = comparison.exposures;
        json["flip"]["exposures"] = {
            {"start_ev", range.startEv}, {"stop_ev", range.stopEv}, {"count", range.count}};
    }
    // JSON knows no infinity: equal pictures have null.
    json["psnr_db"] = comparison.psnrDb;
    json["difference"] = {{"mean", comparison.difference.mean},
                          {"max", comparison.difference.max},
                          {"alpha", comparison.difference.alpha}};
    if (limits.differenceMean) json["difference"]["max_mean"] = *limits.differenceMean;
    if (limits.outliers)
        json["outliers"] = {{"pixels", comparison.outliers.pixels}, {"max_pixels", *limits.outliers}};
    json["shares"] = nlohmann::ordered_json::array();
    for (size_t i = 0; i < limits.shares.size(); ++i) {
        const ShareLimit& limit = limits.shares[i];
        json["shares"].push_back({{"over", limit.over},
                                  {"around", limit.around},
                                  {"share", comparison.shares[i]},
                                  {"max_share", limit.share}});
    }
    const Blob& blob = comparison.wrong.largest;
    json["wrong"] = {{"over", limits.wrong.over},
                     {"share", comparison.wrongShare()},
                     {"alpha_share", comparison.alphaShare},
                     {"max_share", orNull(limits.wrong.share)},
                     {"blob",
                      {{"pixels", blob.pixels},
                       {"max_pixels", orNull(limits.wrong.blob)},
                       {"box", {blob.left, blob.top, blob.width, blob.height}}}}};
    // Names come from file systems: what is no UTF-8 is replaced rather than thrown over.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Judged judgedPair(const CompareOptions& options, const Pair& pair) {
    return {options.test.string(),
            pair.objections.empty() ? ok : different,
            joined(pair.objections),
            measuresJson(pair, options),
            {},
            badness(pair.comparison, pair.limits)};
}

} // namespace demos
