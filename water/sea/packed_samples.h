// Samples of twelve fields as 16-bit integers, each beside its neighbour along v, so that one multiply-add
// weighs both; and what lies between four of them. Both forms of the weighing give the same bits.
#pragma once

#include "water/sea/fourier.h"

#include <array>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace seaglass {

using Int4 = int32_t __attribute__((vector_size(16)));

constexpr size_t packedFields = 12;
struct alignas(16) PackedSample {
    std::array<int32_t, packedFields>
        pairs{}; ///< this sample's in the lower half, its neighbour's in the upper
};

/// A field lies in -packedMost..packedMost. What is read of it, alone or between samples, is packedMost times
/// as large, and times the field's scale what was stored.
constexpr int packedMost = 32767;

/// The scale of a field whose greatest magnitude is `most`; 0 where that is next to nothing.
inline float packedScale(float most) {
    return most > 1e-25f ? most / packedMost / packedMost : 0.0f;
}

/// What is stored of four values; 0 where their scale is.
inline Int4 packed(const Float4& values, float scale) {
    if (scale == 0) return Int4{};
    constexpr float above = packedMost + 1.5f; // its whole part is the nearest one, below 0 too
    return __builtin_convertvector(values / (scale * packedMost) + above, Int4) - (packedMost + 1);
}

inline Int4 paired(const Int4& low, const Int4& high) {
    return (low & 0xffff) | (high << 16);
}
inline Int4 lowerOf(const Int4& pairs) {
    return (pairs << 16) >> 16;
}

inline Int4 fourPairs(const PackedSample& sample, size_t field) {
    Int4 four;
    __builtin_memcpy(&four, &sample.pairs[field], sizeof four);
    return four;
}

/// Fields `field`..`field` + 3 of a sample; `field` is a multiple of 4.
inline Float4 fourOf(const PackedSample& sample, size_t field) {
    return __builtin_convertvector(lowerOf(fourPairs(sample, field)), Float4) * packedMost;
}

/// Shares of the four corners of four cells, in packedMost'ths, which add up to it: pairs of those at v and v
/// + 1.
struct CornerShares {
    Int4 here, next; ///< at u, at u + 1
};

/// Shares of the way along a cell, 0..1.
inline CornerShares cornerShares(const Float4& alongU, const Float4& alongV) {
    constexpr float whole = packedMost;
    const auto rounded = [](const Float4& x) { return __builtin_convertvector(x * whole + 0.5f, Int4); };
    const Int4 u = rounded(alongU), v = rounded(alongV), both = rounded(alongU * alongV);
    return {paired(packedMost - u - v + both, v - both), paired(u - both, both)};
}

/// One cell's of the four.
struct Corners {
    const PackedSample* first;
    size_t pitch;       ///< from u to u + 1
    int32_t here, next; ///< CornerShares
};

inline Int4 fourBetweenPortably(const Corners& corners, size_t field) {
    const auto row = [field](const PackedSample* at, int32_t shares) {
        const Int4 four = fourPairs(*at, field), weights = Int4{} + shares;
        return lowerOf(four) * lowerOf(weights) + (four >> 16) * (weights >> 16);
    };
    return row(corners.first, corners.here) + row(corners.first + corners.pitch, corners.next);
}

#if defined(__SSE2__)
inline Int4 fourBetweenBySse2(const Corners& corners, size_t field) {
    const auto row = [field](const PackedSample* at, int32_t shares) {
        const auto* const four = reinterpret_cast<const __m128i*>(&at->pairs[field]);
        return _mm_madd_epi16(_mm_load_si128(four), _mm_set1_epi32(shares));
    };
    return reinterpret_cast<Int4>(
        _mm_add_epi32(row(corners.first, corners.here), row(corners.first + corners.pitch, corners.next)));
}
#endif

/// Fields `field`..`field` + 3 between the corners; `field` is a multiple of 4.
inline Float4 fourBetween(const Corners& corners, size_t field) {
#if defined(__SSE2__)
    return __builtin_convertvector(fourBetweenBySse2(corners, field), Float4);
#else
    return __builtin_convertvector(fourBetweenPortably(corners, field), Float4);
#endif
}

} // namespace seaglass
