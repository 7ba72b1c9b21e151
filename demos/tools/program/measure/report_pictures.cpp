#include "program/measure/report_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "metrics/magma.h"
#include "program/painted.h"

namespace demos {

namespace {

std::string exposureNote(const char* which, double exposureEv) {
    char text[96];
    std::snprintf(text, sizeof(text), " %s tone-mapped at an exposure of %.2f EV.", which, exposureEv);
    return text;
}

std::string number(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

/// Grey is left out.
std::vector<uint8_t> mapped(const std::vector<float>& values, const Mask& leftOut) {
    constexpr uint8_t grey = 96;
    std::vector<uint8_t> rgb = magma(values);
    for (size_t i = 0; i < leftOut.size(); ++i)
        if (leftOut[i] != 0) std::fill_n(&rgb[3 * i], 3, grey);
    return rgb;
}

ReportPictures ofLight(const CompareOptions& options, const Pair& pair) {
    const bool linear = pair.kind == PictureKind::linear;
    const Comparison& found = pair.comparison;
    const double exposureEv = options.exposureEv.value_or(middleGreyEv(found.exposures));
    const auto shown = [&](const Picture& picture) {
        return linear ? toneMap(picture, exposureEv) : paintedAsIs(picture);
    };
    ReportPictures pictures{shown(pair.expected()),
                            shown(pair.actual()),
                            mapped(found.flipMap, pair.leftOut),
                            linear ? exposureNote("Both are", exposureEv) : "",
                            linear ? "HDR-FLIP" : "FLIP",
                            {"0, unseen", "0.25", "0.5", "0.75", "1, plain"},
                            found.wrong.blobs};
    if (pictures.blobs.empty() && found.flipMax > 0)
        pictures.blobs.push_back({1, found.worst.x, found.worst.y, 1, 1});
    return pictures;
}

/// The least and the greatest that is finite in either.
std::pair<float, float> rangeOf(const Pair& pair) {
    float least = HUGE_VALF, greatest = -HUGE_VALF;
    for (const Picture* const picture : {&pair.expected(), &pair.actual()}) {
        for (size_t i = 0; i < picture->rgba.size(); ++i) {
            if (i % 4 == 3 || !std::isfinite(picture->rgba[i])) continue;
            least = std::min(least, picture->rgba[i]);
            greatest = std::max(greatest, picture->rgba[i]);
        }
    }
    return {least, std::max(greatest, least)};
}

/// How far each pixel is off at most in a channel, as a share of `whole`; 1 where that cannot be said.
std::vector<float> offBy(const Pair& pair, float whole) {
    const Picture &a = pair.expected(), &b = pair.actual();
    std::vector<float> off(a.rgba.size() / 4);
    for (size_t i = 0; i < off.size(); ++i) {
        if (!pair.leftOut.empty() && pair.leftOut[i] != 0) continue;
        for (size_t at = 4 * i; at < 4 * i + 3; ++at) {
            const float by = std::abs(a.rgba[at] - b.rgba[at]) / whole;
            off[i] = by < 1 ? std::max(off[i], by) : 1.0f;
            if (off[i] == 1) break;
        }
    }
    return off;
}

/// The limit is at a quarter of the map's scale.
ReportPictures ofData(const Pair& pair) {
    const auto [least, greatest] = rangeOf(pair);
    const float span = std::max(greatest - least, 1e-30f);
    const auto shown = [low = least, span](const Picture& picture) {
        const auto share = [=](float value) { return (value - low) / span; };
        return painted(picture, [&](const float* p) { return Rgb{share(p[0]), share(p[1]), share(p[2])}; });
    };
    const auto over = static_cast<float>(pair.limits.shares.empty() ? 0 : pair.limits.shares.front().over);
    const float whole = over > 0 ? 4 * over : span;
    const std::vector<float> off = offBy(pair, whole);
    const auto tick = [whole](float share) { return number("%.3g", static_cast<double>(share * whole)); };
    return {shown(pair.expected()),
            shown(pair.actual()),
            mapped(off, pair.leftOut),
            number(" Values, no light: black is %.4g,", static_cast<double>(least)) +
                number(" white %.4g.", static_cast<double>(greatest)),
            "difference",
            {"0", tick(0.25f), tick(0.5f), tick(0.75f), tick(1) + " or more"},
            findWrong(off, pair.expected().width, over > 0 ? 0.25 : 0).blobs};
}

} // namespace

ReportPictures reportPictures(const CompareOptions& options, const Pair& pair) {
    const bool data =
        pair.kind == PictureKind::linear && isData(options.stages.of(options.reference.filename()));
    return data ? ofData(pair) : ofLight(options, pair);
}

std::vector<uint8_t> reportPicture(const PictureFile& file, std::string& note) {
    const Picture& picture = file.picture;
    if (file.header.integer) return paintedAsIs(picture);
    Picture finite = picture;
    for (float& value : finite.rgba)
        if (!std::isfinite(value)) value = 0;
    const double exposureEv = middleGreyEv(exposureRange({finite.width, finite.height, finite.rgba}));
    note = exposureNote("It is", exposureEv);
    return toneMap(finite, exposureEv);
}

} // namespace demos
