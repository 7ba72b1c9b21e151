#include "metrics/color_space.h"

#include <cmath>

namespace demos {

namespace {

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

std::array<float, 3> apply(const std::array<std::array<float, 3>, 3>& m, const std::array<float, 3>& v) {
    const auto row = [&](size_t i) { return m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2]; };
    return {row(0), row(1), row(2)};
}

/// CIE 15: the cube root, with a straight line near black.
float lightness(float ratio) {
    constexpr float delta = 6.0f / 29;
    return ratio > delta * delta * delta ? std::cbrt(ratio) : ratio / (3 * delta * delta) + 4.0f / 29;
}

} // namespace

float decodeSrgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Xyz xyzOfRgb(const Rgb& rgb) {
    return apply(toXyz, rgb);
}

Rgb rgbOfXyz(const Xyz& xyz) {
    return apply(toRgb, xyz);
}

Opponent opponentOfXyz(const Xyz& xyz) {
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Xyz xyzOfOpponent(const Opponent& opponent) {
    const float y = (opponent[0] + 16) / 116;
    return {y + opponent[1] / 500, y, y - opponent[2] / 200};
}

Lab labOfXyz(const Xyz& xyz) {
    const float x = lightness(xyz[0]), y = lightness(xyz[1]), z = lightness(xyz[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

} // namespace demos
