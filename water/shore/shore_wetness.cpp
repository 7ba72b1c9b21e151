// What the waves of a shore have wetted: the trains' rows of the last while, and how high film lay in the
// time of each sample of the past. Samples follow one another without a gap, so that no wave is missed at any
// age.
#include "seaglass/shore.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include "gpu/held_in.h"
#include "water/sea/sea.h"
#include "water/sea/smoothstep.h"

namespace seaglass {
namespace {

constexpr uint32_t aimedSamples = 80;
constexpr double leastDrying = 1, mostDrying = 300; // [s]

/// Up to where film has lain in a sample's time, and lies; the water's edge.
using Row = std::array<float, 4>;

struct PastSamples {
    double drying, seconds;
    uint32_t stride, count, rows; ///< rows from sample to sample; samples; rows of a train
};

PastSamples pastSamplesOf(const Shore& shore, double dryingTime) {
    PastSamples past;
    past.drying = std::isfinite(dryingTime) ? std::clamp(dryingTime, leastDrying, mostDrying) : mostDrying;
    const double step = shore.rowStep();
    past.stride = std::max(1u, static_cast<uint32_t>(std::ceil(past.drying / aimedSamples / step)));
    past.seconds = past.stride * step;
    past.count = static_cast<uint32_t>(std::ceil(past.drying / past.seconds)) + 2;
    past.rows = shore.rowCount() + past.count * past.stride + 2;
    return past;
}

/// All of a train, newest first.
void fillTrain(const Shore& shore, uint32_t train, double time, const PastSamples& past, Row* rows) {
    const uint32_t oldest = past.rows + past.stride;
    std::vector<float> films(oldest + 1);
    shore.follow(train, time, oldest, [&](uint32_t back, const ShoreRow& row) {
        films[back] = row.wet;
        if (back < past.rows) rows[back] = {0, row.wet, row.swash, 0};
    });
    for (uint32_t i = 0; i < past.rows; ++i)
        rows[i][0] = *std::max_element(films.begin() + i, films.begin() + i + past.stride + 1);
}

float highestOf(std::span<const Row> train) {
    float highest = train[0][0];
    for (const Row& row : train) highest = std::max(highest, row[0]);
    return highest;
}

/// [m] Beyond the map all is as at its edge; so that floats hold it.
constexpr double farthestPlace = 1e30;

const Shore* shoreOf(const Sea& sea) {
    return sea.shore ? &*sea.shore : nullptr;
}

} // namespace

void shoreSamples(const Sea& sea, uint32_t out[2]) {
    const Shore* const shore = shoreOf(sea);
    for (size_t axis = 0; axis < 2; ++axis) out[axis] = shore ? shore->samples()[axis] : 0;
}

bool shoreTexels(const Sea& sea, float* out) {
    const Shore* const shore = shoreOf(sea);
    if (!shore) return false;
    for (const ShorePlace& place : shore->places()) {
        out = std::copy(place.arrival.begin(), place.arrival.end(), out);
        *out++ = place.swash;
    }
    return true;
}

uint32_t shoreRowCount(const Sea& sea, double dryingTime) {
    const Shore* const shore = shoreOf(sea);
    return shore ? shoreTrains * pastSamplesOf(*shore, dryingTime).rows : 0;
}

ShoreBlock shoreRows(const Sea& sea, double time, double dryingTime, const double eye[2], float* rows) {
    ShoreBlock block;
    const Shore* const shore = shoreOf(sea);
    if (!shore) return block;
    const double now = Shore::heldTime(time);
    const PastSamples past = pastSamplesOf(*shore, dryingTime);
    std::vector<Row> made(size_t{shoreTrains} * past.rows);
    float highest = 0;
    for (uint32_t train = 0; train < shoreTrains; ++train) {
        const std::span<Row> own(&made[size_t{train} * past.rows], past.rows);
        if (shore->runs()) fillTrain(*shore, train, now, past, own.data());
        highest += highestOf(own);
    }
    std::memcpy(rows, made.data(), made.size() * sizeof(Row));
    const double step = shore->rowStep();
    for (size_t axis = 0; axis < 2; ++axis)
        block.place[axis] = static_cast<float>(
            (heldWithin(farthestPlace, eye[axis]) - shore->origin()[axis]) / shore->spacing());
    block.place[2] = static_cast<float>(1 / shore->spacing());
    block.rows[0] = static_cast<float>(1 / step);
    block.rows[1] = static_cast<float>(std::ceil(now / step) - now / step);
    block.rows[2] = static_cast<float>(past.rows);
    block.rows[3] = static_cast<float>(past.stride);
    block.form[0] = static_cast<float>(past.count);
    block.form[1] = static_cast<float>(past.seconds);
    block.form[2] = static_cast<float>(past.drying);
    block.form[3] = highest;
    return block;
}

// As seaglass_wetness() of shaders/host/shore_wetness.glsl.
ShoreWetness shoreWetness(const Sea& sea, const ShoreBlock& block, const float* rows, double u, double v,
                          double height) {
    const Shore* const shore = shoreOf(sea);
    if (!shore || !(block.rows[2] > 0) || std::isnan(height)) return {};
    const auto eye = [&](size_t axis) {
        return double{block.place[axis]} * shore->spacing() + shore->origin()[axis];
    };
    const ShorePlace here = shore->at(eye(0) + u, eye(1) + v);
    const double moves = double{here.swash};
    ShoreWetness out{1 - smoothstep(0, std::max(0.3 * moves, 1e-3), height), height < 0 ? 1.0 : 0.0};
    const double wicks = 0.15 * moves; // it climbs so far from where it stands [m]
    if (!(moves > 0) || height > moves * double{block.form[3]} + wicks) return out;
    const auto reach = [&](size_t which, uint32_t sample) {
        double sum = 0;
        for (size_t t = 0; t < shoreTrains; ++t) {
            const double now =
                std::max(double{here.arrival[t]} * double{block.rows[0]} + double{block.rows[1]}, 0.0);
            const double row = std::min(now + sample * double{block.rows[3]}, double{block.rows[2]} - 1.001);
            const auto whole = static_cast<size_t>(row);
            const float* const newer = rows + 4 * (t * static_cast<size_t>(block.rows[2]) + whole) + which;
            sum += std::lerp(double{newer[0]}, double{newer[4]}, row - static_cast<double>(whole));
        }
        return moves * sum;
    };
    const double film = std::clamp((reach(1, 0) - height) / std::max(0.8 * moves, 1e-3), 0.0, 1.0);
    out.under = std::max({out.under, smoothstep(0, 0.025, reach(2, 0) - height), film});
    for (uint32_t sample = 0; sample < static_cast<uint32_t>(block.form[0]); ++sample) {
        const double left = 1 - smoothstep(0, 1, sample * double{block.form[1]} / double{block.form[2]});
        if (left <= out.wet) break;
        out.wet = std::max(out.wet, left * smoothstep(-wicks, 0, reach(0, sample) - height));
    }
    return out;
}

} // namespace seaglass
