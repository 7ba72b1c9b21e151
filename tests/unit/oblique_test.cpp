// The oblique near plane: what it keeps, what it clips and what it leaves alone, for any camera, plane and
// depth convention.
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/matrix.hpp>

#include "gpu/view/oblique.h"
#include "reflection/core/mirror.h"
#include "tests/unit/cameras.h"

namespace {

using namespace seaglass;
using tests::Camera;

struct Convention {
    bool reversed = true;
    double far = 0; ///< 0: infinite
    bool flippedY = false;
    bool offCentre = false;
};

std::vector<Convention> everyConvention() {
    std::vector<Convention> all;
    for (const bool reversed : {true, false})
        for (const double far : {0.0, 2000.0})
            for (const bool flippedY : {false, true})
                for (const bool offCentre : {false, true})
                    all.push_back({reversed, far, flippedY, offCentre});
    return all;
}

std::string nameOf(const Convention& c) {
    return std::string(c.reversed ? "reversed" : "forward") + ", far " + std::to_string(c.far) +
           (c.flippedY ? ", y up" : "") + (c.offCentre ? ", off-centre" : "");
}

/// A mirror seen by a camera under it: the mirrored view's situation.
struct Situation {
    glm::dmat4 projection{1};
    glm::dvec4 plane{0}; ///< view space, unit normal, negative at the eye
};

class Chance {
  public:
    double between(double low, double high) { return low + (high - low) * share(); }
    double logarithmic(double low, double high) { return low * std::pow(high / low, share()); }
    bool either() { return share() < 0.5; }

  private:
    /// std::uniform_real_distribution is not the same everywhere.
    double share() { return static_cast<double>(engine_()) / 4294967296.0; }
    std::mt19937 engine_{20260731};
};

glm::dmat4 projectionOf(const Convention& convention, double near, double fovDegrees, Chance& chance) {
    Camera camera;
    camera.near = near;
    camera.far = convention.far;
    camera.reversed = convention.reversed;
    camera.fovDegrees = fovDegrees;
    glm::dmat4 p = tests::projectionMatrix(camera);
    if (convention.flippedY) p[1][1] = -p[1][1];
    if (convention.offCentre) {
        p[2][0] = chance.between(-0.6, 0.6);
        p[2][1] = chance.between(-0.6, 0.6);
    }
    return p;
}

/// Planes that some ray of the view meets.
Situation randomSituation(const Convention& convention, Chance& chance) {
    Situation s;
    const double near = chance.logarithmic(0.01, 1);
    s.projection = projectionOf(convention, near, chance.between(10, 130), chance);
    glm::dvec3 normal;
    do {
        normal = {chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1)};
    } while (!(glm::length(normal) > 0.1) || -normal.z < 0.05 * glm::length(normal));
    s.plane = glm::dvec4(glm::normalize(normal), -near * chance.logarithmic(0.2, 300));
    return s;
}

/// A point of the picture at a distance along the view axis.
glm::dvec4 pointAt(const glm::dmat4& projection, const glm::dvec2& ndc, double distance) {
    const glm::dmat4 inverse = glm::inverse(projection);
    glm::dvec4 through = inverse * glm::dvec4(ndc, 0.5, 1);
    through /= through.w;
    return {glm::dvec3(through) * (distance / -through.z), 1};
}

double depthOf(const glm::dvec4& clip) {
    return clip.z / clip.w;
}

constexpr int situations = 200;
constexpr int pointsEach = 50;

TEST(Oblique, KeepsOneSideOfThePlaneAndClipsTheOther) {
    for (const Convention& convention : everyConvention()) {
        Chance chance;
        size_t kept = 0, clipped = 0, oblique = 0;
        for (int i = 0; i < situations; ++i) {
            const Situation s = randomSituation(convention, chance);
            const ObliqueProjection out = obliqueProjection(s.projection, convention.reversed, s.plane);
            oblique += out.oblique;
            if (!out.oblique) continue;
            for (int k = 0; k < pointsEach; ++k) {
                const glm::dvec4 p = pointAt(s.projection, {chance.between(-1, 1), chance.between(-1, 1)},
                                             chance.logarithmic(0.01, 1999));
                const double side = glm::dot(s.plane, p);
                const glm::dvec4 clip = out.projection * p;
                const double beyondNear = convention.reversed ? 1 - depthOf(clip) : depthOf(clip);
                if (side > 1e-9) {
                    ++kept;
                    EXPECT_GE(beyondNear, 0) << nameOf(convention);
                    EXPECT_LE(beyondNear, 1 + 1e-12) << nameOf(convention);
                } else if (side < -1e-9) {
                    ++clipped;
                    EXPECT_LT(beyondNear, 0) << nameOf(convention);
                }
            }
        }
        EXPECT_GT(oblique, 0.95 * situations) << nameOf(convention);
        EXPECT_GT(kept, 1000u) << nameOf(convention);
        EXPECT_GT(clipped, 1000u) << nameOf(convention);
    }
}

TEST(Oblique, LeavesThePictureAlone) {
    for (const Convention& convention : everyConvention()) {
        Chance chance;
        for (int i = 0; i < situations; ++i) {
            const Situation s = randomSituation(convention, chance);
            const glm::dmat4 oblique =
                obliqueProjection(s.projection, convention.reversed, s.plane).projection;
            for (const int row : {0, 1, 3})
                for (int column = 0; column < 4; ++column)
                    EXPECT_EQ(oblique[column][row], s.projection[column][row]) << nameOf(convention);
        }
    }
}

TEST(Oblique, DepthStaysMonotonicAlongEveryRay) {
    for (const Convention& convention : everyConvention()) {
        Chance chance;
        for (int i = 0; i < situations; ++i) {
            const Situation s = randomSituation(convention, chance);
            const glm::dmat4 oblique =
                obliqueProjection(s.projection, convention.reversed, s.plane).projection;
            const glm::dvec2 ndc(chance.between(-1, 1), chance.between(-1, 1));
            double last = depthOf(oblique * pointAt(s.projection, ndc, 0.01));
            for (double distance = 0.02; distance < 1000; distance *= 2) {
                const double depth = depthOf(oblique * pointAt(s.projection, ndc, distance));
                EXPECT_TRUE(convention.reversed ? depth < last : depth > last)
                    << nameOf(convention) << " at " << distance;
                last = depth;
            }
        }
    }
}

TEST(Oblique, TheFarthestCornerTakesTheFarPlanesDepth) {
    for (const Convention& convention : everyConvention()) {
        Chance chance;
        const double farDepth = convention.reversed ? 0 : 1;
        for (int i = 0; i < situations; ++i) {
            const Situation s = randomSituation(convention, chance);
            const ObliqueProjection out = obliqueProjection(s.projection, convention.reversed, s.plane);
            if (!out.oblique) continue;
            double nearestToFar = 1;
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0}) {
                    // Homogeneous: at infinity where there is no far plane.
                    const glm::dvec4 corner = glm::inverse(s.projection) * glm::dvec4(x, y, farDepth, 1);
                    const double depth = depthOf(out.projection * corner);
                    nearestToFar = std::min(nearestToFar, std::abs(depth - farDepth));
                    EXPECT_TRUE(convention.reversed ? depth > -1e-9 : depth < 1 + 1e-9) << nameOf(convention);
                }
            EXPECT_NEAR(nearestToFar, 0, 1e-9) << nameOf(convention);
        }
    }
}

TEST(Oblique, AScaledPlaneIsTheSameNearPlane) {
    Chance chance;
    const Situation s = randomSituation({}, chance);
    const glm::dmat4 once = obliqueProjection(s.projection, true, s.plane).projection;
    const glm::dmat4 scaled = obliqueProjection(s.projection, true, s.plane * 400.0).projection;
    for (int column = 0; column < 4; ++column) EXPECT_NEAR(once[column][2], scaled[column][2], 1e-12);
}

/// A level mirror under an eye that looks slightly down, in units of `metre`.
Situation overWater(double height, double metre, const Convention& convention) {
    Camera camera;
    camera.eye = {0, height * metre, 10 * metre};
    camera.target = camera.eye + glm::dvec3(0, -1, -10) * metre;
    camera.near = 0.1 * metre;
    camera.far = convention.far * metre;
    camera.reversed = convention.reversed;
    const glm::dvec4 world = planeFacingEye({0, 1, 0, 0}, camera.eye);
    const glm::dmat4 view = tests::viewMatrix(camera);
    const glm::dmat4 turned = glm::dmat4(glm::dmat3(view));
    return {tests::projectionMatrix(camera), -(world * glm::inverse(turned))};
}

TEST(Oblique, CrossingThePlaneStaysFiniteAndKeepsWhatIsAbove) {
    for (const Convention& convention : {Convention{true, 0}, {true, 2000}, {false, 0}, {false, 2000}})
        for (int step = -100; step <= 100; ++step) {
            const double height = 1e-4 * step;
            const Situation s = overWater(height, 1, convention);
            const ObliqueProjection out = obliqueProjection(s.projection, convention.reversed, s.plane);
            // The eye counts as in the plane where its height is under a 64th of the near distance times the
            // steepest ray's slope: 0.9 mm from above, 0.6 mm from below.
            if (std::abs(height) < 0.55e-3 || std::abs(height) > 0.95e-3) {
                EXPECT_EQ(out.oblique, std::abs(height) > 0.95e-3) << height << " m, " << nameOf(convention);
            }
            const glm::dmat4 inverse = glm::inverse(out.projection);
            for (int i = 0; i < 16; ++i) {
                EXPECT_TRUE(std::isfinite(out.projection[i / 4][i % 4]));
                EXPECT_TRUE(std::isfinite(inverse[i / 4][i % 4]));
            }
            for (const double distance : {0.2, 3.0, 50.0, 1500.0})
                for (const double y : {-0.9, 0.0, 0.9}) {
                    const glm::dvec4 p = pointAt(s.projection, {0.3, y}, distance);
                    if (glm::dot(s.plane, p) < 1e-9) continue;
                    const double depth = depthOf(out.projection * p);
                    EXPECT_GE(depth, -1e-12) << height;
                    EXPECT_LE(depth, 1 + 1e-12) << height;
                }
        }
}

TEST(Oblique, TheSceneMayBeInAnyUnit) {
    for (const double height : {1e-4, 9e-4, 2e-3, 1.0})
        for (const double metre : {1e-3, 1e3, 1e6}) {
            const Situation s = overWater(height, 1, {});
            const Situation other = overWater(height, metre, {});
            EXPECT_EQ(obliqueProjection(s.projection, true, s.plane).oblique,
                      obliqueProjection(other.projection, true, other.plane).oblique)
                << height << " m in units of 1/" << metre << " m";
        }
}

TEST(Oblique, AViewThatLooksAwayKeepsItsProjection) {
    Chance chance;
    for (const Convention& convention : everyConvention()) {
        const glm::dmat4 projection = projectionOf(convention, 0.1, 60, chance);
        const ObliqueProjection out = obliqueProjection(projection, convention.reversed, {0, 0, 1, -2});
        EXPECT_FALSE(out.oblique);
        EXPECT_EQ(out.projection, projection);
    }
}

} // namespace
