// Public functions that return numbers, asked anything: they give numbers, or say that they do not.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "seaglass/fog.h"
#include "seaglass/reflection.h"
#include "seaglass/sea.h"
#include "seaglass/shore.h"
#include "seaglass/water_type.h"

namespace {

using namespace seaglass;

constexpr double anything[] = {0,
                               -0.0,
                               1,
                               -1,
                               1e-300,
                               1e30,
                               -1e30,
                               1e300,
                               -1e300,
                               std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()};

/// As a float holds it.
float asFloat(double value) {
    return std::abs(value) <= double{std::numeric_limits<float>::max()} || !std::isfinite(value)
               ? static_cast<float>(value)
               : std::copysign(std::numeric_limits<float>::max(), static_cast<float>(value > 0 ? 1 : -1));
}

void destroyed(Sea* sea) {
    destroySea(sea);
}

using MadeSea = std::unique_ptr<Sea, void (*)(Sea*)>;

/// With a beach, so that all that a sea can tell is there.
MadeSea smallSea() {
    static constexpr float bed[] = {-4, -4, -1, -1, 2, 2};
    ShoreDesc shore;
    shore.bed = bed;
    shore.samples[0] = 2;
    shore.samples[1] = 3;
    shore.spacing = 20;
    SeaDesc desc;
    desc.samples = 16;
    desc.cascades = 1;
    desc.depth = 4;
    desc.shore = &shore;
    SeaError error;
    MadeSea sea(createSea(&desc, &error), destroyed);
    EXPECT_TRUE(sea) << error.text;
    return sea;
}

bool isShare(double value) {
    return value >= 0 && value <= 1;
}

bool areFinite(const float* values, size_t count) {
    return std::all_of(values, values + count, [](float value) { return std::isfinite(value); });
}

bool isSound(const HeightSample& s) {
    return std::isfinite(s.height) && areFinite(s.normal, 3) && areFinite(s.velocity, 3) &&
           std::abs(std::hypot(s.normal[0], s.normal[1], s.normal[2]) - 1) < 1e-3f;
}

bool isSound(const FogBlock& block) {
    return areFinite(block.color, 4) && areFinite(block.form, 4) && areFinite(block.reach, 4);
}

/// One argument or field of a function; `isTotal` says whether the answer holds with it.
struct Asked {
    const char* name;
    std::function<bool(double)> isTotal;
};

void expectTotal(const std::vector<Asked>& all) {
    for (const Asked& asked : all)
        for (const double value : anything) EXPECT_TRUE(asked.isTotal(value)) << asked.name << " = " << value;
}

Asked ofFog(const char* name, FogShape shape, void (*set)(FogDesc&, double)) {
    return {name, [shape, set](double value) {
                FogDesc fog;
                fog.shape = shape;
                set(fog, value);
                for (const double from : anything)
                    for (const double way : anything)
                        if (!isShare(fogTransmittance(fog, from, 0.3 * way, way)) ||
                            !isShare(fogTransmittance(fog, from, way, 1000)))
                            return false;
                return isSound(fogBlock(fog, 2)) && isSound(fogBlock(fog, value));
            }};
}

TEST(Total, FogIsAShareOfLight) {
    const auto height = FogShape::height, linear = FogShape::linear;
    const auto exponential = FogShape::exponential, squared = FogShape::exponentialSquared;
    expectTotal({
        ofFog("density", exponential, [](FogDesc& f, double x) { f.density = asFloat(x); }),
        ofFog("density squared", squared, [](FogDesc& f, double x) { f.density = asFloat(x); }),
        ofFog("density of height", height, [](FogDesc& f, double x) { f.density = asFloat(x); }),
        ofFog("falloff", height, [](FogDesc& f, double x) { f.falloff = asFloat(x); }),
        ofFog("baseHeight", height, [](FogDesc& f, double x) { f.baseHeight = x; }),
        ofFog("start", linear, [](FogDesc& f, double x) { f.start = asFloat(x); }),
        ofFog("end", linear, [](FogDesc& f, double x) { f.end = asFloat(x); }),
        ofFog("start and end", linear, [](FogDesc& f, double x) { f.start = f.end = asFloat(x); }),
        ofFog("color", exponential, [](FogDesc& f, double x) { f.color[1] = asFloat(x); }),
        ofFog("fromSky", exponential, [](FogDesc& f, double x) { f.fromSky = asFloat(x); }),
        ofFog("most", exponential, [](FogDesc& f, double x) { f.most = asFloat(x); }),
    });
}

TEST(Total, SkiesSendLight) {
    const auto isLight = [](const LightingDesc& lighting, double y) {
        const double direction[3] = {0, y, 0};
        float out[3];
        skyRadiance(lighting, direction, out);
        return areFinite(out, 3) && std::all_of(out, out + 3, [](float light) { return light >= 0; });
    };
    const auto ofColor = [&](float(LightingDesc::*color)[3]) {
        return [isLight, color](double x) {
            LightingDesc lighting;
            (lighting.*color)[1] = asFloat(x);
            return isLight(lighting, 0.3) && isLight(lighting, -0.3) && isLight(lighting, x);
        };
    };
    expectTotal({{"direction", [&](double x) { return isLight({}, x); }},
                 {"skyZenith", ofColor(&LightingDesc::skyZenith)},
                 {"skyHorizon", ofColor(&LightingDesc::skyHorizon)},
                 {"skyGround", ofColor(&LightingDesc::skyGround)}});
}

TEST(Total, HeightsAreNumbers) {
    const MadeSea sea = smallSea();
    HeightGrid* const grid = createHeightGrid(*sea, std::numeric_limits<double>::infinity());
    ASSERT_TRUE(grid);
    const auto at = [&](double time, double u, double v) {
        const double point[2] = {u, v};
        HeightSample sum, ofGrid;
        sampleHeights(*sea, time, point, 1, &sum);
        setTime(*grid, time);
        sampleHeights(*grid, point, 1, &ofGrid);
        return isSound(sum) && isSound(ofGrid);
    };
    expectTotal({{"time", [&](double x) { return at(x, 3, 4); }},
                 {"u", [&](double x) { return at(7, x, 4); }},
                 {"v", [&](double x) { return at(7, 3, x); }},
                 {"all", [&](double x) { return at(x, x, x); }}});
    destroyHeightGrid(grid);
}

TEST(Total, SandIsWetByShares) {
    const MadeSea sea = smallSea();
    const auto at = [&](double time, double drying, double eye, double u, double v, double height) {
        const uint32_t count = shoreRowCount(*sea, drying);
        std::vector<float> rows(4 * size_t{count});
        const double eyes[2] = {eye, -eye};
        const ShoreBlock block = shoreRows(*sea, time, drying, eyes, rows.data());
        const ShoreWetness wet = shoreWetness(*sea, block, rows.data(), u, v, height);
        return areFinite(rows.data(), rows.size()) && areFinite(block.place, 4) && areFinite(block.rows, 4) &&
               areFinite(block.form, 4) && isShare(wet.wet) && isShare(wet.under);
    };
    expectTotal({{"time", [&](double x) { return at(x, 60, 0, 3, 30, 0.1); }},
                 {"dryingTime", [&](double x) { return at(5, x, 0, 3, 30, 0.1); }},
                 {"eye", [&](double x) { return at(5, 60, x, 3, 30, 0.1); }},
                 {"u", [&](double x) { return at(5, 60, 0, x, 30, 0.1); }},
                 {"v", [&](double x) { return at(5, 60, 0, 3, x, 0.1); }},
                 {"height", [&](double x) { return at(5, 60, 0, 3, 30, x); }}});
}

TEST(Total, TintsAreWaterOrRefused) {
    const auto water = [](float tint, float visibility) {
        const float tints[3] = {0.01f, tint, 0.02f};
        WaterCoefficients out = {{7, 7, 7}, {7, 7, 7}};
        SeaError error;
        if (!tintedWater(tints, visibility, &out, &error))
            return out.absorption[0] == 7 && error.text[0] != 0;
        return areFinite(out.absorption, 3) && areFinite(out.backscatter, 3);
    };
    expectTotal({{"tint", [&](double x) { return water(asFloat(x), 10); }},
                 {"visibility", [&](double x) { return water(0.03f, asFloat(x)); }}});
}

TEST(Total, ClassesAndForcesAreKnown) {
    for (const double value : anything) {
        const float info = asFloat(value);
        const auto expected = info > 0   ? ReflectionClass::hit
                              : info < 0 ? ReflectionClass::sky
                                         : ReflectionClass::unknown;
        EXPECT_EQ(reflectionClass(info), expected) << info;
    }
    for (const uint32_t force : {13u, 1000u, ~0u})
        EXPECT_EQ(beaufortSea(force).windSpeed, beaufortSea(12).windSpeed);
    EXPECT_EQ(waterCoefficients(static_cast<WaterType>(99)).absorption[0],
              waterCoefficients(WaterType::clearOcean).absorption[0]);
}

} // namespace
