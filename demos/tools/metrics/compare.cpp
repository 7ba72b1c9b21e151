#include "metrics/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numeric>

#include "metrics/finite.h"
#include "metrics/psnr.h"

namespace demos {

namespace {

/// Black wherever either picture is not finite, so that no filter spreads it.
std::vector<float> mended(const PixelView& image, const PixelView& other) {
    std::vector<float> rgba(image.rgba.begin(), image.rgba.end());
    for (size_t i = 0; i < image.pixels(); ++i) {
        if (!isFinite(image, i) || !isFinite(other, i)) std::fill_n(&rgba[4 * i], 4, 0.0f);
    }
    return rgba;
}

/// Of what is finite.
double greatest(const PixelView& image) {
    float most = 0;
    for (size_t i = 0; i < image.pixels(); ++i) {
        if (isFinite(image, i))
            most = std::max({most, image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2]});
    }
    return static_cast<double>(most);
}

std::string describe(const Blob& blob, double over) {
    char text[160];
    std::snprintf(text, sizeof(text), "%llu pixels of FLIP over %.4g lie together, %ux%u at %u,%u",
                  static_cast<unsigned long long>(blob.pixels), over, blob.width, blob.height, blob.left,
                  blob.top);
    return text;
}

/// The value that 99 % of 0 .. 1 are not over, where as many zeros as are left out do not count. By their
/// first bits, which order them, most are set aside.
float percentile99(std::span<const float> values, size_t leftOut) {
    constexpr uint32_t setAside = 14;
    const auto binOf = [](float value) { return std::bit_cast<uint32_t>(value) >> setAside; };
    std::vector<size_t> counts(binOf(1.0f) + 1);
    for (const float value : values) ++counts[binOf(value)];
    size_t rank = leftOut + ((values.size() - leftOut) * 99 + 99) / 100 - 1;
    uint32_t bin = 0;
    for (; rank >= counts[bin]; ++bin) rank -= counts[bin];
    std::vector<float> same;
    std::copy_if(values.begin(), values.end(), std::back_inserter(same),
                 [&](float value) { return binOf(value) == bin; });
    const auto found = same.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(same.begin(), found, same.end());
    return *found;
}

Place placeOf(size_t pixel, uint32_t width) {
    return {static_cast<uint32_t>(pixel % width), static_cast<uint32_t>(pixel / width)};
}

void pool(Comparison& comparison, uint32_t width) {
    const std::vector<float>& values = comparison.flipMap;
    comparison.flipMean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(comparison.compared());
    const auto worst = std::max_element(values.begin(), values.end());
    comparison.flipMax = static_cast<double>(*worst);
    comparison.worst = placeOf(static_cast<size_t>(worst - values.begin()), width);
    comparison.flipP99 = static_cast<double>(percentile99(values, comparison.leftOut));
}

void see(Comparison& found, const PixelView& reference, const PixelView& test, PictureKind kind) {
    if (kind == PictureKind::display) {
        found.flipMap = flip(reference, test);
        return;
    }
    HdrFlip hdr = hdrFlip(reference, test);
    found.flipMap = std::move(hdr.map);
    found.exposures = hdr.exposures;
}

/// The reference, with black in place of what is not finite and left out.
std::vector<float> withoutBroken(const PixelView& reference, const Mask& leftOut) {
    std::vector<float> rgba(reference.rgba.begin(), reference.rgba.end());
    for (size_t i = 0; i < leftOut.size(); ++i) {
        const auto pixel = rgba.begin() + static_cast<std::ptrdiff_t>(4 * i);
        const auto sound = [](float value) { return std::isfinite(value); };
        if (leftOut[i] != 0 && !std::all_of(pixel, pixel + 4, sound)) std::fill_n(pixel, 4, 0.0f);
    }
    return rgba;
}

/// The test, with the reference's pixels in place of those that are left out: then no filter spreads them.
std::vector<float> masked(const PixelView& test, const std::vector<float>& reference, const Mask& leftOut) {
    std::vector<float> rgba(test.rgba.begin(), test.rgba.end());
    for (size_t i = 0; i < leftOut.size(); ++i)
        if (leftOut[i] != 0) std::copy_n(&reference[4 * i], 4, &rgba[4 * i]);
    return rgba;
}

void measure(Comparison& found, const PixelView& reference, const PixelView& test, PictureKind kind,
             const Limits& limits, const Mask& leftOut = {}) {
    found.notFiniteInReference = countNotFinite(reference);
    found.notFiniteInTest = countNotFinite(test);
    if (found.notFiniteInReference + found.notFiniteInTest == 0) {
        see(found, reference, test, kind);
    } else {
        const std::vector<float> a = mended(reference, test), b = mended(test, reference);
        see(found, {reference.width, reference.height, a}, {test.width, test.height, b}, kind);
        for (size_t i = 0; i < found.flipMap.size(); ++i)
            if (!isFinite(reference, i) || !isFinite(test, i)) found.flipMap[i] = 1;
        found.brokenReference = placeOf(firstNotFinite(reference), reference.width);
        found.brokenTest = placeOf(firstNotFinite(test), test.width);
    }
    for (size_t i = 0; i < leftOut.size(); ++i)
        if (leftOut[i] != 0) found.flipMap[i] = 0;
    pool(found, reference.width);
    found.local = worstSquare(found.flipMap, reference.width, localSide);
    if (kind == PictureKind::linear && limits.outliers) found.outliers = findOutliers(reference, test);
    found.wrong = findWrong(found.flipMap, reference.width, limits.wrong.over);

    found.difference = difference(reference, test, found.leftOut);
    found.psnrDb =
        psnrDb(found.difference.meanSquare, kind == PictureKind::display ? 1 : greatest(reference));
    const double ofCompared = static_cast<double>(reference.pixels()) / static_cast<double>(found.compared());
    std::transform(limits.shares.begin(), limits.shares.end(), found.shares.begin(),
                   [&](const ShareLimit& limit) {
                       const auto share = limit.around ? shareUnlikeAround : shareOver;
                       return ofCompared * share(reference, test, limit.over);
                   });
    if (found.difference.alpha > 0)
        found.alphaShare = ofCompared * shareOfAlphaOver(reference, test, limits.wrong.over);
}

} // namespace

std::string toText(const Place& place) {
    return std::to_string(place.x) + "," + std::to_string(place.y);
}

Comparison compare(const PixelView& reference, const PixelView& test, PictureKind kind, const Limits& limits,
                   const Mask& leftOut) {
    Comparison found;
    found.shares.resize(limits.shares.size());
    found.sameSize = reference.width == test.width && reference.height == test.height;
    if (!found.sameSize || reference.pixels() == 0) return found;
    if (leftOut.empty()) {
        measure(found, reference, test, kind, limits);
        return found;
    }
    found.leftOut = static_cast<size_t>(
        std::count_if(leftOut.begin(), leftOut.end(), [](uint8_t one) { return one != 0; }));
    found.flipMap.resize(reference.pixels());
    if (found.compared() == 0) return found;
    const std::vector<float> sound = withoutBroken(reference, leftOut), same = masked(test, sound, leftOut);
    measure(found, {reference.width, reference.height, sound}, {test.width, test.height, same}, kind, limits,
            leftOut);
    return found;
}

double badness(const Comparison& comparison, const Limits& limits) {
    const bool none = comparison.leftOut > 0 && comparison.compared() == 0;
    if (none || comparison.notFiniteInReference + comparison.notFiniteInTest > 0) return HUGE_VAL;
    double worst = 0;
    const auto add = [&worst](double is, const std::optional<double>& limit) {
        if (limit && is > 0) worst = std::max(worst, is / *limit);
    };
    add(comparison.flipMean, limits.flipMean);
    add(comparison.flipP99, limits.flipP99);
    add(comparison.flipMax, limits.flipMax);
    add(comparison.local.mean, limits.flipLocal);
    add(comparison.difference.mean, limits.differenceMean);
    for (size_t i = 0; i < limits.shares.size(); ++i) add(comparison.shares[i], limits.shares[i].share);
    add(comparison.wrongShare(), limits.wrong.share);
    add(comparison.alphaShare, limits.wrong.share);
    if (limits.outliers)
        add(static_cast<double>(comparison.outliers.pixels), static_cast<double>(*limits.outliers));
    if (limits.wrong.blob)
        add(static_cast<double>(comparison.wrong.largest.pixels), static_cast<double>(*limits.wrong.blob));
    return worst;
}

std::vector<std::string> objections(const Comparison& comparison, const Limits& limits) {
    if (!comparison.sameSize) return {"the pictures differ in size"};
    if (comparison.leftOut > 0 && comparison.compared() == 0)
        return {"every pixel is left out, expected some to compare"};
    std::vector<std::string> all;
    const auto notFinite = [&all](const char* which, uint64_t pixels, const Place& first) {
        if (pixels == 0) return;
        all.push_back("NaN or infinity in " + std::to_string(pixels) + " pixels of the " + which +
                      ", the first at " + toText(first) + ", expected none");
    };
    notFinite("reference", comparison.notFiniteInReference, comparison.brokenReference);
    notFinite("test", comparison.notFiniteInTest, comparison.brokenTest);
    const auto object = [&all](const std::string& what, double is, double limit) {
        // What is not a number is within no limit.
        if (is <= limit) return;
        char text[96];
        std::snprintf(text, sizeof(text), " is %.4g, expected at most %.4g", is, limit);
        all.push_back(what + text);
    };
    if (limits.flipMean) object("mean FLIP", comparison.flipMean, *limits.flipMean);
    if (limits.flipP99) object("99th percentile of FLIP", comparison.flipP99, *limits.flipP99);
    if (limits.flipMax) object("greatest FLIP of a pixel", comparison.flipMax, *limits.flipMax);
    if (limits.flipLocal)
        object("mean FLIP of the square at " + toText({comparison.local.left, comparison.local.top}),
               comparison.local.mean, *limits.flipLocal);
    if (limits.differenceMean) object("mean difference", comparison.difference.mean, *limits.differenceMean);
    for (size_t i = 0; i < limits.shares.size(); ++i) {
        char what[80];
        std::snprintf(what, sizeof(what), "share of pixels off by more than %.4g%s", limits.shares[i].over,
                      limits.shares[i].around ? " from all around" : "");
        object(what, comparison.shares[i], limits.shares[i].share);
    }
    const WrongLimit& wrong = limits.wrong;
    if (wrong.share) {
        char what[64];
        std::snprintf(what, sizeof(what), "share of pixels of FLIP over %.4g", wrong.over);
        object(what, comparison.wrongShare(), *wrong.share);
        std::snprintf(what, sizeof(what), "share of pixels whose alpha is off by more than %.4g", wrong.over);
        object(what, comparison.alphaShare, *wrong.share);
    }
    if (wrong.blob && comparison.wrong.largest.pixels > *wrong.blob) {
        all.push_back(describe(comparison.wrong.largest, wrong.over) + ", expected at most " +
                      std::to_string(*wrong.blob));
    }
    if (limits.outliers && comparison.outliers.pixels > *limits.outliers) {
        all.push_back(std::to_string(comparison.outliers.pixels) +
                      " pixels over twice as bright as all around them, or as far below 0, the first at " +
                      toText(comparison.outliers.first) + ", expected at most " +
                      std::to_string(*limits.outliers));
    }
    return all;
}

} // namespace demos
