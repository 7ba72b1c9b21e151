// Sunlight that waves gather: none of it is made or lost, and it falls where geometry says.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/reference/box_world.h"
#include "tests/reference/traced_picture.h"
#include "tests/unit/sea/statistics.h"

namespace {

using namespace demos;
using tests::Box;
using tests::deviationOf;
using tests::meanOf;

/// From straight above, so that the sides of the water seen are `metres`, under a sun over +X.
struct Bath {
    double depth = 1, elevationDeg = 60, metres = 4;
    std::vector<Box> things;
    WavesDesc waves = ripples();
    uint64_t seed = 1;
    uint32_t pixels = 120, samples = 16, threads = 0;

    static WavesDesc ripples() {
        WavesDesc waves;
        waves.windMps = 5;
        waves.fetchM = 2e3;
        waves.samples = 128;
        waves.largestPatchM = 16;
        waves.warp = 0;
        return waves;
    }
};

/// Ready to be asked how much light falls where.
class Lit {
  public:
    explicit Lit(const Bath& bath) : depth_(bath.depth), metres_(bath.metres) {
        SunDesc sun;
        sun.azimuthDeg = 0;
        sun.elevationDeg = bath.elevationDeg;
        sun.irradiance = {10, 10, 10};
        Error error;
        EXPECT_TRUE(reference::makeLight(tests::evenSky(glm::vec3(0)), {}, sun, world_.light, error))
            << error.text;
        std::vector<Box> boxes = bath.things;
        boxes.push_back({{-30, -bath.depth - 1, -30}, {30, -bath.depth, 30}});
        tests::addMesh("bed", tests::shiningBoxes(boxes, glm::vec3(0)), world_);
        WaterDesc water;
        water.refraction = RefractionDesc{};
        water.waves = bath.waves;
        EXPECT_TRUE(reference::setWater(water, world_, error)) << error.text;
        reference::FrameDesc desc;
        desc.width = desc.height = bath.pixels;
        desc.camera.positionM = {0, 20, 0.01};
        desc.camera.targetM = {0, 0, 0};
        desc.camera.verticalFovDeg = 2 * std::atan(bath.metres / 2 / 20) * 180 / std::numbers::pi;
        desc.timeS = 2;
        desc.samples = bath.samples;
        desc.seed = bath.seed;
        desc.threads = bath.threads;
        EXPECT_TRUE(reference::prepareFrame(world_, desc, frame_, error)) << error.text;
        from_ = reference::enteringBeam(world_.light.toSun(), glm::vec3(0)).from;
    }
    const reference::Frame& frame() const { return frame_; }

    /// On the bed.
    double at(double x, double z) const {
        const glm::vec3 place(glm::dvec3(x, -depth_, z) - frame_.camera.eye);
        const auto gain = frame_.caustics.gainAt(frame_, place, glm::vec3(0, 1, 0), from_);
        EXPECT_TRUE(gain) << x << ", " << z;
        return static_cast<double>(gain.value_or(-1));
    }
    /// Over the middle of the picture.
    std::vector<double> field(int across = 100) const {
        std::vector<double> gains;
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
                gains.push_back(at(0.8 * metres_ * ((i + 0.5) / across - 0.5),
                                   0.8 * metres_ * ((j + 0.5) / across - 0.5)));
        return gains;
    }

  private:
    double depth_, metres_;
    reference::World world_;
    reference::Frame frame_;
    glm::vec3 from_{0, 1, 0};
};

/// Root of the mean square between two fields, a share of their mean.
double noiseOf(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> apart;
    for (size_t i = 0; i < a.size(); ++i) apart.push_back(a[i] - b[i]);
    return std::hypot(deviationOf(apart), meanOf(apart)) / std::sqrt(2.0) / meanOf(a);
}

/// Over a patch that the sea repeats.
TEST(TracedCaustics, TakeAsMuchLightAsTheyGive) {
    for (const double depth : {0.5, 3.0}) {
        Bath bath;
        bath.depth = depth;
        bath.metres = bath.waves.largestPatchM / 0.8;
        const std::vector<double> gains = Lit(bath).field();
        std::printf("%.1f m: mean %.4f, deviation %.3f\n", depth, meanOf(gains), deviationOf(gains));
        EXPECT_NEAR(meanOf(gains), 1, 0.01) << depth;
        EXPECT_GT(deviationOf(gains), 0.09) << depth; // 0.097 at half a metre
    }
}

TEST(TracedCaustics, HaveLittleNoise) {
    Bath bath;
    bath.depth = 2;
    const std::vector<double> some = Lit(bath).field();
    bath.seed = 2;
    const double noise = noiseOf(some, Lit(bath).field());
    std::printf("noise %.4f, deviation %.3f\n", noise, deviationOf(some));
    EXPECT_LT(noise, 0.12);
}

TEST(TracedCaustics, AreTheSameOfAnyNumberOfThreads) {
    Bath bath;
    bath.samples = 4;
    bath.threads = 1;
    const std::vector<double> alone = Lit(bath).field();
    bath.threads = 2;
    EXPECT_EQ(alone, Lit(bath).field());
}

/// One train of waves along x, each half a metre long.
class OneWave : public testing::Test {
  protected:
    static constexpr double length = 0.5, curl = 2 * std::numbers::pi / length;

    void SetUp() override {
        const std::filesystem::path table = std::filesystem::path(testing::TempDir()) / "one_wave.csv";
        const double hertz = std::sqrt(9.81 * curl) / (2 * std::numbers::pi);
        std::ofstream(table) << 0.99 * hertz << ", 0.001\n" << 1.01 * hertz << ", 0.001\n";
        bath_.waves = {};
        bath_.waves.spectrum = "table";
        bath_.waves.spectrumTable = table;
        bath_.waves.spreading = "cos2s";
        bath_.waves.spreadingShape = 1000;
        bath_.waves.samples = 128;
        bath_.waves.cascades = 1;
        bath_.waves.largestPatchM = 4 * length;
        bath_.waves.warp = 0;
        bath_.waves.choppiness = 0;
        bath_.elevationDeg = 90;
        bath_.metres = 1.2;
        bath_.pixels = 1; // for waves alone, which no light is traced through
        bath_.waves.amplitude = height_ / crestOf(Lit(bath_)).y;
        crest_ = crestOf(Lit(bath_)).x;
        bath_.pixels = 200;
    }
    /// Where along x, nearest to the middle, and how high.
    static glm::dvec2 crestOf(const Lit& lit) {
        glm::dvec2 best(0);
        for (double x = -length / 2; x < length / 2; x += 1e-3) {
            const auto height = static_cast<double>(lit.frame().surface.displacement({x, 0.1}, 0).y);
            if (height > best.y) best = {x, height};
        }
        EXPECT_NEAR(static_cast<double>(lit.frame().surface.displacement({best.x, 0.7}, 0).y), best.y,
                    1e-3 * best.y);
        return best;
    }
    Lit bedAt(double depth) {
        bath_.depth = depth;
        return Lit(bath_);
    }
    /// Along the line below the crest, `aside` of it.
    double along(const Lit& bed, double aside) const {
        double sum = 0;
        constexpr int places = 40;
        for (int i = 0; i < places; ++i) sum += bed.at(crest_ + aside, 0.02 * (i - places / 2)) / places;
        return sum;
    }

    Bath bath_;
    double height_ = 0.01, crest_ = 0;
    /// A lens whose radius is that of the crest: n r / (n - 1).
    double focus_ = 1.333 / 0.333 / (height_ * curl * curl);
};

TEST_F(OneWave, GathersAsALensDoes) {
    for (const double share : {0.25, 0.5}) {
        const double depth = share * focus_;
        const double crest = 1 / (1 - (depth + height_) / focus_),
                     trough = 1 / (1 + (depth - height_) / focus_);
        const Lit bed = bedAt(depth);
        const double atCrest = along(bed, 0), atTrough = along(bed, length / 2);
        std::printf("%.2f m: crest %.3f of %.3f, trough %.3f of %.3f\n", depth, atCrest, crest, atTrough,
                    trough);
        EXPECT_NEAR(atCrest, crest, 0.06 * crest) << depth;
        EXPECT_NEAR(atTrough, trough, 0.06 * trough) << depth;
    }
}

/// Rays from both sides of the crest meet below it at the focus, and at three times that depth lie between
/// two lines.
TEST_F(OneWave, DrawsLinesWhereItsRaysCross) {
    const Lit inFocus = bedAt(focus_);
    const double atFocus = along(inFocus, 0), before = along(bedAt(0.8 * focus_), 0),
                 beside = along(inFocus, 0.05);
    std::printf("%.2f m: %.2f, before it %.2f, beside %.2f\n", focus_, atFocus, before, beside);
    EXPECT_GT(atFocus, 1.2 * before);
    EXPECT_GT(atFocus, 3 * beside);
    // As angles of the wave, x - 3 sin x turns back where cos x is a third, and has three roots.
    const double turns = std::acos(1.0 / 3), line = (3 * std::sin(turns) - turns) / curl, root = 2.27886;
    const double between = 0.5 + 2 / (1 - 3 * std::cos(root));
    const Lit beyond = bedAt(3 * focus_);
    const double atLine = along(beyond, line - 0.02), middle = along(beyond, 0),
                 outside = along(beyond, line + 0.07);
    std::printf("three times as deep: %.2f at the line, %.2f of %.2f between, %.2f outside\n", atLine, middle,
                between, outside);
    EXPECT_NEAR(middle, between, 0.15 * between);
    EXPECT_GT(atLine, middle);
    EXPECT_LT(outside, 0.5 * middle);
}

/// A board over the water, and one in it.
TEST(TracedCaustics, LeaveShadowsWhereTheBentSunPutsThem) {
    Bath bath;
    bath.elevationDeg = 40;
    bath.waves.amplitude = 0.1;
    bath.metres = 6;
    bath.things = {{{0.5, 0.5, -5}, {5, 0.6, 0}}, {{-5, -0.6, 0}, {0, -0.5, 5}}};
    const Lit lit(bath);
    const double inAir = 1 / std::tan(40 * std::numbers::pi / 180);
    const double sine = std::cos(40 * std::numbers::pi / 180) / 1.333,
                 inWater = sine / std::sqrt(1 - sine * sine);
    for (const auto& [edge, z, darkAbove] :
         {std::tuple(0.5 - 0.6 * inAir - inWater, -1.0, true), std::tuple(-0.4 * inWater, 1.0, false)}) {
        const auto mean = [&, z = z](double x) {
            double sum = 0;
            for (int i = 0; i < 40; ++i) sum += lit.at(x, z + 0.02 * (i - 20)) / 40;
            return sum;
        };
        const double dark = darkAbove ? 0.08 : -0.08;
        std::printf("edge at %.3f: %.3f, %.3f, %.3f\n", edge, mean(edge + dark), mean(edge),
                    mean(edge - dark));
        EXPECT_LT(mean(edge + dark), 0.1) << z;
        EXPECT_GT(mean(edge - dark), 0.8) << z;
        EXPECT_NEAR(mean(edge), 0.5, 0.25) << z;
    }
}

} // namespace
