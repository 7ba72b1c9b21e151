// What share of light water mirrors, in another form than the shader's: from the two polarisations, or from
// Schlick's power in full.
#pragma once

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "seaglass/water.h"

namespace tests {

constexpr double waterIndex = 1.333;

constexpr seaglass::Fresnel formulas[] = {seaglass::Fresnel::exact, seaglass::Fresnel::schlick};

inline std::string formulaName(const testing::TestParamInfo<seaglass::Fresnel>& test) {
    return test.param == seaglass::Fresnel::exact ? "Exact" : "Schlick";
}

/// Of light in air, by the cosine of its angle to the normal.
inline double reflectance(double cosine, seaglass::Fresnel formula = seaglass::Fresnel::exact) {
    const double n = waterIndex;
    if (formula == seaglass::Fresnel::schlick) {
        const double straightOn = std::pow((n - 1) / (n + 1), 2);
        return straightOn + (1 - straightOn) * std::pow(1 - cosine, 5);
    }
    const double transmitted = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
    const double s = (cosine - n * transmitted) / (cosine + n * transmitted);
    const double p = (transmitted - n * cosine) / (transmitted + n * cosine);
    return (s * s + p * p) / 2;
}

/// Of light in water; 1 beyond the critical angle.
inline double reflectanceBelow(double cosine, seaglass::Fresnel formula = seaglass::Fresnel::exact) {
    const double sine = waterIndex * std::sqrt(1 - cosine * cosine);
    return sine >= 1 ? 1 : reflectance(std::sqrt(1 - sine * sine), formula);
}

} // namespace tests
