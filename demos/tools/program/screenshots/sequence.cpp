#include "program/screenshots/sequence.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <nlohmann/json.hpp>

#include "program/compare/pair.h"
#include "program/measure/report_section.h"
#include "program/screenshots/frame_name.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Changes that are this small in FLIP are rounding, whatever their ratio.
constexpr double leastMean = 0.002, leastP99 = 0.02;

/// From a frame to the next.
struct Change {
    double mean = 0, p99 = 0; ///< of FLIP
};

Change changeOf(const Picture& from, const Picture& to, PictureKind kind, const Mask& leftOut) {
    const auto view = [](const Picture& picture) {
        return PixelView{picture.width, picture.height, picture.rgba};
    };
    const Comparison found = compare(view(from), view(to), kind, {}, leftOut);
    return {found.flipMean, found.flipP99};
}

/// A measure of a change beside the reference's.
struct Beside {
    const char* what;
    double is, reference;
    double allowed; ///< to be off by

    /// As a multiple of what is allowed.
    double off() const { return std::abs(is - reference) / allowed; }

    std::string objection() const {
        if (off() <= 1) return {};
        char text[160];
        std::snprintf(text, sizeof(text),
                      "%s of FLIP is %.4g, expected %.4g to %.4g as the reference's %.4g is", what, is,
                      std::max(reference - allowed, 0.0), reference + allowed, reference);
        return text;
    }
};

/// Notes in `judged` what is wrong with the change to `file`, unless one before was.
void judge(Judged& judged, const fs::path& file, const Change& reference, const Change& test, double share) {
    const Beside mean{"mean", test.mean, reference.mean, share * reference.mean + leastMean};
    const Beside p99{"99th percentile", test.p99, reference.p99, share * reference.p99 + leastP99};
    judged.badness = std::max({judged.badness, mean.off(), p99.off()});
    const std::string first = mean.objection(), second = p99.objection();
    if ((first.empty() && second.empty()) || !judged.why.empty()) return;
    judged.code = different;
    judged.why = "the change to " + file.filename().string() + ": " + first +
                 (first.empty() || second.empty() ? "" : "; ") + second;
}

std::optional<Pair> frameOf(const CompareOptions& options, const fs::path& file, Error& error) {
    CompareOptions one = options;
    one.reference /= file;
    one.test /= file;
    return readPair(one, error);
}

bool sameSize(const Pair& a, const Pair& b) {
    return a.expected().width == b.expected().width && a.expected().height == b.expected().height;
}

} // namespace

std::vector<Sequence> sequencesOf(const PicturePairs& pairs) {
    std::map<std::string, std::map<uint32_t, fs::path>> numbered;
    for (const auto& [name, files] : pairs) {
        const FrameName frame = frameName(name.stem().string());
        if (!frame.number || !files.inReference || !files.inTest || !files.problem.empty()) continue;
        numbered[(name.parent_path() / (frame.stem + "_*")).string() + name.extension().string()]
                [*frame.number] = name;
    }
    std::vector<Sequence> all;
    for (const auto& [name, frames] : numbered) {
        Sequence sequence{name, {}};
        const uint32_t first = frames.begin()->first;
        for (const auto& [number, file] : frames)
            if (number - first == sequence.files.size()) sequence.files.push_back(file);
        if (sequence.files.size() > 1) all.push_back(std::move(sequence));
    }
    return all;
}

Judged judgedSequence(const CompareOptions& options, const Sequence& sequence) {
    Judged judged{sequence.name, ok, {}, {}};
    nlohmann::ordered_json steps = nlohmann::ordered_json::array();
    std::optional<Pair> before;
    for (const fs::path& file : sequence.files) {
        Error unread; // that of the picture itself says so
        std::optional<Pair> now = frameOf(options, file, unread);
        if (!now) break;
        if (before && sameSize(*before, *now) && before->kind == now->kind) {
            const Change reference = changeOf(before->expected(), now->expected(), now->kind, now->leftOut);
            const Change test = changeOf(before->actual(), now->actual(), now->kind, now->leftOut);
            steps.push_back({{"to", file.string()},
                             {"reference", {{"mean", reference.mean}, {"p99", reference.p99}}},
                             {"test", {{"mean", test.mean}, {"p99", test.p99}}}});
            judge(judged, file, reference, test, *options.flicker);
        }
        before = std::move(now);
    }
    judged.section = sequenceSection(steps);
    judged.json = nlohmann::ordered_json{{"steps", steps}}.dump(
        2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    return judged;
}

} // namespace demos
