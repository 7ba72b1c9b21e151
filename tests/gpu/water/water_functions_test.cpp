// Functions of the water's shaders that no picture shows alone, called one by one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "spirv/bent_rays.comp.h"
#include "spirv/caustic_texels.comp.h"
#include "spirv/foam_parts.comp.h"
#include "spirv/glitter_patches.comp.h"
#include "spirv/rays_over_sand.comp.h"
#include "spirv/shore_rows.comp.h"
#include "spirv/surface_light.comp.h"
#include "spirv/surface_waves.comp.h"
#include "spirv/tile_needs.comp.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/shaders/shader_functions.h"

namespace {

using namespace tests;

class WaterFunctions : public ShaderFunctions {};

constexpr size_t shoreTrains = 3, shoreRowsOfTrain = 8, shoreArrivals = 16;

/// Arrivals, then the rows of each train, then what no train may reach.
std::vector<glm::vec4> shoreRowsOf(const std::vector<float>& arrivals, const std::vector<float>& swash) {
    std::vector<glm::vec4> rows(shoreArrivals + shoreTrains * shoreRowsOfTrain, glm::vec4(0));
    for (size_t i = 0; i < arrivals.size(); ++i) rows[i].x = arrivals[i];
    for (size_t i = 0; i < shoreTrains * shoreRowsOfTrain; ++i)
        rows[shoreArrivals + i].z = swash[i % shoreRowsOfTrain];
    rows.resize(rows.size() + 64, glm::vec4(1000));
    return rows;
}

TEST_F(WaterFunctions, ArrivalsOutsideOfTheRowsAreThoseOfItsEnds) {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> early = {-1, -1e30f, -infinity, std::nanf("")},
                             late = {7.5f, 9, 40, 1e30f, infinity};
    std::vector<float> arrivals = early;
    arrivals.insert(arrivals.end(), late.begin(), late.end());
    const std::vector<glm::vec4> heights =
        told(shore_rows_comp, shoreRowsOf(arrivals, {0.1f, 0.1f, 5, 5, 5, 5, 0.3f, 0.3f}));
    for (size_t i = 0; i < arrivals.size(); ++i)
        EXPECT_NEAR(heights[i].x, i < early.size() ? 0.3f : 0.9f, 1e-5f) << arrivals[i];
}

TEST_F(WaterFunctions, TheWatersEdgeDrawsBackNoFartherThanItsLowest) {
    constexpr float lowest = -1.2f;
    const std::vector<float> swash = {0, -0.2f, -0.35f, -0.5f, -0.7f, -0.9f, -0.3f, 0};
    std::vector<float> arrivals;
    for (int i = 0; i < 13; ++i) arrivals.push_back(0.25f + 0.5f * static_cast<float>(i));
    const std::vector<glm::vec4> edge = told(shore_rows_comp, shoreRowsOf(arrivals, swash));
    size_t held = 0;
    for (size_t i = 0; i < arrivals.size(); ++i) {
        const auto row = static_cast<size_t>(arrivals[i]);
        const float part = arrivals[i] - static_cast<float>(row);
        const float all = 3 * (swash[row] + part * (swash[row + 1] - swash[row]));
        const float rises = 3 * (swash[row] - swash[row + 1]); // rows go back in time
        held += all < lowest ? 1 : 0;
        EXPECT_NEAR(edge[i].x, std::max(all, lowest), 1e-5f) << arrivals[i];
        EXPECT_NEAR(edge[i].y, all > lowest ? -rises : 0.0f, 1e-5f) << arrivals[i];
        EXPECT_NEAR(edge[i].z, all > lowest ? rises : 0.0f, 1e-5f) << arrivals[i];
    }
    EXPECT_GT(held, 3u);
    EXPECT_LT(held, arrivals.size() - 3);
}

TEST_F(WaterFunctions, PatchesOfFacetsVaryTogetherAsTheSlopesDo) {
    struct Place {
        glm::vec4 calm, covariance;
    };
    for (const float both : {-0.025f, 0.0f, 0.025f}) {
        const glm::vec4 covariance(0.04f, 0.03f, both, 0);
        std::vector<Place> places;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                places.push_back(
                    {0.11f * glm::vec4(static_cast<float>(x), static_cast<float>(y), 0, 0), covariance});
        glm::dvec3 sum(0);
        for (const glm::vec4& tilted : told(glitter_patches_comp, places))
            sum += glm::dvec3(tilted.x * tilted.x + tilted.z, tilted.y * tilted.y + tilted.w,
                              tilted.x * tilted.y);
        sum /= static_cast<double>(places.size());
        EXPECT_NEAR(sum.x, 0.04, 0.004) << both;
        EXPECT_NEAR(sum.y, 0.03, 0.003) << both;
        EXPECT_NEAR(sum.z, both, 0.003) << both;
    }
}

/// `b.w` says which of a shader's functions is asked.
struct Ask {
    glm::vec4 a, b;
};

double gaussian(double x) {
    return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
}

/// The mean over unit Gaussian slopes, each as large as it is seen where facets at `edgeOn` are edge on.
template<class Value>
double meanSeen(double edgeOn, const Value& value) {
    double sum = 0, all = 0;
    for (double x = -6; x < std::min(edgeOn, 6.0); x += 1e-3) {
        const double weight = gaussian(x) * (edgeOn - x);
        sum += weight * value(x);
        all += weight;
    }
    return sum / all;
}

// From above they are a Gaussian's, edge on Rayleigh's: mean, deviation and how lopsided they are.
TEST_F(WaterFunctions, SlopesLookedAtAreThoseThatAreSeen) {
    std::vector<Ask> asked;
    for (const float edgeOn : {0.0f, 0.5f, 1.0f, 2.0f, 4.0f, 8.0f}) asked.push_back({{edgeOn, 0, 0, 0}, {}});
    const std::vector<glm::vec4> moments = told(surface_light_comp, asked);
    for (size_t i = 0; i < asked.size(); ++i) {
        const double edgeOn = double{asked[i].a.x};
        const auto moment = [&](int n) { return meanSeen(edgeOn, [&](double x) { return std::pow(x, n); }); };
        const auto lopsided = [](double m, double m2, double m3) { return m3 - 3 * m * m2 + 2 * m * m * m; };
        const glm::dvec4 looked(moments[i]);
        EXPECT_NEAR(looked.x, moment(1), 0.01) << edgeOn;
        EXPECT_NEAR(looked.y - looked.x * looked.x, moment(2) - moment(1) * moment(1), 0.02) << edgeOn;
        EXPECT_NEAR(lopsided(looked.x, looked.y, looked.z), lopsided(moment(1), moment(2), moment(3)), 0.04)
            << edgeOn;
    }
}

TEST_F(WaterFunctions, SlopesAcrossAreNotThoseAlong) {
    std::vector<Ask> asked;
    for (int i = 0; i < 16; ++i) {
        const float turn = 0.4f * static_cast<float>(i);
        asked.push_back({{0.04f, 0.01f, 0.012f, 0}, {std::cos(turn), std::sin(turn), 0, 1}});
    }
    const std::vector<glm::vec4> across = told(surface_light_comp, asked);
    for (size_t i = 0; i < asked.size(); ++i) {
        const auto &c = asked[i].a, &t = asked[i].b;
        EXPECT_NEAR(across[i].x * across[i].x, t.y * t.y * c.x + t.x * t.x * c.y - 2 * t.x * t.y * c.z,
                    1e-5f);
    }
}

// As long as many rays meet some, the mean of Fresnel's share over the facets that show themselves to these.
TEST_F(WaterFunctions, OtherWavesMirrorAsMuchAsTheFacetsThatRaysMeet) {
    std::vector<Ask> asked;
    for (const float deviation : {0.1f, 0.2f, 0.35f})
        for (const float steepness : {0.1f, 0.5f, 1.0f}) {
            const float up = std::atan(steepness * deviation);
            asked.push_back({{std::cos(up), std::sin(up), 0, 0}, {deviation, 0, 0, 2}});
        }
    const std::vector<glm::vec4> kept = told(surface_light_comp, asked);
    for (size_t i = 0; i < asked.size(); ++i) {
        const glm::dvec3 back = -glm::dvec3(asked[i].a);
        const double deviation = double{asked[i].b.x}, edgeOn = back.y / -back.x / deviation;
        const double mirrored = meanSeen(edgeOn, [&](double x) {
            const glm::dvec3 facet = glm::normalize(glm::dvec3(x * deviation, 1, 0));
            return reflectance(glm::dot(back, facet));
        });
        EXPECT_NEAR(kept[i].x, mirrored, 0.04) << deviation << ", " << asked[i].a.y;
    }
}

// All facets that are seen mirror light from somewhere: without Fresnel's share, and over all places of the
// sun, one.
TEST_F(WaterFunctions, GlintsSendOnAllOfTheLight) {
    for (const double deviation : {0.1, 0.2, 0.3}) {
        const glm::dvec3 toEye(std::cos(1.25), std::sin(1.25), 0);
        std::vector<Ask> asked;
        std::vector<double> weights;
        const double step = deviation / 8;
        for (int y = -36; y <= 36; ++y)
            for (int x = -36; x <= 36; ++x) {
                const glm::dvec3 facet = glm::normalize(glm::dvec3(x * step, 1, y * step));
                const double cosine = glm::dot(facet, toEye);
                if (cosine <= 0) continue;
                asked.push_back(
                    {glm::vec4(2 * cosine * facet - toEye, 0), glm::vec4(deviation, toEye.x, toEye.y, 3)});
                const double turned = 4 * cosine * std::pow(facet.y, 3) * step * step;
                weights.push_back(turned / reflectance(cosine));
            }
        const std::vector<glm::vec4> glints = told(surface_light_comp, asked);
        double sum = 0;
        for (size_t i = 0; i < asked.size(); ++i) sum += weights[i] * double{glints[i].x};
        EXPECT_NEAR(sum, 1, 0.02) << deviation; // of steep slopes some mirror what is under the horizon
    }
}

// A wave ten metres ahead hides the sun from where its light would enter a crest.
TEST_F(WaterFunctions, WavesCastShadowsOnCrests) {
    const auto lightPast = [&](float high) {
        std::vector<Ask> asked;
        for (int i = 1; i < 60; ++i) {
            const float up = 0.01f * static_cast<float>(i);
            asked.push_back({{std::cos(up), std::sin(up), 0, 0}, {0.1f, high, 0, 4}});
        }
        return told(surface_light_comp, asked);
    };
    const std::vector<glm::vec4> clear = lightPast(0);
    for (const float high : {1.0f, 3.0f}) {
        const std::vector<glm::vec4> past = lightPast(high);
        for (size_t i = 0; i < past.size(); ++i) {
            const float risesTo = 10 * std::tan(0.01f * static_cast<float>(i + 1));
            ASSERT_GT(clear[i].x, 0.1f);
            if (risesTo < 0.85f * high) {
                EXPECT_EQ(past[i].x, 0) << risesTo;
            } else if (risesTo > 1.15f * high) {
                EXPECT_EQ(past[i].x, clear[i].x) << risesTo;
            }
        }
    }
}

// However much of the pattern is blurred away.
TEST_F(WaterFunctions, WhiteIsAsMuchOfTheSurfaceAsItsCover) {
    for (const float wide : {0.01f, 0.5f, 3.0f, 10.0f})
        for (const float cover : {0.03f, 0.3f, 0.9f}) {
            std::vector<Ask> asked;
            for (int i = 0; i < 64 * 64; ++i) {
                const auto x = static_cast<float>(i % 64), y = static_cast<float>(i / 64);
                asked.push_back({{1.37f * x + 1, 1.71f * y + 1, wide, 0}, {cover, 0, 0, 0}});
            }
            double mean = 0;
            for (const glm::vec4& white : told(foam_parts_comp, asked)) mean += double{white.x} / (64 * 64);
            EXPECT_NEAR(mean, cover, 0.006) << wide;
        }
}

TEST_F(WaterFunctions, PartsOfThePatternThatMeetKeepItsContrast) {
    for (const float share : {0.0f, 0.2f, 0.5f}) {
        std::vector<Ask> asked;
        for (int i = 0; i < 64 * 64; ++i) {
            const auto x = static_cast<float>(i % 64), y = static_cast<float>(i / 64);
            asked.push_back({{x + 0.37f, y + 0.71f, x + 100.37f, y + 200.3f}, {share, 0, 0, 1}});
        }
        double squares = 0;
        for (const glm::vec4& texel : told(foam_parts_comp, asked))
            squares += double{texel.x * texel.x} / (64 * 64);
        EXPECT_NEAR(12 * squares, 1, 0.04) << share; // an even distribution's
    }
}

TEST_F(WaterFunctions, NoFoamLiesWhereTheWatersEdgeStandsStill) {
    std::vector<Ask> asked;
    for (const float moves : {1.0f, 0.0f})
        for (const float thick : {-0.02f, 0.01f, 0.03f, 0.1f})
            asked.push_back({{thick, 0.1f, 1, moves}, {0, 0, 0, 2}});
    const std::vector<glm::vec4> cover = told(foam_parts_comp, asked);
    for (size_t i = 0; i < asked.size(); ++i) {
        if (asked[i].a.w > 0) {
            EXPECT_GT(cover[i].x, 0.1f) << asked[i].a.x;
        } else {
            EXPECT_EQ(cover[i].x, 0) << asked[i].a.x;
        }
    }
}

// From afar a mean of them is drawn. Near by their toe is bent.
TEST_F(WaterFunctions, RollersAreAsWhiteAsTheirMean) {
    constexpr int places = 1024;
    for (const float broken : {0.3f, 0.6f, 1.0f}) {
        std::vector<Ask> asked;
        for (int i = 0; i < places; ++i) {
            const float turns = static_cast<float>(i) / places - 2;
            asked.push_back({{broken, turns, 1, 0}, {0, 0, 0, 3}});
        }
        for (const float bend : {-1.0f, 0.0f, 1.0f})
            asked.push_back({{broken, 0.02f, 1, bend}, {0, 0, 0, 3}});
        asked.push_back({{broken, 0, 0, 0}, {0, 0, 0, 3}});
        const std::vector<glm::vec4> cover = told(foam_parts_comp, asked);
        double mean = 0;
        for (int i = 0; i < places; ++i) mean += double{cover[i].x} / places;
        EXPECT_NEAR(mean, double{cover.back().x}, 0.003) << broken;
        EXPECT_LT(cover[places].x, 0.1f) << broken; // it has not come yet
        EXPECT_GT(cover[places + 1].x, 0.5f) << broken;
        EXPECT_EQ(cover[places + 1].x, cover[places + 2].x) << broken;
    }
}

TEST_F(WaterFunctions, WarpedWavesChangeAsTheirPlacesDo) {
    constexpr float step = 0.25f;
    const glm::vec4 slope(0.3f, -0.2f, 0, 0);
    std::vector<Ask> asked;
    for (int i = 0; i < 200; ++i) {
        const glm::vec4 at(7.3f * static_cast<float>(i) - 600, 400 - 5.1f * static_cast<float>(i), 0, 0);
        for (const glm::vec4& off : {glm::vec4(0), glm::vec4(step, 0, 0, 0), glm::vec4(-step, 0, 0, 0),
                                     glm::vec4(0, step, 0, 0), glm::vec4(0, -step, 0, 0)})
            asked.push_back({at + off, slope});
    }
    const std::vector<glm::vec4> warped = told(surface_waves_comp, asked);
    for (size_t i = 0; i < asked.size(); i += 5) {
        const auto height = [&](size_t j) { return warped[i + j].x * slope.x + warped[i + j].y * slope.y; };
        const float u = (height(1) - height(2)) / (2 * step), v = (height(3) - height(4)) / (2 * step);
        EXPECT_NEAR(warped[i].z, u, 2e-3f) << i;
        EXPECT_NEAR(warped[i].w, v, 2e-3f) << i;
    }
}

TEST_F(WaterFunctions, PartsOfAPixelLieAroundItsMiddle) {
    std::vector<Ask> asked;
    for (int i = 0; i < 8; ++i) {
        const auto at = static_cast<float>(i);
        asked.push_back({{10 - at, 3 * at, 4, at - 4}, {0, 0, 0, 1}});
    }
    const std::vector<glm::vec4> mean = told(surface_waves_comp, asked);
    for (size_t i = 0; i < asked.size(); ++i) {
        EXPECT_NEAR(mean[i].x, 1e-3f * asked[i].a.x, 1e-6f);
        EXPECT_NEAR(mean[i].y, 1e-3f * asked[i].a.y, 1e-6f);
    }
}

// Waves of half the height have half the slopes, and a quarter of the variance.
TEST_F(WaterFunctions, SlopesThatAShoreLeavesVaryByTheSquareOfItsWaves) {
    std::vector<Ask> asked;
    for (const float kept : {1.0f, 0.7f, 0.3f, 0.0f}) asked.push_back({{kept, 0, 0, 0}, {0, 0, 0, 2}});
    const std::vector<glm::vec4> covariance = told(surface_waves_comp, asked);
    EXPECT_GT(covariance[0].x, 0.04f);
    for (size_t i = 0; i < asked.size(); ++i)
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(covariance[i][k], asked[i].a.x * asked[i].a.x * covariance[0][k], 1e-6f)
                << asked[i].a.x;
}

TEST_F(WaterFunctions, TexelsOfLightStandForTheirMiddles) {
    std::vector<glm::ivec4> texels;
    for (int step = 1; step <= 4; ++step)
        for (int i = -3; i < 9; ++i) texels.emplace_back(i, 2 * i + 1, step, 0);
    const std::vector<glm::vec4> pixels = told(caustic_texels_comp, texels);
    for (size_t i = 0; i < texels.size(); ++i) {
        const auto middle = [&](int texel) {
            return (static_cast<float>(texel) + 0.5f) * static_cast<float>(texels[i].z);
        };
        EXPECT_LE(std::abs(pixels[i].x + 0.5f - middle(texels[i].x)), 0.5f) << texels[i].z;
        EXPECT_LE(std::abs(pixels[i].y + 0.5f - middle(texels[i].y)), 0.5f) << texels[i].z;
    }
}

// rays_over_sand.comp's wall stands twelve metres ahead, up to 2.5 m over the sand. Its radiance is its
// place.
TEST_F(WaterFunctions, RaysMeetWhatStandsOnABeachWhereItStands) {
    struct FromTo {
        glm::vec4 from, along;
    };
    std::vector<FromTo> rays;
    for (const float from : {-5.0f, -8.0f, -11.0f})
        for (int i = 0; i < 12; ++i) {
            const auto rise = 0.1f * static_cast<float>(i) + 0.05f;
            rays.push_back({{0.5f, -4, from, 1}, glm::vec4(glm::normalize(glm::vec3(0.1f, rise, -1)), 0)});
        }
    const std::vector<glm::vec4> met = told(rays_over_sand_comp, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        const glm::vec4 &from = rays[i].from, &along = rays[i].along;
        const float height = from.y + along.y * (from.z + 12) / -along.z;
        if (height > -1.3f) {
            EXPECT_EQ(met[i].w, 0) << from.z << ", " << height;
        } else if (height < -1.7f) {
            EXPECT_EQ(met[i].w, 1) << from.z << ", " << height;
            EXPECT_NEAR(met[i].y, height, 0.12f) << from.z; // a pixel of the wall
        }
    }
}

/// In pinhole.glsl's picture.
glm::dvec3 sightOf(const glm::dvec2& pixel) {
    return glm::normalize(glm::dvec3(pixel.x / 100 - 1, 1 - pixel.y / 100, -1));
}

/// Whether a ray that a facet turns shows, in the mirror, what lies within a box of that picture.
bool mirrors(const glm::ivec4& box, const glm::dvec2& pixel, const glm::dvec2& slope) {
    const glm::dvec3 sight = sightOf(pixel), facet = glm::normalize(glm::dvec3(slope.x, 1, slope.y));
    const glm::dvec3 ray = glm::reflect(sight, facet), from = sight * (-4 / sight.y);
    for (double t = 0.05; t < 1e4; t *= 1.2) {
        const glm::dvec3 at = from + t * glm::dvec3(ray.x, -std::abs(ray.y), ray.z);
        const glm::dvec2 shown(100 - 100 * at.x / at.z, 100 + 100 * at.y / at.z);
        if (at.z < 0 && shown.x > box.x && shown.y > box.y && shown.x < box.z && shown.y < box.w) return true;
    }
    return false;
}

/// As tile_needs.comp is asked.
struct Tile {
    glm::uvec4 box;
    glm::vec4 first;
    glm::ivec4 hit;
};

TEST_F(WaterFunctions, ATileMirrorsWhatAnyOfItsTexelsDoes) {
    std::vector<Tile> tiles;
    for (const int scale : {1, 2, 4, 8})
        for (int y = 0; y < 24; y += scale)
            for (int x = 0; x < 24; x += scale)
                tiles.push_back({glm::uvec4(0), {8, 8, 0.1f, 0}, {x / scale, y / scale, scale, 0}});
    const std::vector<glm::vec4> needs = told(tile_needs_comp, tiles);
    for (size_t i = 0; i < tiles.size(); ++i) {
        const glm::ivec4& hit = tiles[i].hit;
        const bool isInTile = hit.x * hit.z / 8 == 1 && hit.y * hit.z / 8 == 1;
        EXPECT_EQ(needs[i].z != 0, isInTile) << hit.x << "," << hit.y << " of " << hit.z;
    }
}

TEST_F(WaterFunctions, TilesThatMayMirrorSomethingLookForIt) {
    size_t needed = 0, spared = 0, wrong = 0;
    for (const float deviation : {0.02f, 0.06f, 0.12f})
        for (const glm::ivec4& box :
             {glm::ivec4(90, 104, 110, 130), glm::ivec4(4, 110, 20, 120), glm::ivec4(150, 180, 190, 196)}) {
            std::vector<Tile> tiles;
            for (int y = 104; y < 200; y += 8)
                for (int x = 0; x < 200; x += 8)
                    tiles.push_back(
                        {glm::uvec4(~box.x, ~box.y, box.z, box.w), {x, y, deviation, 0}, {0, 0, 1, 0}});
            const std::vector<glm::vec4> needs = told(tile_needs_comp, tiles);
            for (size_t i = 0; i < tiles.size(); ++i) {
                bool mirrorsBox = false;
                for (int k = 0; k < 24 && !mirrorsBox; ++k) {
                    const double lean = double{deviation} * (k % 3 + 1), turn = 2.4 * k;
                    const glm::dvec2 pixel =
                        glm::dvec2(tiles[i].first) + glm::dvec2(k % 8 + 0.5, k / 8 + 0.5);
                    mirrorsBox = mirrors(box, pixel, lean * glm::dvec2(std::cos(turn), std::sin(turn)));
                }
                wrong += mirrorsBox && needs[i].x == 0;
                needed += mirrorsBox;
                spared += needs[i].x == 0;
            }
        }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(needed, 400u);
    EXPECT_GT(spared, 1400u);
}

// Of what a slope within the pixel moves a bent ray by, the mean's way is no part: it blurs nothing.
TEST_F(WaterFunctions, ABedIsBlurredByHowRaysStrayFromTheirMean) {
    std::vector<Ask> asked;
    for (const float deviation : {0.0f, 0.02f, 0.1f})
        for (const float up : {0.3f, 0.7f, 1.2f})
            for (const float slope : {0.0f, 0.1f})
                asked.push_back({{std::cos(up), std::sin(up), 0, deviation}, {slope, -slope, 0, 0}});
    const std::vector<glm::vec4> strays = told(bent_rays_comp, asked);
    for (size_t i = 0; i < asked.size(); ++i) {
        const auto bent = [&](const glm::dvec2& more) {
            const glm::dvec2 slope = glm::dvec2(asked[i].b) + double{asked[i].a.w} * more;
            const glm::dvec3 facet = glm::normalize(glm::dvec3(-slope.x, 1, -slope.y));
            const glm::dvec3 ray = glm::refract(-glm::dvec3(asked[i].a), facet, 1 / waterIndex);
            return glm::dvec2(ray.x, ray.z) / -ray.y;
        };
        const glm::dvec2 mean = bent({0, 0});
        const glm::dvec4 expected(bent({1, 0}) - mean, bent({0, 1}) - mean);
        EXPECT_LT(glm::length(glm::dvec4(strays[i]) - expected), 1e-4) << i;
    }
}

// bent_rays.comp's wall lies 0.8 m under the water, left of a column; all else is bed.
TEST_F(WaterFunctions, BentRaysPassBehindEdges) {
    const glm::vec4 left(-0.5f, -1, -0.3f, 2); // and how deep it is at the end
    const auto asked = [&](float bed, float wallEnds) { return Ask{left, {bed, 0.8f, wallEnds, 1}}; };
    const std::vector<glm::vec4> met =
        told(bent_rays_comp, std::vector<Ask>{asked(1.5f, -1000), asked(3, 96), asked(3, 92), asked(3, 88)});
    EXPECT_EQ(met[0].x, 1);             // the bed
    EXPECT_NEAR(met[0].y, 1.5f, 0.07f); // halved five times
    EXPECT_EQ(met[1].x, 1);             // the top of the wall
    EXPECT_NEAR(met[1].y, 0.8f, 0.07f);
    EXPECT_EQ(met[2].x, 0); // it is deeper than that where it comes to the wall
    EXPECT_EQ(met[3].x, 0);
}

} // namespace
