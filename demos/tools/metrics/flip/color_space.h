// The colour spaces of FLIP, all relative to the white of sRGB. Inline, and without branches that differ from
// pixel to pixel: so the compiler takes several pixels of a row at once.
// Divisions by a constant are products: they take a third of the time.
#pragma once

#include <array>
#include <cstddef>

#include "metrics/flip/power.h"

namespace demos {

using Rgb = std::array<float, 3>; ///< linear sRGB
using Xyz = std::array<float, 3>; ///< CIE XYZ, each divided by that of white
using Lab = std::array<float, 3>; ///< CIE L*a*b*
/// Y, Cx, Cz of S-CIELAB: L*a*b* without its cube root, linear in light, so that it may be filtered.
using Opponent = std::array<float, 3>;

namespace color_matrices {

using Matrix = std::array<std::array<double, 3>, 3>;

/// XYZ of sRGB's primaries under D65, as the code of FLIP's authors has it.
constexpr Matrix primaries = {{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                               {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                               {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

/// Its rows divided by their sums, which are the XYZ of white.
constexpr Matrix relativeToWhite(Matrix matrix) {
    for (auto& row : matrix) {
        const double white = row[0] + row[1] + row[2];
        for (double& value : row) value /= white;
    }
    return matrix;
}

constexpr Matrix inverse(const Matrix& m) {
    Matrix result{};
    double determinant = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (size_t j = 0; j < 3; ++j) {
            const size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            result[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
        }
        determinant += m[0][i] * (m[1][i1] * m[2][i2] - m[1][i2] * m[2][i1]);
    }
    for (auto& row : result) {
        for (double& value : row) value /= determinant;
    }
    return result;
}

constexpr std::array<std::array<float, 3>, 3> toFloat(const Matrix& matrix) {
    std::array<std::array<float, 3>, 3> result{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) result[i][j] = static_cast<float>(matrix[i][j]);
    }
    return result;
}

constexpr auto toXyz = toFloat(relativeToWhite(primaries));
constexpr auto toRgb = toFloat(inverse(relativeToWhite(primaries)));

inline std::array<float, 3> apply(const std::array<std::array<float, 3>, 3>& m,
                                  const std::array<float, 3>& v) {
    const auto row = [&](size_t i) { return m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2]; };
    return {row(0), row(1), row(2)};
}

} // namespace color_matrices

/// 0..1 of a display's bytes to light.
inline float decodeSrgb(float encoded) {
    const float curve = power((encoded + 0.055f) * (1 / 1.055f), 2.4f);
    return encoded <= 0.04045f ? encoded * (1 / 12.92f) : curve;
}

inline Xyz xyzOfRgb(const Rgb& rgb) {
    return color_matrices::apply(color_matrices::toXyz, rgb);
}

inline Rgb rgbOfXyz(const Xyz& xyz) {
    return color_matrices::apply(color_matrices::toRgb, xyz);
}

inline Opponent opponentOfXyz(const Xyz& xyz) {
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

inline Xyz xyzOfOpponent(const Opponent& opponent) {
    const float y = (opponent[0] + 16) * (1 / 116.0f);
    return {y + opponent[1] * (1 / 500.0f), y, y - opponent[2] * (1 / 200.0f)};
}

/// CIE 15: the cube root, with a straight line near black.
inline float lightness(float ratio) {
    constexpr float delta = 6.0f / 29;
    const float root = power(ratio, 1.0f / 3);
    return ratio > delta * delta * delta ? root : ratio * (1 / (3 * delta * delta)) + 4.0f / 29;
}

inline Lab labOfXyz(const Xyz& xyz) {
    const float x = lightness(xyz[0]), y = lightness(xyz[1]), z = lightness(xyz[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Colours fade as it darkens (the Hunt effect).
inline Lab huntAdjusted(const Lab& lab) {
    return {lab[0], 0.01f * lab[0] * lab[1], 0.01f * lab[0] * lab[2]};
}

} // namespace demos
